#pragma once

/// @file
/// Wilson-theta in Bathe's form (docs/theory.md, "Time"): acceleration linear over theta dt, equilibrium at
/// t + theta dt, so that K + a0 M + a1 C is factored once for every step.

namespace unbruised {

/// The constants of one step length.
struct WilsonTheta {
  double dt, theta;
  double a0, a1, a2, a3, a4, a5, a6, a7, a8;

  WilsonTheta(double time_step_s, double theta_value)
      : dt(time_step_s),
        theta(theta_value),
        a0(6.0 / (theta * dt * theta * dt)),
        a1(3.0 / (theta * dt)),
        a2(2.0 * a1),
        a3(theta * dt / 2.0),
        a4(a0 / theta),
        a5(-a2 / theta),
        a6(1.0 - 3.0 / theta),
        a7(dt / 2.0),
        a8(dt * dt / 6.0) {}

  /// The mass part of the right-hand side, a0 u + a2 v + 2 a.
  template <class T>
  [[nodiscard]] T inertial(const T& u, const T& v, const T& a) const {
    return T(a0) * u + T(a2) * v + T(2.0) * a;
  }
  /// The damping part, a1 u + 2 v + a3 a.
  template <class T>
  [[nodiscard]] T viscous(const T& u, const T& v, const T& a) const {
    return T(a1) * u + T(2.0) * v + T(a3) * a;
  }
  /// Moves (u, v, a) from t to t + dt, given the displacement at t + theta dt.
  template <class T>
  void advance(const T& u_theta, T& u, T& v, T& a) const {
    const T next = T(a4) * (u_theta - u) + T(a5) * v + T(a6) * a;
    u = u + T(dt) * v + T(a8) * (next + T(2.0) * a);
    v = v + T(a7) * (next + a);
    a = next;
  }
  /// The value at t + dt of a quantity that is `now` at t, `later` at t + theta dt, and linear between: forces,
  /// plastic strains, anchors. A convex combination, so that cones and signs are kept.
  template <class T>
  [[nodiscard]] T at_end(const T& now, const T& later) const {
    return now + (later - now) * T(1.0 / theta);
  }
};

}  // namespace unbruised
