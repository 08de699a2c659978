#pragma once

/// @file
/// Fingers alone in one lane, each against a spring that stands for the product.

#include <algorithm>
#include <array>

#include "core/gripper/finger_lanes.hpp"

namespace unbruised::testing {

class LoneJaw {
 public:
  static constexpr int kLane = 3;
  using Forces = std::array<double, kJawFingers>;

  LoneJaw(const ParallelJawParameters& jaw, double closing_speed_m_s, double force_limit_N,
          double time_step_s = 1e-3)
      : w(time_step_s, 1.4) {
    fingers.load(kLane, &jaw, closing_speed_m_s, force_limit_N);
    start_J_ = fingers.energy()[kLane];
    running_.set(kLane, true);
    command_.force_limit_N.set(kLane, force_limit_N);
    command_.set_speed_m_s.set(kLane, closing_speed_m_s);
  }
  void set_speed(double speed_m_s) { command_.set_speed_m_s.set(kLane, speed_m_s); }
  void lock(double share) { command_.locked.set(kLane, share); }
  /// Under these contact forces at t + theta dt.
  void step_under(const Forces& contact_N) {
    fingers.begin_step(w, command_);
    end_step(contact_N);
  }
  /// Against the springs.
  void step() {
    fingers.begin_step(w, command_);
    end_step(balanced_N());
  }
  /// Of the coming step.
  [[nodiscard]] double way_at_theta_m(int finger, const Forces& contact_N) {
    fingers.begin_step(w, command_);
    return fingers.way_at_theta(finger, lanes(contact_N))[kLane];
  }
  [[nodiscard]] double way(int finger) const { return fingers.way(finger)[kLane]; }
  [[nodiscard]] double speed(int finger) const { return fingers.speed(finger)[kLane]; }
  [[nodiscard]] double acceleration(int finger) const { return fingers.acceleration(finger)[kLane]; }
  /// Now.
  [[nodiscard]] double contact_N(int finger) const { return spring_force_N(way(finger)); }
  /// Of the account of energy: what is missing at its end [J].
  [[nodiscard]] double booked_J() const {
    double springs_J = 0.0;
    for (int f = 0; f < kJawFingers; ++f)
      springs_J += 0.5 * contact_N(f) * contact_N(f) / std::max(spring_N_m, 1.0);
    return fingers.work()[kLane] + start_J_ - fingers.energy()[kLane] - fingers.dissipated()[kLane] - springs_J;
  }

  const WilsonTheta w;
  FingerLanes fingers;
  double spring_N_m = 0.0, touch_m = 0.0;

 private:
  [[nodiscard]] double spring_force_N(double way_m) const { return std::max(0.0, spring_N_m * (way_m - touch_m)); }
  static FingerForces lanes(const Forces& contact_N) {
    FingerForces all = without_force();
    for (std::size_t f = 0; f < kJawFingers; ++f) all[f].set(kLane, contact_N[f]);
    return all;
  }
  /// Forces with which springs and fingers meet at t + theta dt, by bisection: the more they press the less the
  /// fingers come. The fingers press alike.
  [[nodiscard]] Forces balanced_N() const {
    double low = 0.0, high = 1e4;
    for (int round = 0; round < 64 && spring_N_m > 0.0; ++round) {
      const double middle = 0.5 * (low + high);
      Forces all;
      all.fill(middle);
      (spring_force_N(fingers.way_at_theta(0, lanes(all))[kLane]) > middle ? low : high) = middle;
    }
    Forces all;
    all.fill(low);
    return all;
  }
  void end_step(const Forces& contact_N) { fingers.advance(w, lanes(contact_N), running_); }

  Mask running_{false};
  DriveCommand command_;
  double start_J_ = 0.0;
};

}  // namespace unbruised::testing
