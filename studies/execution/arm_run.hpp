#pragma once

/// @file
/// What the arm of a scenario makes of it: before it is simulated and after. The steps of the simulation know of
/// no arm; the palm goes along its path as planned, and the arm is asked whether it could carry it there.

#include "core/outcome/outcome.hpp"
#include "core/outcome/trace.hpp"
#include "core/robot/arm_timing.hpp"

namespace unbruised::studies {

/// When the drive's force began to rise before a lift at this time.
double ramp_start_s(const Scenario& scenario, double lift_time_s);
/// The plan that a run followed, from when its lift began; NaN: none did.
MotionPlan followed_plan(const Scenario& scenario, double lift_time_s);

class ArmRun {
 public:
  /// @param scenario has a robot
  explicit ArmRun(const Scenario& scenario);

  /// What is to be simulated: slowed down where that was asked for, ended where the arm cannot go on.
  [[nodiscard]] const Scenario& scenario() const { return timed_.scenario; }
  /// Adds the metrics of the arm, and the outcome where it cannot follow.
  void judge(ScenarioResult& result) const;
  /// Adds joint_position_rad, joint_speed_rad_s and joint_torque_N_m.
  void add_joints(const ScenarioResult& result, Trace& trace) const;
  /// Where base, joints and flange are at these times, which ascend: [time, joints + 2, 3], from the middle of the
  /// palm along x, y, z of the cell [m]. Empty where the arm gets stuck.
  [[nodiscard]] std::vector<double> links_m(const ScenarioResult& result, const std::vector<double>& time_s) const;

 private:
  TimedScenario timed_;
};

/// Its links_m; empty where the scenario has no arm.
std::vector<double> arm_links_m(const Scenario& scenario, const ScenarioResult& result,
                                const std::vector<double>& time_s);

}  // namespace unbruised::studies
