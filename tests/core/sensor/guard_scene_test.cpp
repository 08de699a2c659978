// Guarded approaches: the speed at the touch, the peak of the force, what the guard costs.

#include <cmath>

#include "core/scenario/guard.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using testing::column;

/// The small cube from 12 mm on either side, at 0.2 m/s.
Scenario fast_box() {
  Scenario scenario = testing::small_box();
  scenario.cell.approach_gap_m = 0.012;
  scenario.strategy.approach_speed_m_s = 0.2;
  scenario.strategy.contact_force_N = 0.25;
  scenario.simulation.time_step_s = 5e-4;
  scenario.simulation.duration_s = 0.45;       // into the lift
  jaw_of(scenario).drive_viscous_N_s_m = 0.0;  // as the closed form has it
  jaw_of(scenario).range.maximum_m = 0.05;
  return scenario;
}

Scenario guarded(Scenario scenario, double range_m, double speed_m_s) {
  scenario.strategy.guard = GuardKind::range;
  scenario.strategy.guard_range_m = range_m;
  scenario.strategy.guard_speed_m_s = speed_m_s;
  return scenario;
}

double speed_at_touch_m_s(const ScenarioResult& result, const Trace& trace) {
  const double step_s = trace.time_s[1] - trace.time_s[0];
  const auto before = static_cast<std::size_t>(result.metrics[Metric::first_contact_time_s] / step_s);
  return column(trace, "finger_speed_m_s")[before];
}

TEST(GuardByRange, TouchesWithTheSlowSpeedAtTheTimeOfTheClosedForm) {
  const Scenario scenario = guarded(fast_box(), 0.0095, 0.02);
  Trace trace;
  const ScenarioResult result = testing::run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_NEAR(speed_at_touch_m_s(result, trace), 0.02, 2e-4);
  // 0.25 N brake 0.1 kg by 2.5 m/s2: 0.18 m/s in 72 ms and 7.92 mm, of 9.5 mm.
  const PlannedApproach planned = planned_approach(scenario);
  EXPECT_NEAR(planned.time_s, 0.0025 / 0.2 + 0.18 / 2.5 + (0.0095 - 0.00792) / 0.02, 1e-12);
  EXPECT_EQ(planned.touch_speed_m_s, 0.02);
  // The drives hear of the guard a step later, and the fingers follow a jump of a force by Wilson's method as if
  // it came 0.9 steps late: the mean accelerations of the first steps are 0.36, 0.82, 0.95 ... of what they will
  // be. At 0.2 m/s instead of 0.02 m/s that shortens the slow way.
  const double saved_s = 1.9 * 5e-4 * (0.2 / 0.02 - 1.0);
  EXPECT_NEAR(result.metrics[Metric::first_contact_time_s], planned.time_s - saved_s, 5e-4);
}

TEST(GuardByRange, CostsTheCycleWhatItCostsTheApproach) {
  const ScenarioResult fast = testing::run(fast_box()), slow = testing::run(guarded(fast_box(), 0.0095, 0.02));
  const double cost_s = slow.metrics[Metric::first_contact_time_s] - fast.metrics[Metric::first_contact_time_s];
  EXPECT_GT(cost_s, 0.05);
  for (const Metric later : {Metric::lift_time_s, Metric::cycle_time_s}) {
    EXPECT_NEAR(slow.metrics[later] - fast.metrics[later], cost_s, 1e-12);
  }
}

TEST(GuardByRange, LowersThePeakToThatOfASlowApproach) {
  Scenario stiff = fast_box();
  testing::lattice_of(stiff).youngs_modulus_Pa = 1e6;
  Scenario slow = stiff;
  slow.strategy.approach_speed_m_s = 0.02;
  const auto peak_N = [](const Scenario& scenario) {
    return testing::run(scenario).metrics[Metric::peak_finger_force_N];
  };
  const double slow_N = peak_N(slow), guarded_N = peak_N(guarded(stiff, 0.0095, 0.02)), fast_N = peak_N(stiff);
  EXPECT_NEAR(guarded_N, slow_N, 0.01 * slow_N);
  EXPECT_GT(fast_N, 3.0 * slow_N);
}

TEST(GuardByRange, WithoutRoomTouchesAsFastAsTheBrakeLeaves) {
  const Scenario scenario = guarded(fast_box(), 0.004, 0.02);
  Trace trace;
  const ScenarioResult result = testing::run(scenario, &trace);
  const PlannedApproach planned = planned_approach(scenario);
  EXPECT_NEAR(planned.touch_speed_m_s, std::sqrt(0.04 - 2.0 * 2.5 * 0.004), 1e-12);
  // A step late at 0.2 m/s is 0.1 mm: at 2.5 m/s2 and 0.14 m/s 2 mm/s.
  EXPECT_NEAR(speed_at_touch_m_s(result, trace), planned.touch_speed_m_s, 3e-3);
}

TEST(GuardByRange, IsContinuousInItsRange) {
  // Eleven ranges that differ by a tenth of what a finger goes in a step.
  double last_s = 0.0;
  for (int i = 0; i <= 10; ++i) {
    const Scenario scenario = guarded(fast_box(), 0.0095 + i * 1e-5, 0.02);
    const double touch_s = testing::run(scenario).metrics[Metric::first_contact_time_s];
    // d t / d range = 1 / slow - 1 / fast = 45 s/m.
    if (i > 0) {
      EXPECT_NEAR(touch_s - last_s, 1e-5 * 45.0, 2e-5) << i;
    }
    last_s = touch_s;
  }
}

TEST(GuardByRange, WaitsForTheSampleThatShowsIt) {
  Scenario scenario = guarded(fast_box(), 0.0095, 0.02);
  jaw_of(scenario).range.rate_Hz = 100.0;
  const double touch_s = testing::run(scenario).metrics[Metric::first_contact_time_s];
  Scenario steady = guarded(fast_box(), 0.0095, 0.02);
  const double steady_s = testing::run(steady).metrics[Metric::first_contact_time_s];
  // 9.5 mm are left at 12.5 ms, the sample comes at 20 ms: 1.5 mm less are gone slowly.
  EXPECT_NEAR(steady_s - touch_s, 7.5e-3 * (0.2 / 0.02 - 1.0), 2e-3);
}

/// Felt at 0.15 N, while the fingers press with up to 0.25 N.
Scenario feeling_box(double speed_m_s) {
  Scenario scenario = fast_box();
  jaw_of(scenario).range.maximum_m.reset();
  scenario.strategy.guard = GuardKind::force;
  scenario.strategy.guard_force_N = 0.15;
  scenario.strategy.guard_speed_m_s = speed_m_s;
  return scenario;
}

TEST(GuardByForce, BeginsTheGripWhereItFeelsTheContact) {
  const Scenario scenario = feeling_box(0.05);
  Trace trace;
  const ScenarioResult result = testing::run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  const double touch_s = result.metrics[Metric::first_contact_time_s];
  const double felt_s =
      result.metrics[Metric::lift_time_s] - scenario.strategy.grip_ramp_s - scenario.strategy.settle_s;
  // Where the force crosses 0.15 N between the ends of two steps, but not before the contact.
  const std::vector<double> force = column(trace, "finger_force_N");
  std::size_t at = 0;
  while (force[at + 1] <= 0.15) ++at;
  const double crossed_s = trace.time_s[at] + 5e-4 * (0.15 - force[at]) / (force[at + 1] - force[at]);
  EXPECT_NEAR(felt_s, std::max(crossed_s, touch_s), 1e-9);
}

TEST(GuardByForce, LooksAtTheForceAtItsSamplesOnly) {
  Scenario scenario = feeling_box(0.05);
  jaw_of(scenario).force_rate_Hz = 50.0;
  const ScenarioResult result = testing::run(scenario);
  const double touch_s = result.metrics[Metric::first_contact_time_s];
  const double felt_s =
      result.metrics[Metric::lift_time_s] - scenario.strategy.grip_ramp_s - scenario.strategy.settle_s;
  EXPECT_GT(felt_s, touch_s);
  EXPECT_NEAR(std::remainder(felt_s, 0.02), 0.0, 1e-12);
}

TEST(GuardByForce, StopsTheFingersWhereItFeelsTheContact) {
  Trace trace;
  testing::run(feeling_box(0.0), &trace);
  const std::vector<double> force = column(trace, "finger_force_N"), speed = column(trace, "finger_speed_m_s");
  std::size_t felt = 0;
  while (force[felt] <= 0.15) ++felt;
  EXPECT_GT(speed[felt], 0.1);
  // The drives brake with up to 0.25 N, 2.5 m/s2, beside what the cube pushes back: at rest within 0.1 s, but for
  // the 1.2 mm/s that the ramp of the force has reached then.
  for (std::size_t i = felt + 200; trace.time_s[i] < trace.time_s[felt] + 0.14; ++i) {
    EXPECT_LT(std::abs(speed[i]), 2e-3) << trace.time_s[i];
  }
  // Without it they press on.
  Scenario unguarded = feeling_box(0.0);
  unguarded.strategy.guard = GuardKind::none;
  EXPECT_LT(testing::largest(force), testing::run(unguarded).metrics[Metric::peak_finger_force_N]);
}

TEST(GuardByForce, IsNotGraspedWhereItFeelsNothing) {
  Scenario scenario = feeling_box(0.0);
  scenario.cell.grip_offset_m = 0.05;  // the pads pass the cube
  jaw_of(scenario).stroke_m = 0.015;
  const ScenarioResult result = testing::run(scenario);
  EXPECT_EQ(result.outcome, Outcome::not_grasped) << result.cause;
}

}  // namespace
}  // namespace unbruised
