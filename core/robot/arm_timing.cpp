#include "core/robot/arm_timing.hpp"

#include <algorithm>

#include "core/robot/arm_carrier.hpp"

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

/// The jerk of an s_curve is that of the strategy, in all legs: it falls with the cube of the stretch.
/// @return false: it is kept
bool soften(const ArmRide& ride, StrategyParameters& strategy) {
  double stretch = 1.0;
  for (const LegNeed& need : ride.need) stretch = std::max(stretch, need.jerk_stretch);
  if (strategy.profile != ProfileKind::s_curve || !(stretch > 1.0)) return false;
  const double least = 1.0 / (kOver * stretch * stretch * stretch);
  if (strategy.jerk_m_s3) *strategy.jerk_m_s3 *= least;
  if (strategy.tilt_jerk_rad_s3) *strategy.tilt_jerk_rad_s3 *= least;
  return true;
}

/// @return false: nothing can be slowed down, or not enough
bool slow_down(const ArmRide& ride, StrategyParameters& strategy) {
  bool changed = soften(ride, strategy), can = true;
  for (const ArmLeg leg : {ArmLeg::lift, ArmLeg::carry, ArmLeg::lower}) {
    const LegNeed& need = ride.need[static_cast<std::size_t>(leg)];
    const bool is_soft = strategy.profile == ProfileKind::s_curve;
    const double least = is_soft ? need.stretch : std::max(need.stretch, need.jerk_stretch);
    if (!(least > 1.0)) continue;
    const double stretch = least * kOver;
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
  return limit == ArmLimit::speed || limit == ArmLimit::acceleration || limit == ArmLimit::jerk ||
         limit == ArmLimit::torque;
}

/// Along the plan as it is told to the arm.
ArmRide planned_ride(const Scenario& scenario) {
  return ride(scenario, planned_motion(scenario, arm_carrier(scenario).get()));
}

}  // namespace

TimedScenario timed_for_arm(const Scenario& scenario) {
  TimedScenario timed{scenario, planned_ride(scenario)};
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
    timed.ride = planned_ride(timed.scenario);
  }
  timed.slowed_s = timed.ride.moving_s - planned_s;
  return timed;
}

}  // namespace unbruised
