#include "core/robot/arm_stop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unbruised {
namespace {

constexpr double kMostStop_s = 5.0;
/// Parts of a stop that brakes evenly, and how long each is.
constexpr double kParts = 60.0, kShortestPart_s = 1e-5, kLongestPart_s = 1e-3;
/// Joints that are slower are at rest.
constexpr double kRest_rad_s = 1e-9;

bool rests(const ArmMotion& motion) {
  return std::ranges::all_of(motion.speed_rad_s, [](double speed) { return std::abs(speed) < kRest_rad_s; });
}

/// Where a + b x is between -most and most: the lower end of x.
double least(double a, double b, double most) {
  if (b == 0.0) return -std::numeric_limits<double>::infinity();
  return (b > 0.0 ? -most - a : most - a) / b;
}

/// The hardest braking s'' where the path is gone along with s'.
double hardest_1_s(const Arm& arm, const PathMotion& path, double rate,
                   const std::array<double, 3>& gravity_m_s2) {
  const auto& [q, q1, q2] = path.motion;
  const std::size_t n = arm.joint_count();
  const Joints none(n, 0.0);
  const Joints per_change = joint_torques(arm, {q, none, q1}, path.loads, {});
  const Joints per_square = joint_torques(arm, {q, q1, q2}, path.loads, {});
  const Joints weight = joint_torques(arm, {q, none, none}, path.loads, gravity_m_s2);
  double change = -std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < n; ++j) {
    const double square = rate * rate;
    change = std::max(change,
                      least(square * per_square[j] + weight[j], per_change[j], arm.robot().joint[j].torque_N_m));
    if (const auto most = stop_deceleration_rad_s2(arm.robot(), j))
      change = std::max(change, least(square * q2[j], q1[j], *most));
  }
  return std::min(change, 0.0);
}

}  // namespace

std::optional<StopLaw> arm_stop(const Arm& arm, const ArmPath& path, double start_s,
                                const std::array<double, 3>& gravity_m_s2) {
  StopLaw law(start_s);
  auto now = path(start_s);
  if (!now) return std::nullopt;
  double rate = 1.0, plan_s = start_s;
  while (!rests(now->motion)) {
    double change = hardest_1_s(arm, *now, rate, gravity_m_s2);
    const double rest_s = change < 0.0 ? -rate / change : kMostStop_s;
    const double part_s = std::min(rest_s, std::clamp(rest_s / kParts, kShortestPart_s, kLongestPart_s));
    const double left = std::max(0.0, rate + change * part_s);
    const auto next = path(plan_s + part_s * 0.5 * (rate + left));
    if (!next) return std::nullopt;
    change = std::max(change, hardest_1_s(arm, *next, left, gravity_m_s2));
    const bool ends = rate + change * part_s <= 1e-12;
    law.add(change, ends ? -rate / change : part_s);
    if (ends) break;
    if (law.duration_s() > kMostStop_s) return std::nullopt;
    rate += change * part_s;
    plan_s = law.at(law.duration_s()).plan_s;
    now = path(plan_s);
    if (!now) return std::nullopt;
  }
  return law;
}

}  // namespace unbruised
