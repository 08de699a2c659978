#pragma once

/// @file
/// Rotations of all lanes at once, as unit quaternions: whatever is composed stays a rotation.

#include "core/lanes/lane_vector.hpp"

namespace unbruised {

/// w + x i + y j + z k, of length 1.
struct LaneRotation {
  Lane w{1.0};
  LaneVector axis;  ///< times the sine of half the angle

  /// w, x, y, z.
  [[nodiscard]] std::array<double, 4> of_lane(int lane) const {
    return {w[lane], axis[0][lane], axis[1][lane], axis[2][lane]};
  }
  /// The matrix R of y = R x.
  [[nodiscard]] LaneMatrix matrix() const {
    const Lane &x = axis[0], &y = axis[1], &z = axis[2], one(1.0), two(2.0);
    return {{one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y),  //
             two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x),  //
             two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)}};
  }
};

/// First `second`, then `first`: the matrix of the result is that of `first` times that of `second`.
inline LaneRotation operator*(const LaneRotation& first, const LaneRotation& second) {
  const Lane w = first.w * second.w - dot(first.axis, second.axis);
  const LaneVector axis = first.w * second.axis + second.w * first.axis + cross(first.axis, second.axis);
  const Lane inverse = Lane(1.0) / sqrt(w * w + dot(axis, axis));
  return {inverse * w, inverse * axis};
}

/// exp[v]: the rotation about v by |v|, right to rounding up to 3 rad.
/// sin(x) / x and cos(x) of half the angle by their series: no branch, and the same bits on every machine.
inline LaneRotation rotation_by(const LaneVector& vector_rad) {
  constexpr int kTerms = 12;
  const Lane square = Lane(0.25) * dot(vector_rad, vector_rad);
  Lane cosine(1.0), sine(1.0);
  for (int k = kTerms; k > 0; --k) {
    cosine = Lane(1.0) - cosine * square * Lane(1.0 / ((2.0 * k) * (2.0 * k - 1.0)));
    sine = Lane(1.0) - sine * square * Lane(1.0 / ((2.0 * k) * (2.0 * k + 1.0)));
  }
  // The product takes the length back to 1.
  return LaneRotation{cosine, Lane(0.5) * sine * vector_rad} * LaneRotation{};
}

/// The vector v of exp[v] of small rotations, right to rounding below 0.1 rad.
inline LaneVector small_rotation_rad(const LaneRotation& rotation) {
  // asin(s) / s of the sine of half the angle, by its series; -q is the same rotation as q.
  const Lane square = dot(rotation.axis, rotation.axis);
  const Lane ratio =
      Lane(1.0) +
      square * (Lane(1.0 / 6.0) +
                square * (Lane(3.0 / 40.0) + square * (Lane(15.0 / 336.0) + square * Lane(105.0 / 3456.0))));
  return select(rotation.w < Lane(0.0), Lane(-2.0), Lane(2.0)) * ratio * rotation.axis;
}

/// The rotation Q of A = Q P with a symmetric P, by Newton's method from Q = 1; right to rounding below 0.1 rad.
inline LaneRotation polar_rotation(const LaneMatrix& A) {
  constexpr int kNewtonSteps = 3;
  LaneRotation Q;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const LaneMatrix B = transposed(Q.matrix()) * A;
    const LaneVector skew{{B(2, 1) - B(1, 2), B(0, 2) - B(2, 0), B(1, 0) - B(0, 1)}};
    LaneMatrix symmetric = B;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) symmetric(i, j) = Lane(0.5) * (B(i, j) + B(j, i));
    }
    Q = Q * rotation_by(solve(trace_minus(symmetric), skew));
  }
  return Q;
}

inline LaneRotation select(const Mask& mask, const LaneRotation& yes, const LaneRotation& no) {
  return {select(mask, yes.w, no.w), select(mask, yes.axis, no.axis)};
}

}  // namespace unbruised
