#include "core/robot/arm_timing.hpp"

#include <algorithm>

namespace unbruised {
namespace {

/// A motion of minimum jerk fits after the first round; trapezoids change their shape, and need some.
constexpr int kMostRounds = 40;
constexpr double kOver = 1.0 + 1e-6;  // a stretch is taken by so much too large, so that the limit holds

/// @return false: nothing moves in this leg, or weight alone is too much
bool slow_down(double& acceleration, double peak, double stretch) {
  if (!(stretch < kNever) || !(peak > 0.0)) return false;
  acceleration = std::min(acceleration, peak) / (stretch * stretch);
  return true;
}

/// @return false: nothing can be slowed down, or not enough
bool slow_down(const ArmRide& ride, StrategyParameters& strategy) {
  bool changed = false, can = true;
  for (const ArmLeg leg : {ArmLeg::lift, ArmLeg::carry, ArmLeg::lower}) {
    const LegNeed& need = ride.need[static_cast<std::size_t>(leg)];
    if (!(need.stretch > 1.0)) continue;
    const double stretch = need.stretch * kOver;
    double& acceleration = leg == ArmLeg::lift    ? strategy.lift_acceleration_m_s2
                           : leg == ArmLeg::carry ? *strategy.transfer_acceleration_m_s2
                                                  : *strategy.lower_acceleration_m_s2;
    bool slowed = slow_down(acceleration, need.peak_m_s2, stretch);
    if (leg == ArmLeg::carry) {
      slowed = slow_down(strategy.tilt_acceleration_rad_s2, need.peak_rad_s2, stretch) || slowed;
    }
    changed = changed || slowed;
    can = can && slowed;
  }
  return changed && can;
}

bool has_size(ArmLimit limit) {
  return limit == ArmLimit::speed || limit == ArmLimit::acceleration || limit == ArmLimit::torque;
}

}  // namespace

TimedScenario timed_for_arm(const Scenario& scenario) {
  TimedScenario timed{scenario, ride(scenario, planned_motion(scenario))};
  if (scenario.robot.timing == RobotTiming::check) return timed;
  if (timed.ride.stuck) {
    timed.ride.breach = timed.ride.stuck;
    return timed;
  }
  const double planned_s = timed.ride.moving_s;
  StrategyParameters& strategy = timed.scenario.strategy;
  for (int round = 0; round < kMostRounds && timed.ride.breach && has_size(timed.ride.breach->limit); ++round) {
    const double lift_m_s2 = scenario.strategy.lift_acceleration_m_s2;
    strategy.transfer_acceleration_m_s2 = strategy.transfer_acceleration_m_s2.value_or(lift_m_s2);
    strategy.lower_acceleration_m_s2 = strategy.lower_acceleration_m_s2.value_or(lift_m_s2);
    if (!slow_down(timed.ride, strategy)) break;
    timed.ride = ride(timed.scenario, planned_motion(timed.scenario));
  }
  timed.slowed_s = timed.ride.moving_s - planned_s;
  return timed;
}

}  // namespace unbruised
