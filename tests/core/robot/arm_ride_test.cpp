// An arm along the palm's path of a scenario: it follows, its torques do the work, it stops where it must, and a
// path that is too fast for it is slowed down by no more than that takes.

#include <algorithm>

#include <gtest/gtest.h>

#include "core/robot/arm_timing.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "tests/core/robot/carried_grips.hpp"

namespace unbruised {
namespace {

using namespace testing;

void make_strong(RobotParameters& robot) {
  for (ArmJointParameters& joint : robot.joint) {
    joint.speed_rad_s = 1e6;
    joint.torque_N_m = 1e9;
  }
}

TEST(ArmRide, ThePalmIsWhereThePlanHasIt) {
  const Scenario scenario = carried_grip();
  const MotionPlan plan = planned_motion(scenario);
  const ArmRide found = ride(scenario, plan);
  ASSERT_FALSE(found.breach) << words_of(*found.breach);
  ASSERT_GT(found.samples.size(), 200U);
  const Arm arm(scenario.robot);
  for (const ArmSample& sample : found.samples) {
    const Pose wanted = palm_pose(scenario, plan.palm(sample.time_s)), is = arm.palm(sample.motion.angle_rad);
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(is.place_m[d], wanted.place_m[d], 1e-10);
    EXPECT_LT(angle_between_rad(is.attitude, wanted.attitude), 1e-7);
  }
}

TEST(ArmRide, SpeedsAndAccelerationsAreDerivativesOfTheAngles) {
  Scenario scenario = carried_grip();
  scenario.strategy.tilt_rad = {0.0, 0.4, 0.0};
  const MotionPlan plan = planned_motion(scenario);
  const double h = 1e-4;
  for (const double share : {0.1, 0.35, 0.6, 0.85}) {
    const double t = plan.lift_start_s() + share * (plan.lower_end_s() - plan.lift_start_s());
    const auto three = ride_at(scenario, plan, {t - h, t, t + h});
    ASSERT_EQ(three.size(), 3U);
    for (std::size_t j = 0; j < 6; ++j) {
      const auto q = [&](std::size_t i) { return three[i].motion.angle_rad[j]; };
      // Angles agree within 1e-10 / (smallest singular value): that over h, and h^2.
      EXPECT_NEAR(three[1].motion.speed_rad_s[j], (q(2) - q(0)) / (2.0 * h), 2e-5);
      const auto v = [&](std::size_t i) { return three[i].motion.speed_rad_s[j]; };
      EXPECT_NEAR(three[1].motion.acceleration_rad_s2[j], (v(2) - v(0)) / (2.0 * h), 1e-4);
    }
  }
}

TEST(ArmRide, TheWorkOfTheTorquesIsWhatArmGripperAndProductGain) {
  Scenario scenario = carried_grip();
  scenario.cell.place_height_m = 0.05;
  make_strong(scenario.robot);
  const MotionPlan plan = planned_motion(scenario);
  const double from_s = plan.lift_start_s(), to_s = plan.lower_end_s();
  const int n = 4000;
  std::vector<double> times;
  for (int i = 0; i <= n; ++i) times.push_back(from_s + (to_s - from_s) * i / n * (1.0 - 1e-12));
  const auto samples = ride_at(scenario, plan, times);
  ASSERT_EQ(samples.size(), times.size());
  double work = 0.0;
  for (int i = 0; i <= n; ++i) {
    const ArmSample& s = samples[static_cast<std::size_t>(i)];
    double power = 0.0;
    for (std::size_t j = 0; j < 6; ++j) power += s.torque_N_m[j] * s.motion.speed_rad_s[j];
    work += power * (i == 0 || i == n ? 0.5 : 1.0) * (to_s - from_s) / n;
  }
  const Arm arm(scenario.robot);
  const auto energy = [&](const ArmSample& s) {
    const ArmEnergy e = arm_energy(arm, s.motion, flange_loads(scenario, true), scenario.cell.gravity_m_s2);
    return e.kinetic_J + e.potential_J;
  };
  const double gained = energy(samples.back()) - energy(samples.front());
  EXPECT_GT(gained, 0.5);
  // The trapezoidal rule over 4000 parts of a smooth power that is 0 at both ends.
  EXPECT_NEAR(work, gained, 1e-4);
}

/// How far the wrist of `six_joints` is from its shoulder, and how far it can be.
double wrist_way_m(const Scenario& scenario, const PalmState& palm) {
  const RobotParameters& robot = scenario.robot;
  const Pose tool = pose_of(robot.tool_place_m, robot.tool_rotation_rad);
  const Pose flange = palm_pose(scenario, palm) * inverse(tool);
  const Pose wrist = flange * Pose{{0.0, 0.0, -0.08}, {}};
  const auto& base = robot.base_place_m;
  const double across = std::hypot(wrist.place_m[0] - base[0], wrist.place_m[1] - base[1]) - 0.02;
  return std::hypot(across, wrist.place_m[2] - base[2] - 0.4);
}

TEST(ArmRide, APathBeyondTheReachFailsWhenTheElbowIsStraight) {
  Scenario scenario = carried_grip();
  make_strong(scenario.robot);
  scenario.cell.transfer_m = {0.0, 1.2};
  const double reach_m = 0.45 + std::hypot(0.43, 0.03);
  const MotionPlan plan = planned_motion(scenario);
  double good_s = plan.hold_end_s(), stuck_s = plan.lower_end_s();
  ASSERT_LT(wrist_way_m(scenario, plan.palm(good_s)), reach_m);
  ASSERT_GT(wrist_way_m(scenario, plan.palm(stuck_s)), reach_m);
  for (int i = 0; i < 60; ++i) {
    const double middle_s = 0.5 * (good_s + stuck_s);
    (wrist_way_m(scenario, plan.palm(middle_s)) < reach_m ? good_s : stuck_s) = middle_s;
  }
  const ArmRide found = ride(scenario, plan);
  ASSERT_TRUE(found.breach);
  EXPECT_TRUE(found.breach->limit == ArmLimit::reach || found.breach->limit == ArmLimit::singular);
  // Singular is called what is within 1e-3 of it: microns, and the palm goes 1 m/s.
  EXPECT_NEAR(found.breach->time_s, stuck_s, 1e-3);
}

TEST(ArmRide, AStartBeyondTheReachFailsAtOnce) {
  Scenario scenario = carried_grip();
  scenario.robot.base_place_m = {-2.5, 0.0, 0.0};
  const ArmRide found = ride(scenario, planned_motion(scenario));
  ASSERT_TRUE(found.breach);
  EXPECT_EQ(found.breach->limit, ArmLimit::reach);
  EXPECT_EQ(found.breach->time_s, 0.0);
  EXPECT_EQ(words_of(*found.breach), "the palm is out of the arm's reach");
}

TEST(ArmRide, TheFirstLimitThatBreaksIsNamedWithItsTime) {
  Scenario scenario = carried_grip();
  make_strong(scenario.robot);
  const MotionPlan plan = planned_motion(scenario);
  const ArmRide strong = ride(scenario, plan);
  ASSERT_FALSE(strong.breach);
  double most = 0.0;
  for (const ArmSample& s : strong.samples) most = std::max(most, std::abs(s.motion.speed_rad_s[0]));
  scenario.robot.joint[0].speed_rad_s = 0.5 * most;
  const ArmRide found = ride(scenario, plan);
  ASSERT_TRUE(found.breach);
  EXPECT_EQ(found.breach->limit, ArmLimit::speed);
  EXPECT_EQ(found.breach->joint, 0);
  EXPECT_NEAR(found.speed.use, 2.0, 1e-9);
  const auto then = ride_at(scenario, plan, {found.breach->time_s});
  ASSERT_EQ(then.size(), 1U);
  // The time is halved down to 0.3 us.
  EXPECT_NEAR(std::abs(then[0].motion.speed_rad_s[0]), 0.5 * most, 1e-4 * most);
}

TEST(ArmRide, APayloadBeyondTheArmsIsRefusedAtTheLift) {
  Scenario scenario = carried_grip();
  scenario.robot.max_payload_kg = 0.5;
  const MotionPlan plan = planned_motion(scenario);
  const ArmRide found = ride(scenario, plan);
  ASSERT_TRUE(found.breach);
  EXPECT_EQ(found.breach->limit, ArmLimit::payload);
  EXPECT_EQ(found.breach->time_s, plan.lift_start_s());
  EXPECT_EQ(words_of(*found.breach), "gripper and product are 1.8 of robot.max_payload_kg");
}

/// The usual grip in haste, for an arm with this much of its speeds and torques.
Scenario hasty(double speed, double torque) {
  Scenario scenario = carried_grip();
  scenario.strategy.lift_acceleration_m_s2 = 20.0;
  scenario.strategy.speed_m_s = 5.0;
  for (ArmJointParameters& joint : scenario.robot.joint) {
    joint.speed_rad_s *= speed;
    joint.torque_N_m *= torque;
  }
  scenario.robot.timing = RobotTiming::fit;
  return scenario;
}

TEST(ArmTiming, APathThatIsTooFastIsSlowedDownUntilALimitIsJustKept) {
  for (const auto& [speed, torque] : {std::pair{0.3, 10.0}, std::pair{10.0, 0.45}}) {
    const Scenario scenario = hasty(speed, torque);
    ASSERT_TRUE(ride(scenario, planned_motion(scenario)).breach);
    const TimedScenario timed = timed_for_arm(scenario);
    ASSERT_FALSE(timed.ride.breach) << words_of(*timed.ride.breach);
    const double use = std::max(timed.ride.speed.use, timed.ride.torque.use);
    EXPECT_LE(use, 1.0 + 1e-9);
    // The peaks of the path lie between samples of 4 ms: a stretch is at most 1e-3 larger than needed.
    EXPECT_GT(use, 0.998);
  }
}

TEST(ArmTiming, AFittedMotionIsTheSameButForItsTime) {
  const Scenario scenario = hasty(0.3, 10.0);
  const MotionPlan fast = planned_motion(scenario);
  const ArmRide hurried = ride(scenario, fast);
  const TimedScenario timed = timed_for_arm(scenario);
  const MotionPlan slow = planned_motion(timed.scenario);
  const double stretch = hurried.need[static_cast<std::size_t>(ArmLeg::carry)].stretch;
  ASSERT_GT(stretch, 1.1);
  const double fast_s = fast.level_start_s() - fast.hold_end_s(),
               slow_s = slow.level_start_s() - slow.hold_end_s();
  EXPECT_NEAR(slow_s / fast_s, stretch, 2e-3 * stretch);
}

TEST(ArmTiming, AnArmThatCanIsLeftAlone) {
  Scenario scenario = carried_grip();
  scenario.robot.timing = RobotTiming::fit;
  const TimedScenario timed = timed_for_arm(scenario);
  EXPECT_FALSE(timed.ride.breach);
  EXPECT_FALSE(timed.scenario.strategy.transfer_acceleration_m_s2);
  EXPECT_EQ(timed.scenario.strategy.lift_acceleration_m_s2, scenario.strategy.lift_acceleration_m_s2);
}

TEST(ArmTiming, WhatWeightAloneBreaksStaysBroken) {
  const TimedScenario timed = timed_for_arm(hasty(1.0, 0.02));
  ASSERT_TRUE(timed.ride.breach);
  EXPECT_EQ(timed.ride.breach->limit, ArmLimit::torque);
}

TEST(ArmTiming, SlowingATrapezoidOrAnSCurveKeepsTheLimitsToo) {
  for (const ProfileKind profile : {ProfileKind::trapezoid, ProfileKind::s_curve}) {
    Scenario scenario = hasty(0.3, 10.0);
    scenario.strategy.profile = profile;
    scenario.strategy.jerk_m_s3 = 400.0;
    const TimedScenario timed = timed_for_arm(scenario);
    ASSERT_FALSE(timed.ride.breach) << words_of(*timed.ride.breach);
    EXPECT_GT(timed.ride.speed.use, 0.9);
  }
}

TEST(ArmRide, TheLargestJerkOfAJointIsThatOfItsAngle) {
  Scenario scenario = carried_grip();
  make_strong(scenario.robot);
  scenario.robot.jerk_rad_s3 = {1e9};
  const MotionPlan plan = planned_motion(scenario);
  const ArmRide found = ride(scenario, plan);
  ASSERT_FALSE(found.breach);
  const auto joint = static_cast<std::size_t>(found.jerk.joint);
  const double h = 2e-5, t = found.jerk.time_s;
  const auto near = ride_at(scenario, plan, {t - 2.0 * h, t - h, t, t + h, t + 2.0 * h});
  ASSERT_EQ(near.size(), 5U);
  const auto q2 = [&](std::size_t i) { return near[i].motion.acceleration_rad_s2[joint]; };
  const double before = std::abs(q2(2) - q2(1)) / h, after = std::abs(q2(3) - q2(2)) / h;
  EXPECT_NEAR(found.jerk.use * 1e9, std::max(before, after), 1e-3 * std::max(before, after));
  EXPECT_GT(found.jerk.use * 1e9, 10.0);
}

TEST(ArmRide, AJerkBeyondItsLimitIsNamed) {
  Scenario scenario = carried_grip();
  make_strong(scenario.robot);
  scenario.robot.jerk_rad_s3 = {1e9};
  const double most = 1e9 * ride(scenario, planned_motion(scenario)).jerk.use;
  scenario.robot.jerk_rad_s3 = {0.5 * most};
  const ArmRide found = ride(scenario, planned_motion(scenario));
  ASSERT_TRUE(found.breach);
  EXPECT_EQ(found.breach->limit, ArmLimit::jerk);
  EXPECT_NE(words_of(*found.breach).find("of its jerk"), std::string::npos);
  EXPECT_EQ(found.binding().limit, ArmLimit::jerk);
}

TEST(ArmTiming, AJerkLimitIsKeptByTheLeastStretchOfMinimumJerk) {
  Scenario scenario = hasty(10.0, 10.0);
  scenario.robot.jerk_rad_s3 = {1e9};
  const double most = 1e9 * ride(scenario, planned_motion(scenario)).jerk.use;
  const double planned_s = ride(scenario, planned_motion(scenario)).moving_s;
  scenario.robot.jerk_rad_s3 = {most / 8.0};
  const TimedScenario timed = timed_for_arm(scenario);
  ASSERT_FALSE(timed.ride.breach) << words_of(*timed.ride.breach);
  EXPECT_LE(timed.ride.jerk.use, 1.0 + 1e-9);
  EXPECT_GT(timed.ride.jerk.use, 0.99);
  // The leg with the largest jerk takes twice as long, the others less than that.
  EXPECT_GT(timed.ride.moving_s, 1.2 * planned_s);
  EXPECT_LT(timed.ride.moving_s, 2.01 * planned_s);
}

TEST(ArmTiming, AJerkLimitSoftensAnSCurve) {
  Scenario scenario = hasty(10.0, 10.0);
  scenario.strategy.profile = ProfileKind::s_curve;
  scenario.strategy.jerk_m_s3 = 400.0;
  scenario.robot.jerk_rad_s3 = {1e9};
  const double most = 1e9 * ride(scenario, planned_motion(scenario)).jerk.use;
  scenario.robot.jerk_rad_s3 = {most / 3.0};
  const TimedScenario timed = timed_for_arm(scenario);
  ASSERT_FALSE(timed.ride.breach) << words_of(*timed.ride.breach);
  EXPECT_LT(*timed.scenario.strategy.jerk_m_s3, 200.0);
  EXPECT_GT(timed.ride.jerk.use, 0.9);
}

TEST(ArmTiming, APathThatLeavesTheReachIsNotSlowedDownForIt) {
  Scenario scenario = hasty(0.3, 10.0);
  scenario.cell.transfer_m = {0.0, 2.0};
  const MotionPlan plan = planned_motion(scenario);
  const ArmRide planned = ride(scenario, plan);
  ASSERT_TRUE(planned.breach);
  EXPECT_EQ(planned.breach->limit, ArmLimit::speed) << "which time alone would mend";
  const TimedScenario timed = timed_for_arm(scenario);
  ASSERT_TRUE(timed.ride.breach);
  EXPECT_TRUE(timed.ride.breach->limit == ArmLimit::reach || timed.ride.breach->limit == ArmLimit::singular);
  EXPECT_GT(timed.ride.breach->time_s, plan.hold_end_s());
  EXPECT_LT(timed.ride.breach->time_s, plan.level_start_s());
  EXPECT_FALSE(timed.scenario.strategy.transfer_acceleration_m_s2);
  EXPECT_EQ(timed.slowed_s, 0.0);
}

TEST(ArmTiming, HalfOfALimitIsKeptWhereSoMuchMayBeUsed) {
  Scenario scenario = hasty(0.5, 10.0);
  scenario.robot.use_most = 0.5;
  const TimedScenario timed = timed_for_arm(scenario);
  ASSERT_FALSE(timed.ride.breach) << words_of(*timed.ride.breach);
  EXPECT_LE(timed.ride.speed.use, 0.5 + 1e-9);
  EXPECT_GT(timed.ride.speed.use, 0.498);
}

}  // namespace
}  // namespace unbruised
