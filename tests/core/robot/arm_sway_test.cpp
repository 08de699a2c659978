// Joints that lag and give way, against closed forms of one joint, and a palm on an arm of such joints.

#include "core/robot/arm_sway.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/robot/arm_carrier.hpp"
#include "core/robot/arm_ride.hpp"
#include "core/scenario/vectors.hpp"
#include "tests/core/robot/carried_grips.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kStep_s = 2e-3;

/// One link about z with the inertia I about its joint.
struct OneJoint {
  double m = 2.0, l = 0.4, I0 = 0.1;

  [[nodiscard]] double inertia_kg_m2() const { return I0 + 0.25 * m * l * l; }
  [[nodiscard]] RobotParameters robot(std::array<double, 3> axis = {0.0, 0.0, 1.0}) const {
    RobotParameters out;
    out.joint.resize(1);
    out.joint[0].axis = axis;
    out.joint[0].mass_kg = m;
    out.joint[0].center_of_mass_m = {0.5 * l, 0.0, 0.0};
    out.joint[0].inertia_kg_m2 = {I0, I0, I0, 0.0, 0.0, 0.0};
    out.tool_place_m = out.tool_rotation_rad = {};
    return out;
  }
};

ArmMotion turning(double angle, double speed, double acceleration = 0.0) {
  return {{angle}, {speed}, {acceleration}};
}

TEST(ArmSway, BehindARampALagStaysOfSpeedTimesTimeConstant) {
  RobotParameters robot = OneJoint{}.robot();
  robot.bandwidth_Hz = {8.0};
  const Arm arm(robot);
  const double tau = 1.0 / (2.0 * kPi * 8.0), speed = 1.5;
  // From rest: lag = speed tau (1 - exp(-t / tau)).
  ArmSway sway(arm, kStep_s, turning(0.0, 0.0), {});
  double t = 0.0;
  for (int i = 1; i <= 200; ++i) {
    t = i * kStep_s;
    const ArmMotion links = sway.follow(turning(speed * t, speed), {});
    // The speed rises within the first step, not at once: that is as if it came half a step late (and a sixth of
    // the square of what step and time constant make of it later).
    const double lag = speed * tau * (1.0 - std::exp(-t / tau));
    EXPECT_NEAR(speed * t - links.angle_rad[0], lag, 0.52 * speed * kStep_s * std::exp(-t / tau) + 1e-12);
  }
  EXPECT_NEAR(speed * t - sway.links().angle_rad[0], speed * tau, 1e-7);
  EXPECT_NEAR(sway.links().speed_rad_s[0], speed, 1e-6);
  // A motion that has gone on for long starts with that lag.
  const ArmSway steady(arm, kStep_s, turning(0.0, speed), {});
  EXPECT_DOUBLE_EQ(steady.links().angle_rad[0], -speed * tau);
}

TEST(ArmSway, AfterAJerkAJointRingsAtTheRootOfStiffnessOverInertia) {
  const OneJoint one;
  RobotParameters robot = one.robot();
  robot.stiffness_N_m_rad = {800.0};
  robot.damping_ratio = 0.04;
  const Arm arm(robot);
  const double omega = std::sqrt(800.0 / one.inertia_kg_m2()), ring = omega * std::sqrt(1.0 - 0.04 * 0.04);
  const double acceleration = 6.0;
  // Under an even acceleration it hangs back by I a / k.
  ArmSway sway(arm, kStep_s, turning(0.0, 0.0, acceleration), {});
  const double back = one.inertia_kg_m2() * acceleration / 800.0;
  EXPECT_NEAR(sway.links().angle_rad[0], -back, 1e-15);
  // The acceleration ends within one step h: e is what that ramp leaves, then rings freely. A ramp is as a step in
  // its middle, but for (omega h)^2 / 24 of it.
  double last = 0.0;
  std::vector<double> zeros;
  for (int i = 1; i <= 400; ++i) {
    const double t = i * kStep_s, since = t - 0.5 * kStep_s;
    const double e = sway.follow(turning(0.0, 0.0, 0.0), {}).angle_rad[0];
    const double wanted = -back * std::exp(-0.04 * omega * since) *
                          (std::cos(ring * since) + 0.04 * omega / ring * std::sin(ring * since));
    EXPECT_NEAR(e, wanted, back * omega * omega * kStep_s * kStep_s / 20.0);
    if (last != 0.0 && (last < 0.0) != (e < 0.0)) zeros.push_back(t - kStep_s * e / (e - last));
    last = e;
  }
  ASSERT_GT(zeros.size(), 8U);
  const double half_s = (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  EXPECT_NEAR(kPi / half_s, ring, 1e-3 * ring);
}

TEST(ArmSway, WhatRingsKeepsTheRatesOfItsAngles) {
  TwoLinks two;
  RobotParameters robot = two.robot();
  robot.stiffness_N_m_rad = {600.0, 200.0};
  robot.bandwidth_Hz = {12.0, 20.0};
  const Arm arm(robot);
  const double h = 2e-4;
  ArmSway sway(arm, h, {{0.3, 0.5}, {0.0, 0.0}, {0.0, 0.0}}, {});
  std::vector<ArmMotion> links;
  for (int i = 1; i <= 2000; ++i) {
    const double t = i * h, s = std::sin(9.0 * t), c = std::cos(9.0 * t);
    links.push_back(sway.follow(
        {{0.3 + 0.1 * (1.0 - c), 0.5 + 0.05 * (1.0 - c)}, {0.9 * s, 0.45 * s}, {8.1 * c, 4.05 * c}}, {}));
  }
  for (std::size_t i = 100; i + 1 < links.size(); i += 37) {
    for (std::size_t j = 0; j < 2; ++j) {
      // Central differences rest by h^2 / 6 of third rates of 1e3; modes that are found anew leave as little.
      EXPECT_NEAR((links[i + 1].angle_rad[j] - links[i - 1].angle_rad[j]) / (2.0 * h), links[i].speed_rad_s[j],
                  1e-4);
      EXPECT_NEAR((links[i + 1].speed_rad_s[j] - links[i - 1].speed_rad_s[j]) / (2.0 * h),
                  links[i].acceleration_rad_s2[j], 0.05);
    }
  }
}

TEST(ArmSway, TwoLinksRingInTheModesOfTheirMassMatrix) {
  const TwoLinks two;
  RobotParameters robot = two.robot();
  robot.stiffness_N_m_rad = {600.0, 200.0};
  robot.damping_ratio = 0.0;
  const Arm arm(robot);
  const double angle = 0.8, c = std::cos(angle);
  const double M22 = two.I2 + 0.25 * two.m2 * two.l2 * two.l2, M12 = M22 + 0.5 * two.m2 * two.l1 * two.l2 * c;
  const double M11 = two.I1 + 0.25 * two.m1 * two.l1 * two.l1 + two.m2 * two.l1 * two.l1 + 2.0 * M12 - M22;
  // det(K - omega^2 M) = 0.
  const double A = M11 * M22 - M12 * M12, B = -(600.0 * M22 + 200.0 * M11), C = 600.0 * 200.0;
  const double slow = std::sqrt((-B - std::sqrt(B * B - 4.0 * A * C)) / (2.0 * A));
  // Both joints hang back in the slower mode alone: M a is that of its shape.
  const double share = (600.0 - slow * slow * M11) / (slow * slow * M12);
  ArmSway sway(arm, kStep_s, {{0.0, angle}, {0.0, 0.0}, {1.0, share}}, {});
  std::vector<double> zeros;
  double last = 0.0;
  for (int i = 1; i <= 600; ++i) {
    const ArmMotion links = sway.follow({{0.0, angle}, {0.0, 0.0}, {0.0, 0.0}}, {});
    const double e = links.angle_rad[0];
    EXPECT_NEAR(links.angle_rad[1] - angle, share * e, 1e-12) << "the other mode stays still";
    if (last != 0.0 && (last < 0.0) != (e < 0.0)) zeros.push_back((i - e / (e - last)) * kStep_s);
    last = e;
  }
  ASSERT_GT(zeros.size(), 4U);
  const double half_s = (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  EXPECT_NEAR(kPi / half_s, slow, 1e-3 * slow);
}

TEST(ArmSway, AtRestWeightIsTakenOutAndNothingHangs) {
  RobotParameters robot = OneJoint{}.robot({0.0, 1.0, 0.0});
  robot.stiffness_N_m_rad = {500.0};
  robot.bandwidth_Hz = {5.0};
  const Arm arm(robot);
  ArmSway sway(arm, kStep_s, turning(0.2, 0.0), {{1.0, {0.3, 0.0, 0.0}}});
  for (int i = 0; i < 50; ++i) {
    const ArmMotion links = sway.follow(turning(0.2, 0.0), {{2.0, {0.3, 0.0, 0.0}}});
    EXPECT_EQ(links.angle_rad[0], 0.2);
    EXPECT_EQ(links.speed_rad_s[0], 0.0);
  }
}

double distance_m(const PalmState& a, const PalmState& b) { return length(between(a.position_m, b.position_m)); }

/// As a run has it.
MotionPlan tracked_plan(const Scenario& scenario) {
  const auto carrier = arm_carrier(scenario);
  const MotionPlan plan = planned_motion(scenario, carrier.get());
  return plan.tracked(carrier->track(plan));
}

Scenario soft_grip(double stiffness, double bandwidth_Hz) {
  Scenario scenario = carried_grip();
  scenario.cell.transfer_m = {0.0, 0.3};
  scenario.strategy.transfer_acceleration_m_s2 = 5.0;
  scenario.robot.stiffness_N_m_rad = {stiffness};
  if (bandwidth_Hz > 0.0) scenario.robot.bandwidth_Hz = {bandwidth_Hz};
  return scenario;
}

TEST(PalmOnASwayingArm, GoesAsPlannedUntilTheLiftAndComesToRestWhereItShould) {
  const Scenario scenario = soft_grip(2e4, 10.0);
  const MotionPlan plan = tracked_plan(scenario);
  ASSERT_TRUE(plan.has_track());
  EXPECT_EQ(plan.palm(plan.lift_start_s()), plan.told_palm(plan.lift_start_s()));
  double most_m = 0.0, before = 0.0;
  for (double t = plan.lift_start_s(); t < plan.end_s(); t += 1e-3) {
    const PalmState palm = plan.palm(t);
    most_m = std::max(most_m, distance_m(palm, plan.told_palm(t)));
    const double now = length(palm.acceleration_m_s2);
    if (t > plan.lift_start_s()) {
      EXPECT_LT(std::abs(now - before), 1.0) << "the acceleration does not jump, at " << t;
    }
    before = now;
  }
  // Speeds of 0.7 m/s and a lag of 16 ms.
  EXPECT_GT(most_m, 5e-3);
  EXPECT_LT(most_m, 2e-2);
  // What still rings 0.3 s after the lowering, of modes of 15 Hz and a damping ratio of 0.05.
  EXPECT_LT(distance_m(plan.palm(plan.end_s()), plan.told_palm(plan.end_s())), 1e-4);
}

TEST(PalmOnASwayingArm, GoesAsPlannedWhereTheArmIsStiffAndQuick) {
  const MotionPlan plan = tracked_plan(soft_grip(1e11, 1e6));
  for (double t = 0.0; t < plan.end_s(); t += 3.1e-3) {
    const PalmState palm = plan.palm(t), told = plan.told_palm(t);
    // 0.16 us of lag at 0.7 m/s.
    EXPECT_LT(distance_m(palm, told), 2e-7);
    EXPECT_LT(angle_between_rad(attitude_of(palm.rotation_rad), attitude_of(told.rotation_rad)), 1e-6);
    // Between knots of 2 ms; at the ends of a motion its jerk jumps.
    EXPECT_LT(length(between(palm.acceleration_m_s2, told.acceleration_m_s2)), 0.15);
  }
}

TEST(PalmOnASwayingArm, ThatIsRigidHasNoTrack) {
  const Scenario scenario = carried_grip();
  const auto carrier = arm_carrier(scenario);
  const MotionPlan plan = planned_motion(scenario, carrier.get());
  EXPECT_EQ(carrier->track(plan), nullptr);
  for (double t = 0.0; t < plan.end_s(); t += 0.01) EXPECT_EQ(plan.palm(t), planned_motion(scenario).palm(t));
}

TEST(PalmOnASwayingArm, WithABeltLagsByTheSpeedTimesTheTimeConstant) {
  Scenario scenario = soft_grip(1e9, 10.0);
  scenario.cell.conveyor.speed_m_s = 0.1;
  scenario.cell.conveyor.direction = {0.0, 1.0};
  scenario.strategy.pick = PickKind::tracking;
  const MotionPlan plan = tracked_plan(scenario);
  ASSERT_TRUE(plan.goes_with_belt());
  const double lag_m = 0.1 / (2.0 * kPi * 10.0);
  for (const double t : {0.0, 0.5 * plan.lift_start_s(), plan.lift_start_s()}) {
    const double behind_m = plan.told_palm(t).position_m[1] - plan.palm(t).position_m[1];
    // Joints that turn by 0.1 rad/s on an arm of half a metre: its bend is second order in the lag.
    EXPECT_NEAR(behind_m, lag_m, 0.01 * lag_m) << t;
  }
  // Before the fingers have met the product nobody knows the lift; the palm is where it will have been.
  const auto carrier = arm_carrier(scenario);
  const MotionPlan approach(scenario, kNever, kNever, carrier.get());
  const MotionPlan waiting = approach.tracked(carrier->track(approach));
  const double t = 0.4 * plan.lift_start_s();
  EXPECT_EQ(waiting.palm(t), plan.palm(t));
}

}  // namespace
}  // namespace unbruised
