#include "studies/execution/arm_run.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/arm_carrier.hpp"

namespace unbruised::studies {

double ramp_start_s(const Scenario& scenario, double lift_time_s) {
  return lift_time_s - scenario.strategy.grip_ramp_s - scenario.strategy.settle_s;
}

MotionPlan followed_plan(const Scenario& scenario, double lift_time_s) {
  const double start_s = std::isnan(lift_time_s) ? kNever : ramp_start_s(scenario, lift_time_s);
  return MotionPlan(scenario, start_s, kNever, arm_carrier(scenario).get());
}

ArmRun::ArmRun(const Scenario& scenario) : timed_(timed_for_arm(scenario)) {
  if (!timed_.ride.breach) return;
  SimulationParameters& simulation = timed_.scenario.simulation;
  const double end_s = std::max(timed_.ride.breach->time_s, simulation.time_step_s);
  simulation.duration_s = std::min(end_s, simulation.duration_s.value_or(end_s));
}

void ArmRun::judge(ScenarioResult& result) const {
  const ArmRide& ride = timed_.ride;
  if (!ride.samples.empty()) {
    result.metrics[Metric::robot_speed_use] = ride.speed.use;
    result.metrics[Metric::robot_acceleration_use] = ride.acceleration.use;
    result.metrics[Metric::robot_jerk_use] = ride.jerk.use;
    result.metrics[Metric::robot_torque_use] = ride.torque.use;
    result.metrics[Metric::robot_position_use] = ride.position.use;
    result.metrics[Metric::robot_least_manipulability] = ride.least_manipulability;
    result.metrics[Metric::robot_joint_travel_rad] = ride.joint_travel_rad;
    result.metrics[Metric::robot_cycle_time_s] = ride.moving_s;
  }
  const bool has_ended = result.outcome == Outcome::diverged || result.outcome == Outcome::out_of_range;
  if (!ride.breach || has_ended) return;
  result.outcome = Outcome::out_of_range;
  result.outcome_time_s = ride.breach->time_s;
  result.cause = words_of(*ride.breach);
}

void ArmRun::add_joints(const ScenarioResult& result, Trace& trace) const {
  const MotionPlan plan = followed_plan(timed_.scenario, result.metrics[Metric::lift_time_s]);
  const std::vector<ArmSample> samples = ride_at(timed_.scenario, plan, trace.time_s);
  if (samples.empty()) return;
  const int joints = static_cast<int>(timed_.scenario.robot.joint.size());
  TraceSignal position{"joint_position_rad", "rad", "angles of the arm's joints", {"joint"}, {joints}, {}};
  TraceSignal speed{"joint_speed_rad_s", "rad s-1", "speeds of the arm's joints", {"joint"}, {joints}, {}};
  TraceSignal torque{"joint_torque_N_m", "N m", "torques of the arm's joints", {"joint"}, {joints}, {}};
  for (const ArmSample& sample : samples) {
    const auto append = [](TraceSignal& signal, const Joints& values) {
      signal.values.insert(signal.values.end(), values.begin(), values.end());
    };
    append(position, sample.motion.angle_rad);
    append(speed, sample.motion.speed_rad_s);
    append(torque, sample.torque_N_m);
  }
  if (arm_sways(timed_.scenario)) {
    TraceSignal told{"palm_told_m", "m", "where the arm is told to have the palm, as palm_position_m",
                     {"component"}, {3}, {}};
    for (const double time_s : trace.time_s) {
      const std::array<double, 3> place_m = plan.told_palm(time_s).position_m;
      told.values.insert(told.values.end(), place_m.begin(), place_m.end());
    }
    trace.signals.push_back(std::move(told));
  }
  for (TraceSignal* signal : {&position, &speed, &torque}) trace.signals.push_back(std::move(*signal));
}

std::vector<double> ArmRun::links_m(const ScenarioResult& result, const std::vector<double>& time_s) const {
  const MotionPlan plan = followed_plan(timed_.scenario, result.metrics[Metric::lift_time_s]);
  const Arm arm(timed_.scenario.robot);
  std::vector<double> links;
  for (const ArmSample& sample : ride_at(timed_.scenario, plan, time_s)) {
    const std::array<double, 3> palm_m = arm.palm(sample.motion.angle_rad).place_m;
    const auto append = [&](const std::array<double, 3>& place_m) {
      for (std::size_t d = 0; d < 3; ++d) links.push_back(place_m[d] - palm_m[d]);
    };
    append(timed_.scenario.robot.base_place_m);
    for (const Pose& frame : arm.frames(sample.motion.angle_rad)) append(frame.place_m);
  }
  return links;
}

std::vector<double> arm_links_m(const Scenario& scenario, const ScenarioResult& result,
                                const std::vector<double>& time_s) {
  return has_robot(scenario) ? ArmRun(scenario).links_m(result, time_s) : std::vector<double>{};
}

}  // namespace unbruised::studies
