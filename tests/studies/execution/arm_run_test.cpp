// What an arm makes of a scenario before it is simulated and after.

#include "studies/execution/arm_run.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "studies/execution/simulator.hpp"
#include "tests/core/robot/arms.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised::studies {
namespace {

Scenario carried_grip() {
  Scenario scenario = testing::usual_grip();
  scenario.robot = testing::six_joints();
  scenario.robot.base_place_m = {-0.55, 0.1, 0.0};
  return scenario;
}

TEST(ArmRun, AnArmThatCanAddsItsMetricsAndNothingElse) {
  const Scenario scenario = carried_grip();
  const ArmRun run(scenario);
  EXPECT_FALSE(run.scenario().simulation.duration_s);
  ScenarioResult result;
  result.outcome = Outcome::held;
  run.judge(result);
  EXPECT_EQ(result.outcome, Outcome::held);
  const MotionPlan plan = planned_motion(scenario);
  EXPECT_EQ(result.metrics[Metric::robot_cycle_time_s], plan.lower_end_s() - plan.lift_start_s());
  for (const Metric metric : {Metric::robot_speed_use, Metric::robot_torque_use, Metric::robot_position_use,
                              Metric::robot_least_manipulability}) {
    EXPECT_GT(result.metrics[metric], 0.0);
    EXPECT_LT(result.metrics[metric], 1.0);
  }
  EXPECT_EQ(result.metrics[Metric::robot_acceleration_use], 0.0) << "none is limited";
}

TEST(ArmRun, AnArmThatCannotEndsTheRunThereWithItsCause) {
  Scenario scenario = carried_grip();
  scenario.robot.joint[0].speed_rad_s = 0.01;
  const ArmRun run(scenario);
  ASSERT_TRUE(run.scenario().simulation.duration_s);
  ScenarioResult result;
  result.outcome = Outcome::not_grasped;
  run.judge(result);
  EXPECT_EQ(result.outcome, Outcome::out_of_range);
  EXPECT_EQ(result.outcome_time_s, *run.scenario().simulation.duration_s);
  EXPECT_EQ(result.cause.substr(0, 24), "joint 0 of the arm needs");
  ScenarioResult diverged;
  diverged.outcome = Outcome::diverged;
  run.judge(diverged);
  EXPECT_EQ(diverged.outcome, Outcome::diverged) << "that came before";
}

/// The cause of a run that is out_of_range from the start; empty: it is not.
std::string cause_at_start(const Scenario& scenario) {
  const ArmRun run(scenario);
  ScenarioResult result;
  run.judge(result);
  return result.outcome == Outcome::out_of_range && result.outcome_time_s == 0.0 ? result.cause : "";
}

TEST(ArmRun, AStartThatItCannotTakeIsOutOfRangeThere) {
  Scenario far = carried_grip();
  far.robot.base_place_m = {-3.0, 0.0, 0.0};
  EXPECT_EQ(cause_at_start(far), "the palm is out of the arm's reach");
  // Within its reach, but for the range of a joint.
  Scenario bound = carried_grip();
  for (ArmJointParameters& joint : bound.robot.joint) joint.lower_rad = -0.05;
  for (ArmJointParameters& joint : bound.robot.joint) joint.upper_rad = 0.05;
  bound.robot.seed_posture_rad.clear();
  EXPECT_EQ(cause_at_start(bound), "the palm is out of the arm's reach");
  // Two of its joints turn about one axis: the tool is mounted so that it stands like that.
  Scenario straight = carried_grip();
  RobotParameters& robot = straight.robot;
  robot.seed_posture_rad[4] = 0.0;
  robot.tool_place_m = robot.tool_rotation_rad = {};
  const Pose flange = Arm(robot).palm(robot.seed_posture_rad);
  const Pose tool = inverse(flange) * palm_pose(straight, planned_motion(straight).palm(0.0));
  robot.tool_place_m = tool.place_m;
  robot.tool_rotation_rad = rotation_to(tool.attitude);
  EXPECT_EQ(cause_at_start(straight), "the arm is singular on the palm's way");
}

TEST(ArmRun, ATraceHasTheJointsOfThePlanThatWasFollowed) {
  const Scenario scenario = carried_grip();
  const ArmRun run(scenario);
  ScenarioResult result;
  result.metrics[Metric::lift_time_s] = 0.5;
  Trace trace;
  trace.time_s = {0.0, 0.5, 0.75, 1.0};
  run.add_joints(result, trace);
  ASSERT_EQ(trace.signals.size(), 3U);
  EXPECT_EQ(trace.signals[0].name, "joint_position_rad");
  EXPECT_EQ(trace.signals[0].values.size(), 4U * 6U);
  const double ramp_s = 0.5 - scenario.strategy.grip_ramp_s - scenario.strategy.settle_s;
  const Arm arm(scenario.robot);
  const Joints then(trace.signals[0].values.begin() + 12, trace.signals[0].values.begin() + 18);
  const Pose wanted = palm_pose(scenario, MotionPlan(scenario, ramp_s).palm(0.75));
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(arm.palm(then).place_m[d], wanted.place_m[d], 1e-10);
}

TEST(ArmRun, ItsLinksReachFromTheBaseThatStandsToThePalmThatMoves) {
  const Scenario scenario = carried_grip();
  ScenarioResult result;
  result.metrics[Metric::lift_time_s] = 0.5;
  const std::vector<double> times_s = {0.0, 0.5, 0.75, 1.0};
  const std::vector<double> links_m = ArmRun(scenario).links_m(result, times_s);
  ASSERT_EQ(links_m.size(), 4U * 8U * 3U) << "base, six joints and flange";
  const MotionPlan plan(scenario, 0.5 - scenario.strategy.grip_ramp_s - scenario.strategy.settle_s);
  const double tool_m =
      std::hypot(scenario.robot.tool_place_m[0], scenario.robot.tool_place_m[1], scenario.robot.tool_place_m[2]);
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const Pose palm = palm_pose(scenario, plan.palm(times_s[i]));
    const double* base_m = links_m.data() + 24 * i;
    const double* flange_m = base_m + 21;
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(palm.place_m[d] + base_m[d], scenario.robot.base_place_m[d], 1e-9);
    EXPECT_NEAR(std::hypot(flange_m[0], flange_m[1], flange_m[2]), tool_m, 1e-9);
  }
}

TEST(ArmRun, IsJudgedOnceBesideScenariosWithoutAnArm) {
  Scenario stuck = carried_grip();
  stuck.robot.base_place_m = {-3.0, 0.0, 0.0};  // out of reach from the start
  Scenario free = testing::usual_grip();
  const ModelOrReason model = core_simulator().build(free);
  ASSERT_TRUE(model);
  const std::unique_ptr<LaneEngine> lanes = (*model)->make_lanes();
  lanes->load(0, stuck);
  lanes->load(1, free);
  int finished[2] = {0, 0};
  for (int step = 0; finished[1] == 0 && step < 100000; ++step) {
    lanes->step();
    for (const LaneEngine::Finished& done : lanes->finished()) ++finished[done.place];
  }
  EXPECT_EQ(finished[0], 1);
  EXPECT_EQ(finished[1], 1);
}

}  // namespace
}  // namespace unbruised::studies
