// The phase machine and its plan: what the first contact fixes, and where the palm is when.

#include "core/motion/handling_cycle.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

/// Round numbers, so that the times of the plan can be added up by hand.
Scenario scene() {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).stroke_m = 0.04;
  jaw_of(scenario).drive_gain_N_s_m = 100.0;
  scenario.cell.approach_gap_m = 0.01;
  scenario.cell.lift_height_m = 0.1;
  scenario.cell.transfer_m = {0.3, 0.4};
  scenario.cell.place_height_m = 0.02;
  StrategyParameters& s = scenario.strategy;
  s.profile = ProfileKind::trapezoid;
  s.approach_speed_m_s = 0.05;
  s.contact_force_N = 0.5;
  s.grip_force_N = 2.5;
  s.grip_ramp_s = 0.2;
  s.settle_s = 0.1;
  s.lift_acceleration_m_s2 = 1.6;
  s.speed_m_s = 10.0;  // never reached: a way L takes 2 sqrt(L / a)
  s.hold_s = 0.5;
  s.release_height_m = 0.01;
  s.place_settle_s = 0.05;
  s.release_speed_m_s = 0.1;
  s.recover_s = 0.3;
  return scenario;
}

double way_s(double distance_m) { return 2.0 * std::sqrt(distance_m / 1.6); }

/// Times are sums of some ten numbers of order one: round-off only.
constexpr double kSum = 1e-14;

TEST(HandlingCycle, ApproachesUntilTheFirstContactWhichFixesEverything) {
  HandlingCycle cycle(scene());
  EXPECT_EQ(cycle.observe(1.0, std::nullopt), CycleEvent::none);
  EXPECT_EQ(cycle.phase(100.0), CyclePhase::approach);
  EXPECT_EQ(cycle.plan().end_s(), kNever);
  EXPECT_FALSE(cycle.has_contact());
  cycle.observe(2.0, 1.5);
  EXPECT_EQ(cycle.first_contact_s(), 1.5);
  const MotionPlan& plan = cycle.plan();
  EXPECT_NEAR(plan.lift_start_s(), 1.8, kSum);
  EXPECT_NEAR(plan.lift_end_s(), 1.8 + way_s(0.1), kSum);
  EXPECT_NEAR(plan.hold_end_s(), plan.lift_end_s() + 0.5, kSum);
  EXPECT_NEAR(plan.lower_end_s(), plan.hold_end_s() + way_s(0.5) + way_s(0.07), kSum);
  EXPECT_NEAR(plan.release_start_s(), plan.lower_end_s() + 0.05, kSum);
  EXPECT_NEAR(plan.release_end_s(), plan.release_start_s() + 0.1, kSum);
  EXPECT_NEAR(plan.end_s(), plan.release_end_s() + 0.3, kSum);
  cycle.observe(3.0, 2.5);
  EXPECT_EQ(cycle.first_contact_s(), 1.5) << "a later contact changes nothing";
}

TEST(HandlingCycle, TellsTheStartOfTheLiftOnce) {
  HandlingCycle cycle(scene());
  EXPECT_EQ(cycle.observe(1.0, 1.0), CycleEvent::none);
  EXPECT_EQ(cycle.observe(1.29, std::nullopt), CycleEvent::none);
  EXPECT_FALSE(cycle.lift_started());
  EXPECT_EQ(cycle.observe(1.31, std::nullopt), CycleEvent::lift_started);
  EXPECT_TRUE(cycle.lift_started());
  EXPECT_EQ(cycle.observe(1.32, std::nullopt), CycleEvent::none);
}

TEST(HandlingCycle, ARampFromTheStartIsPlannedBeforeAnyContact) {
  Scenario scenario = scene();
  scenario.strategy.ramp_from_start = true;
  HandlingCycle cycle(scenario);
  EXPECT_NEAR(cycle.plan().lift_start_s(), 0.3, kSum);
  cycle.observe(0.1, 0.1);
  EXPECT_NEAR(cycle.plan().lift_start_s(), 0.3, kSum) << "the contact does not move the plan";
  EXPECT_EQ(cycle.phase(0.05), CyclePhase::approach);
  EXPECT_EQ(cycle.phase(0.2), CyclePhase::grip);
}

TEST(HandlingCycle, GoesThroughThePhasesInTheirOrder) {
  HandlingCycle cycle(scene());
  cycle.observe(1.0, 1.0);
  const MotionPlan& plan = cycle.plan();
  const double tiny = 1e-6;
  EXPECT_EQ(cycle.phase(1.0 - tiny), CyclePhase::approach);
  EXPECT_EQ(cycle.phase(1.0), CyclePhase::grip);
  EXPECT_EQ(cycle.phase(plan.lift_start_s()), CyclePhase::lift);
  EXPECT_EQ(cycle.phase(plan.lift_end_s()), CyclePhase::hold);
  EXPECT_EQ(cycle.phase(plan.hold_end_s()), CyclePhase::transfer);
  EXPECT_EQ(cycle.phase(plan.lower_end_s()), CyclePhase::lower);
  EXPECT_EQ(cycle.phase(plan.release_start_s()), CyclePhase::release);
  EXPECT_EQ(cycle.phase(plan.release_end_s()), CyclePhase::recover);
}

TEST(HandlingCycle, GivesUpAfterTwiceTheStrokeAndASecond) {
  EXPECT_DOUBLE_EQ(HandlingCycle(scene()).approach_deadline_s(), 2.0 * 0.04 / 0.05 + 1.0);
}

Scenario guarded(GuardKind kind) {
  Scenario scenario = scene();
  scenario.strategy.guard = kind;
  scenario.strategy.guard_speed_m_s = 0.01;
  return scenario;
}

TEST(HandlingCycle, SlowsDownWhenAGuardSeesTheProductAndGripsWhenItTouches) {
  HandlingCycle cycle(guarded(GuardKind::range));
  cycle.observe(1.0, std::nullopt, std::nullopt);
  EXPECT_EQ(cycle.plan().set_speed_m_s(1.1), 0.05);
  cycle.observe(1.001, std::nullopt, 1.0);
  EXPECT_EQ(cycle.plan().set_speed_m_s(1.1), 0.01);
  EXPECT_FALSE(cycle.grip_started());
  cycle.observe(1.5, 1.5, 1.0);
  EXPECT_TRUE(cycle.grip_started());
  EXPECT_NEAR(cycle.plan().lift_start_s(), 1.8, kSum);
  EXPECT_EQ(cycle.plan().set_speed_m_s(1.6), 0.05) << "2 F / gain, more than the guard's speed";
}

TEST(HandlingCycle, ForgetsAGuardThatSeesTheProductAfterTheContact) {
  HandlingCycle cycle(guarded(GuardKind::range));
  cycle.observe(1.001, 1.0, 1.0005);
  EXPECT_EQ(cycle.plan().set_speed_m_s(1.1), HandlingCycle(scene()).plan().set_speed_m_s(1.1));
}

TEST(HandlingCycle, GripsFromWhereAGuardFeelsTheProductAndNotFromTheContact) {
  HandlingCycle cycle(guarded(GuardKind::force));
  cycle.observe(1.0, 1.0, std::nullopt);
  EXPECT_TRUE(cycle.has_contact());
  EXPECT_FALSE(cycle.grip_started());
  EXPECT_EQ(cycle.plan().force_limit_N(1.5), 0.5);
  cycle.observe(1.301, std::nullopt, 1.3);
  EXPECT_EQ(cycle.first_contact_s(), 1.0);
  EXPECT_NEAR(cycle.plan().lift_start_s(), 1.6, kSum);
  // From the guard's speed to the one that presses, 2 F / gain, as the force's limit rises.
  EXPECT_NEAR(cycle.plan().set_speed_m_s(1.4), 0.01 + 0.5 * (0.05 - 0.01), kSum);
  EXPECT_NEAR(cycle.plan().force_limit_N(1.4), 1.5, kSum);
}

TEST(MotionPlan, TellsTheDrivesOfAGuardOneStepLate) {
  Scenario scenario = guarded(GuardKind::range);
  scenario.simulation.time_step_s = 1e-3;
  const MotionPlan plan(scenario, kNever, 1.00025);
  // The guard is seen in the step from 1.000 s; at a quarter of the next one the drives know.
  const auto of_step = [&](double start_s) { return plan.told(start_s + scenario.simulation.theta * 1e-3); };
  EXPECT_NEAR(of_step(1.001), 0.75, 1e-9);
  EXPECT_EQ(of_step(1.002), 1.0);
  EXPECT_EQ(MotionPlan(scenario, kNever).told(1.0), 1.0);
}

TEST(HandlingCycle, GivesASlowApproachItsTime) {
  EXPECT_DOUBLE_EQ(HandlingCycle(guarded(GuardKind::range)).approach_deadline_s(), 2.0 * 0.04 / 0.01 + 1.0);
}

TEST(MotionPlan, CarriesThePalmUpAcrossAndDown) {
  const MotionPlan plan(scene(), 0.0);
  EXPECT_EQ(plan.palm(plan.lift_start_s()).position_m[2], 0.0);
  EXPECT_NEAR(plan.palm(plan.hold_end_s()).position_m[2], 0.1, kSum);
  const PalmState end = plan.palm(plan.release_start_s());
  EXPECT_NEAR(end.position_m[0], 0.3, kSum);
  EXPECT_NEAR(end.position_m[1], 0.4, kSum);
  EXPECT_NEAR(end.position_m[2], 0.03, kSum) << "the target and the height of the release";
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(end.velocity_m_s[i], 0.0);
  // Half way across a trapezoid that never reaches its limit the speed is sqrt(L a).
  const PalmState across = plan.palm(plan.hold_end_s() + 0.5 * way_s(0.5));
  EXPECT_NEAR(std::hypot(across.velocity_m_s[0], across.velocity_m_s[1]), std::sqrt(0.5 * 1.6), kSum);
  EXPECT_EQ(plan.support_plane(plan.lift_start_s()), SupportPlane::start);
  EXPECT_EQ(plan.support_plane(plan.lower_end_s()), SupportPlane::target);
  EXPECT_EQ(plan.support(SupportPlane::start, 1.0).position_m[2], 0.0);
  EXPECT_EQ(plan.support(SupportPlane::target, 1.0).position_m[2], 0.02);
}

TEST(MotionPlan, RaisesTheForceLimitLinearlyAndAimsAtASpeedThatReachesIt) {
  const MotionPlan plan(scene(), 1.0);
  EXPECT_EQ(plan.force_limit_N(0.9), 0.5);
  EXPECT_NEAR(plan.force_limit_N(1.1), 1.5, kSum);
  EXPECT_EQ(plan.force_limit_N(1.3), 2.5);
  EXPECT_EQ(plan.set_speed_m_s(0.9), 0.05);
  EXPECT_EQ(plan.set_speed_m_s(1.1), 0.05) << "2 F / gain = 0.05 m/s is no more than the approach";
  EXPECT_EQ(plan.set_speed_m_s(plan.release_start_s()), -0.1);
  Scenario weak = scene();
  jaw_of(weak).drive_gain_N_s_m = 50.0;
  EXPECT_EQ(MotionPlan(weak, 1.0).set_speed_m_s(1.1), 0.1);
}

TEST(MotionPlan, RefusesATimeThatIsNoNumber) {
  EXPECT_THROW(MotionPlan(Scenario{}, std::nan("")), std::logic_error);
}

TEST(MotionPlan, EndsAtTheDurationWhereThatComesFirst) {
  Scenario scenario = scene();
  scenario.simulation.duration_s = 1.25;
  EXPECT_EQ(MotionPlan(scenario, 0.0).end_s(), 1.25);
  EXPECT_EQ(MotionPlan(scenario, kNever).end_s(), 1.25);
  scenario.gripper = NoGripper{};
  EXPECT_EQ(MotionPlan(scenario, kNever).end_s(), 1.25);
  scenario = scene();
  scenario.simulation.duration_s = 100.0;
  EXPECT_LT(MotionPlan(scenario, 0.0).end_s(), 100.0);
}

TEST(HandlingCycle, TiltsWhenItIsLiftedAndIsLevelAgainBeforeItIsLowered) {
  Scenario tilted = scene();
  tilted.strategy.tilt_rad = {0.0, 0.6, 0.8};
  tilted.strategy.tilt_acceleration_rad_s2 = 4.0;  // an angle of 1 takes 2 sqrt(1 / 4) s
  tilted.strategy.tilt_speed_rad_s = 10.0;
  const MotionPlan plan(tilted, 1.5), level(scene(), 1.5);
  EXPECT_NEAR(plan.hold_start_s(), plan.lift_end_s() + 1.0, kSum);
  EXPECT_NEAR(plan.hold_end_s(), level.hold_end_s() + 1.0, kSum);
  EXPECT_NEAR(plan.lower_end_s(), level.lower_end_s() + 2.0, kSum);
  EXPECT_EQ(plan.phase_after_contact(plan.lift_end_s() + 0.5), CyclePhase::turn);
  EXPECT_EQ(plan.phase_after_contact(plan.hold_start_s()), CyclePhase::hold);
  EXPECT_EQ(plan.phase_after_contact(plan.hold_end_s() + way_s(0.5) + 0.5), CyclePhase::turn);
  // Half-way up: half the angle, the largest spin.
  const PalmState half = plan.palm(plan.lift_end_s() + 0.5);
  EXPECT_NEAR(half.rotation_rad[1], 0.3, kSum);
  EXPECT_NEAR(half.spin_rad_s[2], 0.8 * 2.0, 10.0 * kSum);
  EXPECT_NEAR(plan.palm(plan.lift_end_s() + 0.25).spin_acceleration_rad_s2[1], 0.6 * 4.0, 10.0 * kSum);
  for (const double time_s : {plan.hold_start_s(), plan.hold_end_s(), plan.hold_end_s() + 0.3}) {
    EXPECT_NEAR(plan.palm(time_s).rotation_rad[2], 0.8, kSum) << time_s;
    EXPECT_EQ(plan.palm(time_s).spin_rad_s[2], 0.0) << time_s;
  }
  const PalmState down = plan.palm(plan.release_start_s() - 0.05);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(down.rotation_rad[i], 0.0, kSum);
}

/// Lifted, turned about the grip axis while it goes 0.1 m up and along y, then put down as it is.
Scenario turned_scene(double rotation_rad) {
  Scenario scenario = scene();
  LatticeParameters& box = std::get<LatticeParameters>(scenario.product);
  box.size_m = {0.05, 0.06, 0.08};
  scenario.cell.grip_height_m = 0.01;
  scenario.strategy.tilt_acceleration_rad_s2 = 4.0;
  scenario.strategy.tilt_speed_rad_s = 10.0;
  scenario.strategy.waypoint = {{.place_m = std::array<double, 3>{0.0, 0.1, 0.2},
                                 .rotation_rad = std::array<double, 3>{rotation_rad, 0.0, 0.0},
                                 .wait_s = 0.25}};
  return scenario;
}

TEST(MotionPlan, VisitsItsWaypointsAfterTheLiftAndHoldsThen) {
  const MotionPlan plan(turned_scene(1.0), 1.5);
  const double leg_s = std::max(way_s(std::hypot(0.1, 0.1)), 1.0);
  EXPECT_NEAR(plan.hold_start_s(), plan.lift_end_s() + leg_s + 0.25, kSum);
  EXPECT_EQ(plan.phase_after_contact(plan.hold_start_s() - 0.1), CyclePhase::turn);
  EXPECT_EQ(plan.phase_after_contact(plan.hold_start_s()), CyclePhase::hold);
  const PalmState there = plan.palm(plan.hold_start_s());
  EXPECT_NEAR(there.position_m[1], 0.1, kSum);
  EXPECT_NEAR(there.position_m[2], 0.2, kSum);
  // From there across, and down to where the box's lowest place is 0.01 above the target at 0.02.
  EXPECT_NEAR(plan.palm(plan.hold_end_s()).position_m[1], 0.1, kSum);
  const PalmState end = plan.palm(plan.release_start_s());
  EXPECT_NEAR(end.position_m[0], 0.3, kSum);
  EXPECT_NEAR(end.position_m[1], 0.4, kSum);
  const double reach_m = 0.03 * std::sin(1.0) + 0.04 * std::cos(1.0);
  // The centre of the pads is 0.05 high at the start; the box hangs 0.01 below it.
  EXPECT_NEAR(0.05 + end.position_m[2] - 0.01 * std::cos(1.0) - reach_m, 0.03, kSum);
  EXPECT_NEAR(end.rotation_rad[0], 1.0, kSum);
  EXPECT_NEAR(plan.palm(plan.end_s()).rotation_rad[0], 1.0, kSum) << "it stays as it was turned";
}

TEST(MotionPlan, MeetsAMovingTargetFromItsLastWaypoint) {
  Scenario scenario = turned_scene(1.0);
  scenario.cell.place_velocity_m_s = {0.2, 0.0};
  const MotionPlan plan(scenario, 1.5);
  EXPECT_NEAR(plan.palm(plan.hold_end_s()).position_m[1], 0.1, kSum);
  EXPECT_NEAR(plan.palm(plan.hold_end_s() + 1e-9).position_m[1], 0.1, 1e-8);
  const double time_s = plan.release_start_s();
  EXPECT_NEAR(plan.palm(time_s).position_m[0], 0.3 + 0.2 * time_s, 1e-13);
  EXPECT_NEAR(plan.palm(time_s).velocity_m_s[0], 0.2, 1e-13);
}

TEST(MotionPlan, IsContinuousFromTheLiftToTheEnd) {
  const MotionPlan plan(turned_scene(1.0), 1.5);
  constexpr double kStep_s = 1e-4;
  for (double time_s = 1.5; time_s < plan.end_s(); time_s += kStep_s) {
    const PalmState a = plan.palm(time_s), b = plan.palm(time_s + kStep_s);
    for (std::size_t i = 0; i < 3; ++i) {
      // 1.6 m/s2 and 4 rad/s2 over a step.
      ASSERT_NEAR(b.position_m[i], a.position_m[i] + kStep_s * a.velocity_m_s[i], 1.6 * kStep_s * kStep_s)
          << time_s;
      ASSERT_NEAR(b.rotation_rad[i], a.rotation_rad[i] + kStep_s * a.spin_rad_s[i], 4.0 * kStep_s * kStep_s)
          << time_s;
    }
  }
}

}  // namespace
}  // namespace unbruised
