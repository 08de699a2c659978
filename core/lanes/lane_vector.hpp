#pragma once

/// @file
/// Vectors and 3x3 matrices with a lane value for each number.

#include <array>
#include <cstddef>

#include "core/lanes/lane.hpp"

namespace unbruised {

/// @tparam L a lane value: of all scenarios of a batch, or of a pack of them
template <class L>
struct VectorOf {
  std::array<L, 3> at{L(0.0), L(0.0), L(0.0)};

  [[gnu::always_inline]] L& operator[](std::size_t i) { return at[i]; }
  [[gnu::always_inline]] const L& operator[](std::size_t i) const { return at[i]; }
  [[gnu::always_inline]] VectorOf& operator+=(const VectorOf& b) {
    for (std::size_t i = 0; i < 3; ++i) at[i] += b[i];
    return *this;
  }
  [[gnu::always_inline]] friend VectorOf operator+(VectorOf a, const VectorOf& b) { return a += b; }
  [[gnu::always_inline]] friend VectorOf operator-(VectorOf a, const VectorOf& b) {
    for (std::size_t i = 0; i < 3; ++i) a[i] -= b[i];
    return a;
  }
  [[gnu::always_inline]] friend VectorOf operator*(const L& factor, VectorOf a) {
    for (std::size_t i = 0; i < 3; ++i) a[i] *= factor;
    return a;
  }
};
using LaneVector = VectorOf<Lane>;

/// Row-major.
template <class L>
struct MatrixOf {
  std::array<L, 9> at{L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0)};

  [[gnu::always_inline]] L& operator()(std::size_t row, std::size_t column) { return at[3 * row + column]; }
  [[gnu::always_inline]] const L& operator()(std::size_t row, std::size_t column) const {
    return at[3 * row + column];
  }
};
using LaneMatrix = MatrixOf<Lane>;

inline LaneMatrix identity_lanes() {
  LaneMatrix one;
  for (std::size_t i = 0; i < 3; ++i) one(i, i) = Lane(1.0);
  return one;
}

/// The three rows of a particle, 3 x particle + axis.
[[gnu::always_inline]] inline LaneVector get_vector(const LaneArray& rows, std::size_t particle) {
  return {{rows.get(3 * particle), rows.get(3 * particle + 1), rows.get(3 * particle + 2)}};
}
[[gnu::always_inline]] inline void put_vector(LaneArray& rows, std::size_t particle, const LaneVector& value) {
  for (std::size_t i = 0; i < 3; ++i) rows.put(3 * particle + i, value[i]);
}

template <class L = Lane>
[[gnu::always_inline]] inline VectorOf<L> to_lanes(const std::array<double, 3>& value) {
  return {{L(value[0]), L(value[1]), L(value[2])}};
}
inline std::array<double, 3> of_lane(const LaneVector& value, int lane) {
  return {value[0][lane], value[1][lane], value[2][lane]};
}

template <int Width>
[[gnu::always_inline]] inline VectorOf<LanePack<Width>> select(const MaskPack<Width>& mask,
                                                               const VectorOf<LanePack<Width>>& yes,
                                                               const VectorOf<LanePack<Width>>& no) {
  return {{select(mask, yes[0], no[0]), select(mask, yes[1], no[1]), select(mask, yes[2], no[2])}};
}

template <class L>
[[gnu::always_inline]] inline L dot(const VectorOf<L>& a, const VectorOf<L>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class L>
[[gnu::always_inline]] inline VectorOf<L> cross(const VectorOf<L>& a, const VectorOf<L>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// A x.
template <class L>
[[gnu::always_inline]] inline VectorOf<L> operator*(const MatrixOf<L>& A, const VectorOf<L>& x) {
  VectorOf<L> y;
  for (std::size_t i = 0; i < 3; ++i) y[i] = A(i, 0) * x[0] + A(i, 1) * x[1] + A(i, 2) * x[2];
  return y;
}

/// A'.
[[gnu::always_inline]] inline LaneMatrix transposed(const LaneMatrix& A) {
  return {{A(0, 0), A(1, 0), A(2, 0), A(0, 1), A(1, 1), A(2, 1), A(0, 2), A(1, 2), A(2, 2)}};
}

/// A B.
inline LaneMatrix operator*(const LaneMatrix& A, const LaneMatrix& B) {
  LaneMatrix C;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) C(i, j) = A(i, 0) * B(0, j) + A(i, 1) * B(1, j) + A(i, 2) * B(2, j);
  }
  return C;
}

/// tr(A) 1 - A: of the second moments of masses it makes their inertia.
inline LaneMatrix trace_minus(const LaneMatrix& A) {
  const Lane trace = A(0, 0) + A(1, 1) + A(2, 2);
  LaneMatrix B;
  for (std::size_t i = 0; i < 9; ++i) B.at[i] = (i % 4 == 0 ? trace : Lane(0.0)) - A.at[i];
  return B;
}

/// x of A x = b by cofactors; A far from singular.
inline LaneVector solve(const LaneMatrix& A, const LaneVector& b) {
  const LaneVector a0{{A(0, 0), A(1, 0), A(2, 0)}}, a1{{A(0, 1), A(1, 1), A(2, 1)}},
      a2{{A(0, 2), A(1, 2), A(2, 2)}};
  const LaneVector a12 = cross(a1, a2);
  const Lane inverse = Lane(1.0) / dot(a0, a12);
  return {{dot(b, a12) * inverse, dot(a0, cross(b, a2)) * inverse, dot(a0, cross(a1, b)) * inverse}};
}

}  // namespace unbruised
