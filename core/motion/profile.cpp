#include "core/motion/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace unbruised {
namespace {

// Peaks of 10 s^3 - 15 s^4 + 6 s^5: its second derivative 60 s (1 - s) (1 - 2 s) is largest at
// s = (1 - 1 / sqrt 3) / 2, its first 30 s^2 (1 - s)^2 at s = 1/2.
constexpr double kMinimumJerkPeakAcceleration = 10.0 / std::numbers::sqrt3;
constexpr double kMinimumJerkPeakSpeed = 15.0 / 8.0;

}  // namespace

MotionProfile MotionProfile::plan(ProfileKind kind, double distance_m, double peak_acceleration_m_s2,
                                  double speed_limit_m_s, double jerk_limit_m_s3) {
  if (!std::isfinite(distance_m)) throw std::invalid_argument("MotionProfile: distance_m must be finite");
  if (!(peak_acceleration_m_s2 > 0.0 && std::isfinite(peak_acceleration_m_s2))) {
    throw std::invalid_argument("MotionProfile: peak_acceleration_m_s2 must be > 0 and finite");
  }
  if (!(speed_limit_m_s > 0.0)) throw std::invalid_argument("MotionProfile: speed_limit_m_s must be > 0");
  if (kind == ProfileKind::s_curve && !(jerk_limit_m_s3 > 0.0 && std::isfinite(jerk_limit_m_s3))) {
    throw std::invalid_argument("MotionProfile: jerk_limit_m_s3 must be > 0 and finite");
  }

  MotionProfile profile;
  profile.kind_ = kind;
  profile.distance_m_ = distance_m;
  const double D = std::abs(distance_m);
  const double a = peak_acceleration_m_s2;
  const double v = speed_limit_m_s;
  if (D == 0.0) return profile;

  switch (kind) {
    case ProfileKind::trapezoid:
      profile.acceleration_m_s2_ = std::copysign(a, distance_m);
      profile.ramp_s_ = std::min(std::sqrt(D / a), v / a);
      profile.duration_s_ = D / (a * profile.ramp_s_) + profile.ramp_s_;
      break;
    case ProfileKind::minimum_jerk:
      profile.duration_s_ =
          std::max(std::sqrt(kMinimumJerkPeakAcceleration * D / a), kMinimumJerkPeakSpeed * D / v);
      break;
    case ProfileKind::s_curve:
      profile.plan_s_curve(D, a, v, jerk_limit_m_s3);
      break;
  }
  return profile;
}

MotionProfile MotionProfile::in_time(ProfileKind kind, double distance_m, double duration_s) {
  if (!std::isfinite(distance_m)) throw std::invalid_argument("MotionProfile: distance_m must be finite");
  if (!(duration_s > 0.0 && std::isfinite(duration_s))) {
    throw std::invalid_argument("MotionProfile: duration_s must be > 0 and finite");
  }
  MotionProfile profile;
  profile.kind_ = kind;
  profile.distance_m_ = distance_m;
  profile.duration_s_ = duration_s;
  profile.ramp_s_ = duration_s / 3.0;
  profile.acceleration_m_s2_ = distance_m / (profile.ramp_s_ * (duration_s - profile.ramp_s_));
  if (kind == ProfileKind::s_curve) {
    profile.jerk_s_ = 0.5 * profile.ramp_s_;
    profile.acceleration_m_s2_ *= 2.0;
  }
  return profile;
}

void MotionProfile::plan_s_curve(double D, double a, double v, double j) {
  // As if the speed were reached; without a limit of it, as if the way were too short for it.
  jerk_s_ = std::min(a / j, std::sqrt(v / j));
  ramp_s_ = jerk_s_ + v / (j * jerk_s_);
  if (!(D > v * ramp_s_)) {
    jerk_s_ = std::min(a / j, std::cbrt(D / (2.0 * j)));
    const double half = 0.5 * jerk_s_;
    ramp_s_ = half + std::sqrt(half * half + D / (j * jerk_s_));
  }
  const double peak_m_s2 = j * jerk_s_;
  duration_s_ = ramp_s_ + D / (peak_m_s2 * (ramp_s_ - jerk_s_));
  acceleration_m_s2_ = std::copysign(peak_m_s2, distance_m_);
}

std::vector<double> MotionProfile::jumps_s() const {
  if (kind_ != ProfileKind::trapezoid || !(duration_s_ > 0.0)) return {};
  return {0.0, ramp_s_, duration_s_ - ramp_s_, duration_s_};
}

MotionProfile::State MotionProfile::at(double time_s) const {
  if (time_s >= duration_s_) return {.position_m = time_s >= 0.0 ? distance_m_ : 0.0};
  if (time_s < 0.0) return {};
  switch (kind_) {
    case ProfileKind::trapezoid:
      return trapezoid_at(time_s);
    case ProfileKind::s_curve:
      return s_curve_at(time_s);
    default:
      return minimum_jerk_at(time_s);
  }
}

MotionProfile::State MotionProfile::speeding_up_at(double time_s) const {
  const double a = acceleration_m_s2_, j = a / jerk_s_, t = time_s;
  if (t < jerk_s_) return {j * t * t * t / 6.0, 0.5 * j * t * t, j * t, j};
  const double even_s = ramp_s_ - jerk_s_;  // until then the acceleration is at its peak
  if (t < even_s) {
    const double u = t - jerk_s_;
    return {a * (jerk_s_ * jerk_s_ / 6.0 + 0.5 * u * (jerk_s_ + u)), a * (0.5 * jerk_s_ + u), a, 0.0};
  }
  // Seen from where the peak speed is reached.
  const double left_s = ramp_s_ - t, speed = a * even_s;
  return {0.5 * speed * ramp_s_ - speed * left_s + j * left_s * left_s * left_s / 6.0,
          speed - 0.5 * j * left_s * left_s, j * left_s, -j};
}

MotionProfile::State MotionProfile::s_curve_at(double time_s) const {
  if (time_s < ramp_s_) return speeding_up_at(time_s);
  const double left_s = duration_s_ - time_s;
  if (left_s < ramp_s_) {
    const State seen = speeding_up_at(left_s);
    return {distance_m_ - seen.position_m, seen.velocity_m_s, -seen.acceleration_m_s2, seen.jerk_m_s3};
  }
  const double speed = acceleration_m_s2_ * (ramp_s_ - jerk_s_);
  return {speed * (time_s - 0.5 * ramp_s_), speed};
}

MotionProfile::State MotionProfile::trapezoid_at(double time_s) const {
  const double a = acceleration_m_s2_;
  const double left_s = duration_s_ - time_s;
  if (time_s < ramp_s_) return {0.5 * a * time_s * time_s, a * time_s, a};
  // Braking is speeding up seen from the end, so the motion arrives exactly.
  if (left_s <= ramp_s_) return {distance_m_ - 0.5 * a * left_s * left_s, a * left_s, -a};
  return {a * ramp_s_ * (time_s - 0.5 * ramp_s_), a * ramp_s_, 0.0};
}

MotionProfile::State MotionProfile::minimum_jerk_at(double time_s) const {
  const double D = distance_m_;
  const double T = duration_s_;
  const double s = time_s / T;
  return {D * s * s * s * (10.0 + s * (-15.0 + 6.0 * s)),  //
          D / T * 30.0 * s * s * (1.0 - s) * (1.0 - s),    //
          D / (T * T) * 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s),
          D / (T * T * T) * 60.0 * (1.0 + s * (-6.0 + 6.0 * s))};
}

}  // namespace unbruised
