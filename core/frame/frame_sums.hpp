#pragma once

/// @file
/// What the frame needs to know of all particles of a body: sums over them, taken in the pass that moves them.

#include "core/lanes/lane_packs.hpp"

namespace unbruised {

/// y = X + u, v and a of a state in the axes of its frame.
template <class L>
struct StateSumsOf {
  VectorOf<L> y, v, a;   ///< sum m y, sum m v, sum m a
  VectorOf<L> y_v, y_a;  ///< sum m y x v, sum m y x a
  MatrixOf<L> y_y, y_X;  ///< sum m y y', sum m y X'

  [[gnu::always_inline]] void add(const L& mass, const std::array<double, 3>& X, const VectorOf<L>& y_i,
                                  const VectorOf<L>& v_i, const VectorOf<L>& a_i) {
    const VectorOf<L> my = mass * y_i;
    y += my;
    v += mass * v_i;
    a += mass * a_i;
    y_v += cross(my, v_i);
    y_a += cross(my, a_i);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (j >= i) y_y(i, j) += my[i] * y_i[j];
        y_X(i, j) += my[i] * L(X[j]);
      }
    }
  }

  /// Takes in the sums of a pack of lanes.
  template <class P>
  void widen(const StateSumsOf<P>& pack, int first_lane) {
    unbruised::widen(y, pack.y, first_lane);
    unbruised::widen(v, pack.v, first_lane);
    unbruised::widen(a, pack.a, first_lane);
    unbruised::widen(y_v, pack.y_v, first_lane);
    unbruised::widen(y_a, pack.y_a, first_lane);
    unbruised::widen(y_y, pack.y_y, first_lane);
    unbruised::widen(y_X, pack.y_X, first_lane);
  }

  /// The same sums about the centre of mass, which is moved to the origin.
  void center(const L& total_mass) {
    const VectorOf<L> c = L(1.0) / total_mass * y;
    y_v = y_v - cross(c, v);
    y_a = y_a - cross(c, a);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) y_y(j, i) = y_y(i, j) = y_y(i, j) - y[i] * c[j];
    }
    y = VectorOf<L>{};
  }

  /// The same sums in axes turned by Q: components become Q' times what they were.
  void turn(const MatrixOf<L>& Q) {
    const MatrixOf<L> back = transposed(Q);
    for (VectorOf<L>* vector : {&y, &v, &a, &y_v, &y_a}) *vector = back * *vector;
    y_y = back * y_y * Q;
    y_X = back * y_X;
  }
};
using StateSums = StateSumsOf<Lane>;

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
template <class L>
struct BalanceSumsOf {
  VectorOf<L> y, a, y_a;  ///< sum m y, sum m a, sum m y x a
  MatrixOf<L> X_y;        ///< sum m X y'

  [[gnu::always_inline]] void add(const L& mass, const std::array<double, 3>& X, const VectorOf<L>& y_i,
                                  const VectorOf<L>& a_i) {
    const VectorOf<L> my = mass * y_i;
    y += my;
    a += mass * a_i;
    y_a += cross(my, a_i);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) X_y(i, j) += L(X[i]) * my[j];
    }
  }

  /// Takes in the sums of a pack of lanes.
  template <class P>
  void widen(const BalanceSumsOf<P>& pack, int first_lane) {
    unbruised::widen(y, pack.y, first_lane);
    unbruised::widen(a, pack.a, first_lane);
    unbruised::widen(y_a, pack.y_a, first_lane);
    unbruised::widen(X_y, pack.X_y, first_lane);
  }
};
using BalanceSums = BalanceSumsOf<Lane>;

}  // namespace unbruised
