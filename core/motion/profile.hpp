#pragma once

/// @file
/// Rest-to-rest motion of a scalar distance, planned from the two numbers a robot's data sheet gives:
/// peak acceleration and speed limit. Durations are real numbers, never rounded to time steps.

#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A motion from rest at 0 to rest at `distance_m()` along one scalar coordinate.
///
/// With D the distance, T the duration, a the peak acceleration, v the speed limit and s = t / T:
///  - trapezoid: acceleration exactly +a, 0, -a. Without cruise T = 2 sqrt(D / a); where a T / 2 would exceed
///    v, the motion cruises at v and T = D / v + v / a.
///  - minimum_jerk: x = D (10 s^3 - 15 s^4 + 6 s^5), whose peaks are a = (10 / sqrt 3) D / T^2 and
///    v = (15 / 8) D / T; T is the smallest duration at which neither exceeds its limit.
/// Source of the quintic: Flash & Hogan 1985, J. Neurosci. 5(7), 1688-1703, with rest at both ends.
class MotionProfile {
 public:
  /// A motion over no distance, which takes no time.
  MotionProfile() = default;

  /// The fastest profile of its kind that respects both limits.
  /// @param distance_m             finite; may be negative (the motion runs backwards) or zero (it takes no time)
  /// @param peak_acceleration_m_s2 > 0, finite
  /// @param speed_limit_m_s        > 0; infinity: no limit
  /// @throws std::invalid_argument where one of these does not hold
  static MotionProfile plan(ProfileKind kind, double distance_m, double peak_acceleration_m_s2,
                            double speed_limit_m_s);

  /// The profile that takes this time: of minimum jerk, or a trapezoid that speeds up for a third of it and brakes
  /// for a third. @param distance_m finite @param duration_s > 0, finite
  static MotionProfile in_time(ProfileKind kind, double distance_m, double duration_s);

  [[nodiscard]] double distance_m() const { return distance_m_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }

  struct State {
    double position_m = 0.0;
    double velocity_m_s = 0.0;
    double acceleration_m_s2 = 0.0;
  };

  /// When the acceleration jumps, after the start [s].
  [[nodiscard]] std::vector<double> jumps_s() const;

  /// The state at `time_s` after the start: at rest at 0 before the start, at rest at `distance_m()` from
  /// `duration_s()` on. Where the acceleration jumps, the value after the jump holds.
  [[nodiscard]] State at(double time_s) const;

 private:
  [[nodiscard]] State trapezoid_at(double time_s) const;
  [[nodiscard]] State minimum_jerk_at(double time_s) const;

  ProfileKind kind_ = ProfileKind::minimum_jerk;
  double distance_m_ = 0.0;
  double duration_s_ = 0.0;
  double ramp_s_ = 0.0;             // trapezoid: time of speeding up, and of braking
  double acceleration_m_s2_ = 0.0;  // trapezoid: signed acceleration while speeding up
};

}  // namespace unbruised
