#pragma once

/// @file
/// Rest-to-rest motion of a scalar distance, planned from the numbers a robot's data sheet gives:
/// peak acceleration, speed limit and jerk limit. Durations are real numbers, never rounded to time steps.

#include <limits>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Limits of one motion.
struct MotionLimits {
  double speed = 0.0, acceleration = 0.0;                 ///< > 0
  double jerk = std::numeric_limits<double>::infinity();  ///< > 0, finite for an s_curve
};

/// A motion from rest at 0 to rest at `distance_m()` along one scalar coordinate.
///
/// With D the distance, T the duration, a the peak acceleration, v the speed limit and s = t / T:
///  - trapezoid: acceleration exactly +a, 0, -a. Without cruise T = 2 sqrt(D / a); where a T / 2 would exceed
///    v, the motion cruises at v and T = D / v + v / a.
///  - minimum_jerk: x = D (10 s^3 - 15 s^4 + 6 s^5), whose peaks are a = (10 / sqrt 3) D / T^2 and
///    v = (15 / 8) D / T; T is the smallest duration at which neither exceeds its limit.
///  - s_curve: jerk +j, 0, -j while speeding up and the same backwards while braking. It speeds up for
///    A = a / j + v / a where that is 2 a / j or more, else for A = 2 sqrt(v / j), and cruises for D / v - A.
///    Where that is negative v is not reached: A = a / (2 j) + sqrt((a / (2 j))^2 + D / a) where D >= 2 a^3 / j^2,
///    else a is not reached either and A = 2 (D / (2 j))^(1/3). T = A + D / (peak speed).
/// Source of the quintic: Flash & Hogan 1985, J. Neurosci. 5(7), 1688-1703, with rest at both ends.
class MotionProfile {
 public:
  /// A motion over no distance, which takes no time.
  MotionProfile() = default;

  /// The fastest profile of its kind that respects both limits.
  /// @param distance_m             finite; may be negative (the motion runs backwards) or zero (it takes no time)
  /// @param peak_acceleration_m_s2 > 0, finite
  /// @param speed_limit_m_s        > 0; infinity: no limit
  /// @param jerk_limit_m_s3        > 0, finite for an s_curve, which is the only one to look at it
  /// @throws std::invalid_argument where one of these does not hold
  static MotionProfile plan(ProfileKind kind, double distance_m, double peak_acceleration_m_s2,
                            double speed_limit_m_s,
                            double jerk_limit_m_s3 = std::numeric_limits<double>::infinity());

  /// The profile that takes this time: of minimum jerk, or a trapezoid or s_curve that speeds up for a third of it
  /// and brakes for a third. @param distance_m finite @param duration_s > 0, finite
  static MotionProfile in_time(ProfileKind kind, double distance_m, double duration_s);

  [[nodiscard]] double distance_m() const { return distance_m_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }

  struct State {
    double position_m = 0.0;
    double velocity_m_s = 0.0;
    double acceleration_m_s2 = 0.0;
    double jerk_m_s3 = 0.0;  ///< where the acceleration does not jump
  };

  /// When the acceleration jumps, after the start [s].
  [[nodiscard]] std::vector<double> jumps_s() const;

  /// The state at `time_s` after the start: at rest at 0 before the start, at rest at `distance_m()` from
  /// `duration_s()` on. Where the acceleration jumps, the value after the jump holds.
  [[nodiscard]] State at(double time_s) const;

 private:
  /// @param D, a, v, j way, acceleration, speed and jerk, > 0
  void plan_s_curve(double D, double a, double v, double j);
  [[nodiscard]] State trapezoid_at(double time_s) const;
  [[nodiscard]] State minimum_jerk_at(double time_s) const;
  [[nodiscard]] State s_curve_at(double time_s) const;
  /// From rest, while it speeds up.
  [[nodiscard]] State speeding_up_at(double time_s) const;

  ProfileKind kind_ = ProfileKind::minimum_jerk;
  double distance_m_ = 0.0;
  double duration_s_ = 0.0;
  double ramp_s_ = 0.0;             // trapezoid, s_curve: time of speeding up, and of braking
  double acceleration_m_s2_ = 0.0;  // trapezoid, s_curve: signed peak acceleration while speeding up
  double jerk_s_ = 0.0;             // s_curve: time in which the acceleration reaches its peak
};

}  // namespace unbruised
