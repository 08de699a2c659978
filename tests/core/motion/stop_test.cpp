// An emergency stop: what the plan does with palm and fingers.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/handling_cycle.hpp"

namespace unbruised {
namespace {

/// A dozen operations on numbers near 1.
constexpr double kRounding = 1e-13;

/// Touched at 0.1 s; lift, tilt, transfer, lowering.
Scenario carried(double stop_s) {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  scenario.cell.lift_height_m = 0.1;
  scenario.cell.transfer_m = {0.3, 0.4};
  scenario.cell.stop_deceleration_m_s2 = 4.0;
  scenario.strategy.tilt_rad = {0.0, 0.6, 0.8};
  scenario.strategy.stop_time_s = stop_s;
  return scenario;
}

MotionPlan plan_of(const Scenario& scenario) { return {scenario, 0.1}; }
MotionPlan plan_without_stop() {
  Scenario scenario = carried(0.0);
  scenario.strategy.stop_time_s.reset();
  return plan_of(scenario);
}

double size(const std::array<double, 3>& x) { return std::hypot(x[0], x[1], x[2]); }

TEST(EmergencyStop, BrakesThePalmEvenlyAlongItsPathToRest) {
  const MotionPlan free = plan_without_stop();
  for (const double share : {0.2, 0.5, 0.8}) {
    // In the lift, and in the transfer.
    for (const double stop_s : {free.lift_start_s() + share * (free.lift_end_s() - free.lift_start_s()),
                                free.hold_end_s() + 0.5 * share}) {
      const MotionPlan plan = plan_of(carried(stop_s));
      const PalmState from = free.palm(stop_s);
      const double speed = size(from.velocity_m_s), braking_s = speed / 4.0;
      ASSERT_GT(speed, 0.05);
      EXPECT_EQ(plan.palm(stop_s).position_m, from.position_m) << "until then all is as planned";
      const PalmState halfway = plan.palm(stop_s + 0.5 * braking_s), rest = plan.palm(stop_s + 1.01 * braking_s);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(halfway.velocity_m_s[i], 0.5 * from.velocity_m_s[i], kRounding);
        EXPECT_NEAR(halfway.acceleration_m_s2[i], -4.0 * from.velocity_m_s[i] / speed, kRounding);
        EXPECT_NEAR(rest.position_m[i], from.position_m[i] + 0.5 * braking_s * from.velocity_m_s[i], kRounding);
        EXPECT_EQ(rest.velocity_m_s[i], 0.0);
        EXPECT_EQ(rest.acceleration_m_s2[i], 0.0);
      }
      EXPECT_NEAR(plan.end_s(), stop_s + braking_s + 0.3, kRounding);
    }
  }
}

TEST(EmergencyStop, BrakesATiltWithTheAccelerationOfTheTilt) {
  const MotionPlan free = plan_without_stop();
  const double stop_s = 0.5 * (free.lift_end_s() + free.hold_start_s());
  const MotionPlan plan = plan_of(carried(stop_s));
  const double spin = size(free.palm(stop_s).spin_rad_s), braking_s = spin / 40.0;
  ASSERT_GT(spin, 0.5);
  EXPECT_NEAR(size(plan.palm(stop_s + 1.0).rotation_rad),
              size(free.palm(stop_s).rotation_rad) + 0.5 * spin * braking_s, kRounding);
}

TEST(EmergencyStop, BrakesATurnAboutItsOwnAxisFromWhereverThePalmHasTurnedTo) {
  Scenario scenario = carried(0.0);
  scenario.strategy.stop_time_s.reset();
  scenario.strategy.tilt_rad = {};
  scenario.strategy.waypoint = {{.rotation_rad = std::array<double, 3>{1.2, 0.0, 0.0}},
                                {.rotation_rad = std::array<double, 3>{0.0, 1.2, 0.0}}};
  const MotionPlan free = plan_of(scenario);
  const double stop_s = free.lift_end_s() + 0.75 * (free.hold_start_s() - free.lift_end_s());
  scenario.strategy.stop_time_s = stop_s;
  const PalmState from = free.palm(stop_s), rest = plan_of(scenario).palm(stop_s + 1.0);
  const double spin = size(from.spin_rad_s), way_rad = 0.5 * spin * spin / 40.0;
  ASSERT_GT(spin, 0.5);
  const auto turn = rotation_to(attitude_of(rest.rotation_rad) * inverse(attitude_of(from.rotation_rad)));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(turn[i], way_rad * from.spin_rad_s[i] / spin, kRounding);
}

TEST(EmergencyStop, NothingThatWasPlannedForLaterComes) {
  const double stop_s = plan_without_stop().hold_end_s() + 0.1;
  const MotionPlan plan = plan_of(carried(stop_s));
  EXPECT_LT(plan.hold_end_s(), stop_s);
  for (const double event_s : {plan.lower_end_s(), plan.release_start_s(), plan.release_end_s()}) {
    EXPECT_EQ(event_s, kNever);
  }
  EXPECT_EQ(plan.phase_after_contact(stop_s), CyclePhase::transfer);
  EXPECT_EQ(plan.phase_after_contact(stop_s + 1e-9), CyclePhase::stop);
  EXPECT_GT(plan.set_speed_m_s(stop_s + 1.0), 0.0) << "the fingers go on pressing";
}

TEST(EmergencyStop, KeepsTheForceThatTheRampHadReached) {
  const Scenario scenario = carried(0.15);  // half way up a ramp of 0.1 s
  const MotionPlan plan = plan_of(scenario);
  EXPECT_NEAR(plan.force_limit_N(5.0), 0.5 * (0.3 + 1.0), kRounding);
  EXPECT_EQ(plan.lift_start_s(), kNever);
}

TEST(EmergencyStop, FingersThatHaveNotTouchedStopClosing) {
  const MotionPlan plan(carried(0.05), kNever);
  EXPECT_GT(plan.set_speed_m_s(0.05), 0.0);
  EXPECT_EQ(plan.set_speed_m_s(0.06), 0.0);
  EXPECT_NEAR(plan.end_s(), 0.35, kRounding);
}

TEST(EmergencyStop, AfterTheReleaseHasBegunThereIsNothingToStop) {
  const MotionPlan free = plan_without_stop();
  EXPECT_EQ(plan_of(carried(free.release_start_s() + 0.01)).end_s(), free.end_s());
}

}  // namespace
}  // namespace unbruised
