// Runs of grips that an arm carries: a rigid arm changes nothing, one that gives way shakes the product, and an
// emergency stop is as hard as its joints brake.

#include "core/motion/motion_plan.hpp"
#include "tests/core/robot/carried_grips.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario carried_fast() {
  Scenario scenario = carried_grip();
  scenario.cell.transfer_m = {0.0, 0.2};
  scenario.strategy.grip_force_N = 5.0;
  scenario.strategy.transfer_acceleration_m_s2 = 6.0;
  for (ArmJointParameters& joint : scenario.robot.joint) joint.torque_N_m = 1e5;
  return scenario;
}

TEST(CarriedRun, ARigidArmChangesNoBit) {
  Scenario alone = carried_fast();
  alone.robot = {};
  const std::vector<ScenarioResult> results = run_side_by_side({carried_fast(), alone});
  EXPECT_EQ(results[0].outcome, Outcome::held) << results[0].cause;
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const double with = results[0].metrics.values()[i], without = results[1].metrics.values()[i];
    EXPECT_TRUE(with == without || (std::isnan(with) && std::isnan(without))) << kMetricTable[i].name;
  }
}

TEST(CarriedRun, ASofterArmSwaysMoreAndLeavesLessMarginAgainstSliding) {
  std::vector<Scenario> arms;
  for (const double stiffness : {1e10, 3e4, 1e4}) {
    arms.push_back(carried_fast());
    arms.back().robot.stiffness_N_m_rad = {stiffness};
  }
  const std::vector<ScenarioResult> results = run_side_by_side(arms);
  const auto metric = [&](std::size_t i, Metric which) { return results[i].metrics[which]; };
  for (const ScenarioResult& result : results) EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  // So stiff it is as rigid, but for the frame in which the product's motion is computed, and its small rotations.
  const double rigid = run(carried_fast()).metrics[Metric::friction_margin_min];
  EXPECT_NEAR(metric(0, Metric::friction_margin_min), rigid, 0.01 * (1.0 + rigid));
  for (const std::size_t softer : {1U, 2U}) {
    EXPECT_GT(metric(softer, Metric::robot_sway_max_m), metric(softer - 1, Metric::robot_sway_max_m) + 1e-4);
    EXPECT_LT(metric(softer, Metric::friction_margin_min), metric(softer - 1, Metric::friction_margin_min));
    EXPECT_LT(std::abs(metric(softer, Metric::energy_balance_error)), 5e-3);
    EXPECT_LT(metric(softer, Metric::impulse_balance_error), 1e-8);
  }
  EXPECT_LT(metric(0, Metric::robot_sway_max_m), 1e-6);
}

TEST(CarriedRun, ALaneOfASwayingArmHasItsBitsWhateverRunsBesideIt) {
  Scenario soft = carried_fast();
  soft.robot.stiffness_N_m_rad = {1e4};
  soft.robot.bandwidth_Hz = {10.0};
  Scenario stiff = soft;
  stiff.robot.stiffness_N_m_rad = {5e4};
  const ScenarioResult alone = run(soft);
  const ScenarioResult beside = run_side_by_side({stiff, soft, stiff})[1];
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const double a = alone.metrics.values()[i], b = beside.metrics.values()[i];
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << kMetricTable[i].name;
  }
}

TEST(CarriedRun, AnEmergencyStopIsAsHardAsTheJointsBrake) {
  std::vector<Scenario> stops;
  for (const double deceleration : {8.0, 25.0}) {
    Scenario scenario = carried_fast();
    const MotionPlan plan = planned_motion(scenario);
    scenario.robot.deceleration_rad_s2 = {deceleration};
    scenario.strategy.stop_time_s = 0.5 * (plan.hold_end_s() + plan.level_start_s());
    stops.push_back(scenario);
  }
  const std::vector<ScenarioResult> results = run_side_by_side(stops);
  for (const ScenarioResult& result : results) EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_GT(results[1].metrics[Metric::peak_acceleration_m_s2],
            1.2 * results[0].metrics[Metric::peak_acceleration_m_s2]);
}

}  // namespace
}  // namespace unbruised
