// An emergency stop of an arm: one joint in closed form, and a palm that stays on its path.

#include "core/robot/arm_stop.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/robot/arm_carrier.hpp"
#include "core/robot/arm_ride.hpp"
#include "core/scenario/vectors.hpp"
#include "tests/core/robot/carried_grips.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A rod of 2 kg and 0.6 m that turns about z at one end.
Arm rod(double torque_N_m) {
  RobotParameters robot;
  robot.joint.resize(1);
  robot.joint[0].mass_kg = 2.0;
  robot.joint[0].center_of_mass_m = {0.3, 0.0, 0.0};
  robot.joint[0].inertia_kg_m2 = {0.0, 0.06, 0.06, 0.0, 0.0, 0.0};
  robot.joint[0].torque_N_m = torque_N_m;
  return Arm(robot);
}
constexpr double kRod_kg_m2 = 2.0 * 0.6 * 0.6 / 3.0;
constexpr std::array<double, 3> kDown = {0.0, 0.0, -9.81};

/// Turns evenly.
ArmPath even(double speed) {
  return [speed](double s) { return PathMotion{{{speed * s}, {speed}, {0.0}}, {}}; };
}

TEST(ArmStop, TakesSpeedOverDeceleration) {
  RobotParameters robot = rod(1e6).robot();
  robot.acceleration_rad_s2 = {10.0};
  const auto gentle = arm_stop(Arm(robot), even(1.6), 0.3, kDown);
  ASSERT_TRUE(gentle);
  EXPECT_NEAR(gentle->duration_s(), 1.6 / 10.0, 1e-12);
  EXPECT_NEAR(gentle->at(1.0).plan_s, 0.3 + 0.5 * 0.16, 1e-12) << "half of what it would have gone";
  robot.deceleration_rad_s2 = {40.0};
  EXPECT_NEAR(arm_stop(Arm(robot), even(1.6), 0.3, kDown)->duration_s(), 1.6 / 40.0, 1e-12);
}

TEST(ArmStop, TakesMomentumOverTorqueWhereNothingElseIsLimited) {
  const auto law = arm_stop(rod(3.0), even(2.0), 0.0, kDown);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->duration_s(), kRod_kg_m2 * 2.0 / 3.0, 1e-9);
}

TEST(ArmStop, OfAnArmAtRestIsOver) {
  const auto law = arm_stop(rod(3.0), even(0.0), 0.7, kDown);
  ASSERT_TRUE(law);
  EXPECT_EQ(law->duration_s(), 0.0);
  EXPECT_EQ(law->at(0.1).plan_s, 0.7);
  EXPECT_EQ(law->at(0.1).rate, 0.0);
}

TEST(ArmStop, KeepsTheDecelerationOnAPathThatHastens) {
  RobotParameters robot = rod(1e6).robot();
  robot.deceleration_rad_s2 = {20.0};
  const ArmPath path = [](double s) { return PathMotion{{{s + 3.0 * s * s}, {1.0 + 6.0 * s}, {6.0}}, {}}; };
  const auto law = arm_stop(Arm(robot), path, 0.0, kDown);
  ASSERT_TRUE(law);
  // Of the joint, whatever its path does: 1 rad/s over 20 rad/s2; parts of the stop keep it within 1 / 60.
  EXPECT_NEAR(law->duration_s(), 1.0 / 20.0, 0.02 / 20.0);
  for (double t = 0.0; t < law->duration_s(); t += 1e-3) {
    const StopLaw::State s = law->at(t);
    EXPECT_GT((1.0 + 6.0 * s.plan_s) * s.change_1_s + 6.0 * s.rate * s.rate, -20.0 * 1.01);
  }
}

TEST(ArmStop, OfAPathThatEndsIsNotKnown) {
  const ArmPath nowhere = [](double) { return std::optional<PathMotion>{}; };
  EXPECT_FALSE(arm_stop(rod(3.0), nowhere, 0.0, kDown));
}

/// On an arc, which straight braking would leave.
Scenario on_an_arc(double deceleration_rad_s2) {
  Scenario scenario = carried_grip();
  scenario.strategy.waypoint = {{.place_m = std::array<double, 3>{0.0, 0.3, scenario.cell.lift_height_m},
                                 .via_m = std::array<double, 3>{0.1, 0.15, scenario.cell.lift_height_m}}};
  scenario.strategy.transfer_acceleration_m_s2 = 4.0;
  for (ArmJointParameters& joint : scenario.robot.joint) joint.torque_N_m = 1e4;
  scenario.robot.deceleration_rad_s2 = {deceleration_rad_s2};
  return scenario;
}

TEST(ArmStop, OfAPalmStaysOnItsPathAndUsesWhatTheJointsHave) {
  Scenario scenario = on_an_arc(15.0);
  const auto carrier = arm_carrier(scenario);
  const MotionPlan free = planned_motion(scenario, carrier.get());
  const double stop_s = 0.5 * (free.lift_end_s() + free.hold_start_s());
  scenario.strategy.stop_time_s = stop_s;
  const auto stopping = arm_carrier(scenario);
  const MotionPlan plan = planned_motion(scenario, stopping.get());
  const double rest_s = plan.end_s() - 0.3;  // watched for 0.3 s after it
  ASSERT_GT(rest_s, stop_s + 0.02);
  EXPECT_EQ(plan.palm(stop_s), free.palm(stop_s));
  double way_s = stop_s;
  for (double t = stop_s; t < rest_s + 0.1; t += 1e-3) {
    const PalmState palm = plan.palm(t);
    while (way_s < free.hold_start_s() && length(between(free.palm(way_s + 1e-4).position_m, palm.position_m)) <
                                              length(between(free.palm(way_s).position_m, palm.position_m)))
      way_s += 1e-4;
    // The nearest of places 0.1 ms apart at 0.7 m/s.
    EXPECT_LT(length(between(free.palm(way_s).position_m, palm.position_m)), 5e-5);
  }
  EXPECT_EQ(length(plan.palm(rest_s + 0.01).velocity_m_s), 0.0);
  const ArmRide found = ride(scenario, plan);
  EXPECT_FALSE(found.breach) << words_of(*found.breach);
  EXPECT_GT(found.acceleration.use, 0.98);
  EXPECT_LT(found.acceleration.use, 1.01);
  EXPECT_GT(found.acceleration.time_s, stop_s);
}

TEST(ArmStop, IsShorterWhereTheJointsBrakeHarder) {
  const auto stopped_m = [](double deceleration_rad_s2) {
    Scenario scenario = on_an_arc(deceleration_rad_s2);
    const auto carrier = arm_carrier(scenario);
    const MotionPlan free = planned_motion(scenario, carrier.get());
    const double stop_s = 0.5 * (free.lift_end_s() + free.hold_start_s());
    scenario.strategy.stop_time_s = stop_s;
    return planned_motion(scenario, arm_carrier(scenario).get()).end_s() - 0.3 - stop_s;
  };
  // The path's own acceleration is small beside that in the middle of a leg.
  EXPECT_NEAR(stopped_m(15.0) / stopped_m(30.0), 2.0, 0.2);
}

TEST(ArmStop, BeforeTheLiftThePalmStays) {
  Scenario scenario = carried_grip();
  scenario.strategy.stop_time_s = 0.5 * planned_motion(scenario).lift_start_s();
  const MotionPlan plan = planned_motion(scenario, arm_carrier(scenario).get());
  EXPECT_EQ(plan.palm(plan.end_s()), plan.palm(0.0));
  EXPECT_EQ(plan.end_s(), *scenario.strategy.stop_time_s + 0.3);
}

}  // namespace
}  // namespace unbruised
