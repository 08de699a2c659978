// Products on a belt: they ride, they slide where Coulomb says, they are picked on the fly and put down on what
// moves.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A low, firm block on a belt that starts from rest; nobody grips it. A soft one leans at first, which costs it
/// some 2 mm/s that it never makes up for; so does friction that grows over the first step, by mu g dt = 0.7 mm/s
/// here.
Scenario riding_block(double acceleration_m_s2) {
  Scenario scenario = small_box();
  make_product(scenario, {0.04, 0.04, 0.02}, 0.01, 0.05, 4e7);
  lattice_of(scenario).relaxation_time_s = 1e-4;
  scenario.gripper = NoGripper{};
  scenario.cell.support_friction = 0.3;
  scenario.cell.support_modulus_Pa = 2e7;
  scenario.cell.support_relaxation_time_s = 1e-3;
  scenario.cell.conveyor.speed_m_s = 0.5;
  scenario.cell.conveyor.acceleration_m_s2 = acceleration_m_s2;
  scenario.cell.conveyor.direction = {0.6, 0.8};
  scenario.simulation.time_step_s = 2.5e-4;
  scenario.simulation.duration_s = 0.5;
  return scenario;
}

TEST(Conveyor, CarriesAProductAlongBelowTheFrictionLimit) {
  const ScenarioResult result = run(riding_block(2.0));  // mu g = 2.94 m/s2
  // It leans by m a over the shear stiffness of layer and block: some 1 um.
  EXPECT_LT(result.metrics[Metric::belt_slip_m], 5e-6);
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
  EXPECT_NEAR(result.metrics[Metric::energy_balance_error], 0.0, 1e-3);  // measured 4e-6
}

TEST(Conveyor, LeavesAProductBehindByTheWayThatCoulombSays) {
  for (const double acceleration_m_s2 : {6.0, 8.0}) {
    const ScenarioResult result = run(riding_block(acceleration_m_s2));
    const double friction_m_s2 = 0.3 * kGravity, square = 0.5 * 0.5;
    const double way_m = square / (2.0 * friction_m_s2) - square / (2.0 * acceleration_m_s2);
    EXPECT_NEAR(result.metrics[Metric::belt_slip_m], way_m, 0.01 * way_m) << acceleration_m_s2;
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
    EXPECT_NEAR(result.metrics[Metric::energy_balance_error], 0.0, 1e-3);
  }
}

TEST(Conveyor, ABeltThatBrakesLetsItsProductSlideOn) {
  Scenario scenario = riding_block(6.0);
  scenario.cell.conveyor.speed_m_s = 0.0;
  scenario.cell.conveyor.initial_speed_m_s = 0.4;
  scenario.cell.conveyor.start_s = 0.05;
  const double way_m = 0.16 / (2.0 * 0.3 * kGravity) - 0.16 / (2.0 * 6.0);
  EXPECT_NEAR(run(scenario).metrics[Metric::belt_slip_m], way_m, 0.01 * way_m);
}

/// A box on a belt, and a palm that goes with it.
Scenario tracked_box(double speed_m_s) {
  Scenario scenario = small_box();
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.cell.conveyor.speed_m_s = speed_m_s;
  scenario.cell.place_velocity_m_s = {0.0, speed_m_s};
  scenario.cell.place_height_m = 0.005;
  scenario.strategy.pick = PickKind::tracking;
  return scenario;
}

TEST(Conveyor, InACellThatMovesEvenlyEverythingIsAsAtRest) {
  Scenario still = tracked_box(0.0);
  still.strategy.pick = PickKind::still;
  const ScenarioResult rest = run(still), moved = run(tracked_box(0.3));
  ASSERT_EQ(rest.outcome, Outcome::held) << rest.cause;
  EXPECT_EQ(moved.outcome, Outcome::held) << moved.cause;
  for (const Metric metric : {Metric::peak_finger_force_N, Metric::cycle_time_s, Metric::compression_max_m,
                              Metric::peak_acceleration_m_s2, Metric::friction_margin_min}) {
    // Places grow to half a metre: 1e-16 of that against deflections of 1e-4 m.
    EXPECT_NEAR(moved.metrics[metric] / rest.metrics[metric], 1.0, 1e-9) << info_of(metric).name;
  }
  for (const Metric metric : {Metric::slip_max_m, Metric::pick_error_m, Metric::place_error_m}) {
    EXPECT_NEAR(moved.metrics[metric], rest.metrics[metric], 1e-12) << info_of(metric).name;
  }
}

TEST(Conveyor, APalmThatTracksLateGripsBehindByTheWayOfTheLag) {
  Scenario scenario = tracked_box(0.2);
  scenario.cell.place_velocity_m_s = {0.0, 0.0};
  scenario.cell.transfer_m = {0.02, 0.4};
  scenario.strategy.tracking_lag_s = 0.01;
  const ScenarioResult result = run(scenario);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_NEAR(result.metrics[Metric::pick_error_m], 0.2 * 0.01,
              2e-5);  // it is gripped off its middle and turns a little
  EXPECT_NEAR(result.metrics[Metric::place_error_m], 0.2 * 0.01, 5e-5);  // and stands as far off its place
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
  EXPECT_NEAR(result.metrics[Metric::energy_balance_error], 0.0, 5e-3);
}

TEST(Conveyor, AProductThatStandsFurtherOffItsPlaceThanItMayIsMisplaced) {
  Scenario scenario = tracked_box(0.2);
  scenario.strategy.tracking_lag_s = 0.01;
  for (const double allowed_m : {0.0015, 0.0025}) {
    scenario.limits.place_error_m = allowed_m;
    const ScenarioResult result = run(scenario);
    EXPECT_EQ(result.outcome, allowed_m < 0.002 ? Outcome::misplaced : Outcome::held);
    EXPECT_EQ(result.cause, allowed_m < 0.002 ? "place_error_m > limits.place_error_m" : "");
  }
}

TEST(Conveyor, APalmThatWaitsIsMetByTheProductOnTheWay) {
  Scenario scenario = tracked_box(0.05);
  scenario.strategy.pick = PickKind::still;
  scenario.cell.place_velocity_m_s = {0.0, 0.0};
  scenario.strategy.pick_offset_m = 0.01;
  scenario.cell.transfer_m = {0.0, 0.1};
  const ScenarioResult result = run(scenario);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  // The belt went on below while the fingers held the product: from the first contact at 0.04 s to the lift.
  const double ridden_m = 0.05 * result.metrics[Metric::first_contact_time_s];
  const double slid_m =
      0.05 * (result.metrics[Metric::lift_time_s] - result.metrics[Metric::first_contact_time_s]);
  EXPECT_NEAR(result.metrics[Metric::belt_slip_m], slid_m, 0.2 * slid_m);  // gripped within some of these 150 ms
  EXPECT_NEAR(result.metrics[Metric::pick_error_m], 0.01 - ridden_m, 1.5e-3);
}

TEST(Conveyor, ABeltThatEndsBeforeTheLiftEndsTheRun) {
  Scenario scenario = tracked_box(0.2);
  scenario.cell.conveyor.length_m = 0.03;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::out_of_range);
  EXPECT_NE(result.cause.find("cell.conveyor.length_m"), std::string::npos) << result.cause;
  EXPECT_NEAR(result.outcome_time_s, 0.15, 2e-3);  // 0.03 m at 0.2 m/s, to the step
}

}  // namespace
}  // namespace unbruised
