#pragma once

/// @file
/// What the frame needs to know of all particles of a body: sums over them, taken in the pass that moves them.

#include "core/lanes/lane_vector.hpp"

namespace unbruised {

/// y = X + u, v and a of a state in the axes of its frame.
struct StateSums {
  LaneVector y, v, a;   ///< sum m y, sum m v, sum m a
  LaneVector y_v, y_a;  ///< sum m y x v, sum m y x a
  LaneMatrix y_y, y_X;  ///< sum m y y', sum m y X'

  [[gnu::always_inline]] void add(const Lane& mass, const std::array<double, 3>& X, const LaneVector& y_i,
                                  const LaneVector& v_i, const LaneVector& a_i) {
    const LaneVector my = mass * y_i;
    y += my;
    v += mass * v_i;
    a += mass * a_i;
    y_v += cross(my, v_i);
    y_a += cross(my, a_i);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (j >= i) y_y(i, j) += my[i] * y_i[j];
        y_X(i, j) += my[i] * Lane(X[j]);
      }
    }
  }

  /// The same sums about the centre of mass, which is moved to the origin.
  void center(const Lane& total_mass) {
    const LaneVector c = Lane(1.0) / total_mass * y;
    y_v = y_v - cross(c, v);
    y_a = y_a - cross(c, a);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) y_y(j, i) = y_y(i, j) = y_y(i, j) - y[i] * c[j];
    }
    y = LaneVector{};
  }

  /// The same sums in axes turned by Q: components become Q' times what they were.
  void turn(const LaneMatrix& Q) {
    const LaneMatrix back = transposed(Q);
    for (LaneVector* vector : {&y, &v, &a, &y_v, &y_a}) *vector = back * *vector;
    y_y = back * y_y * Q;
    y_X = back * y_X;
  }
};

/// What presses on a body from outside, at t + theta dt in the axes of its frame.
struct OuterForces {
  LaneVector force;    ///< sum f
  LaneVector moment;   ///< sum y x f
  Lane leverage{0.0};  ///< sum |f| |y|

  void add(const LaneVector& y, const LaneVector& f) {
    force += f;
    moment += cross(y, f);
    leverage += sqrt(dot(y, y) * dot(f, f));
  }
  /// A force that has been added acts this far from where it was said to.
  void add_arm(const LaneVector& arm, const LaneVector& f) {
    moment += cross(arm, f);
    leverage += sqrt(dot(arm, arm) * dot(f, f));
  }
};

/// y_theta = X + u_theta and the accelerations there.
struct BalanceSums {
  LaneVector y, a, y_a;  ///< sum m y, sum m a, sum m y x a
  LaneMatrix X_y;        ///< sum m X y'

  [[gnu::always_inline]] void add(const Lane& mass, const std::array<double, 3>& X, const LaneVector& y_i,
                                  const LaneVector& a_i) {
    const LaneVector my = mass * y_i;
    y += my;
    a += mass * a_i;
    y_a += cross(my, a_i);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) X_y(i, j) += Lane(X[i]) * my[j];
    }
  }
};

}  // namespace unbruised
