// The record alone, fed with observations written by hand: which outcome, when, and the sums it keeps.

#include "core/outcome/handling_record.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr double kStep_s = 0.01;

/// Contact at 0.1 s, a lift from 0.3 s on.
Scenario scene() {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  scenario.cell.approach_gap_m = 0.01;
  scenario.strategy.grip_ramp_s = 0.1;
  scenario.strategy.settle_s = 0.1;
  scenario.strategy.hold_s = 0.4;
  scenario.limits.slip_m = 1e-3;
  std::get<LatticeParameters>(scenario.product).friction = 0.5;
  return scenario;
}

/// A product that both fingers hold with 2 N and 0.5 N along z each, and that does not slip.
StepObservation held(double time_s) {
  StepObservation seen;
  seen.time_s = seen.register_time_s = time_s;
  for (FingerObservation& finger : seen.finger) {
    finger.normal_N = 2.0;
    finger.tangent_N = {0.0, 0.5};
    finger.closed_contacts = 4.0;
  }
  return seen;
}

/// Runs a cycle whose steps look like `held`, changed by `change`.
ScenarioResult record_of(const Scenario& scenario, const std::function<void(StepObservation&)>& change) {
  HandlingCycle cycle(scenario);
  HandlingRecord record(scenario);
  double time_s = 0.0;
  for (int step = 1; time_s < cycle.plan().end_s(); ++step) {
    time_s = step * kStep_s;
    cycle.observe(time_s, time_s >= 0.1 ? std::optional(0.1) : std::nullopt);
    StepObservation seen = held(time_s);
    change(seen);
    if (!record.observe(seen, cycle)) break;
  }
  return record.finish(cycle, time_s);
}

TEST(HandlingRecord, SlipsByAngleAsWellAsByWay) {
  Scenario scenario = scene();
  scenario.limits.slip_rad = 0.05;
  const ScenarioResult result = record_of(scenario, [](StepObservation& seen) {
    if (seen.time_s < 0.35) return;
    seen.finger[1].slip_rad = 0.06;
    seen.finger[1].sliding_contacts = seen.finger[1].closed_contacts;
  });
  EXPECT_EQ(result.outcome, Outcome::slipped);
  EXPECT_EQ(result.cause, "slip_max_rad > limits.slip_rad");
  EXPECT_NEAR(result.outcome_time_s, 0.35, kStep_s);
  EXPECT_EQ(result.metrics[Metric::slip_max_rad], 0.06);
  EXPECT_EQ(result.metrics[Metric::slip_max_m], 0.0);
  EXPECT_DOUBLE_EQ(result.metrics[Metric::friction_margin_min], -0.06 / 0.05);
}

TEST(HandlingRecord, HoldsAndAddsUpTheImpulseOfTheGrip) {
  const ScenarioResult result = record_of(scene(), [](StepObservation&) {});
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_EQ(result.metrics[Metric::first_contact_time_s], 0.1);
  EXPECT_DOUBLE_EQ(result.metrics[Metric::lift_time_s], 0.3);
  EXPECT_EQ(result.metrics[Metric::peak_finger_force_N], 2.0);
  // mu N / T - 1
  EXPECT_DOUBLE_EQ(result.metrics[Metric::friction_margin_min], 0.5 * 2.0 / 0.5 - 1.0);
  // 2 N from the first step's end to the start of the release, and a ramp from 0 over the first step: 2 N x (t -
  // dt/2).
  const MotionPlan plan(scene(), 0.1);
  EXPECT_NEAR(result.metrics[Metric::grip_impulse_N_s], 2.0 * (plan.release_start_s() - 0.5 * kStep_s), 1e-12);
  EXPECT_EQ(result.metrics[Metric::hold_drift_m_s], 0.0);
}

TEST(HandlingRecord, MeasuresPlaceAndAttitudeAgainstHowThePalmPutsTheProductDown) {
  Scenario scenario = scene();
  scenario.cell.grip_height_m = 0.01;
  scenario.strategy.waypoint = {{.rotation_rad = std::array<double, 3>{1.0, 0.0, 0.0}}};
  const ScenarioResult result = record_of(scenario, [&](StepObservation& seen) {
    seen.attitude = attitude_of({0.75, 0.0, 0.0});
    seen.center_motion_m = {scenario.cell.transfer_m[0], scenario.cell.transfer_m[1], 0.0};
  });
  EXPECT_NEAR(result.metrics[Metric::place_attitude_rad], 0.25, 1e-15);
  // The centre, 0.01 below the pads, swings aside by 0.01 sin 1 as they turn.
  EXPECT_NEAR(result.metrics[Metric::place_error_m], 0.01 * std::sin(1.0), 1e-15);
}

TEST(HandlingRecord, MeasuresTheDriftOfTheLastQuarterOfTheHoldAgainstThePalm) {
  const ScenarioResult result = record_of(scene(), [](StepObservation& seen) {
    seen.palm_m = {0.0, 0.0, 0.1 * seen.time_s};
    seen.center_motion_m = {0.0, 0.0, 0.1 * seen.time_s - 3e-6 * seen.time_s};
  });
  // A difference of places of 0.1 m over 0.1 s: round-off of 1e-16 m / s.
  EXPECT_NEAR(result.metrics[Metric::hold_drift_m_s], 3e-6, 1e-14);
}

TEST(HandlingRecord, DropsWhereNoFingerTouchesBetweenLiftAndRelease) {
  const ScenarioResult result = record_of(scene(), [](StepObservation& seen) {
    if (seen.time_s < 0.5) return;
    for (FingerObservation& finger : seen.finger) finger = FingerObservation{};
  });
  EXPECT_EQ(result.outcome, Outcome::dropped);
  EXPECT_NEAR(result.outcome_time_s, 0.5, kStep_s);
}

TEST(HandlingRecord, AnOpenContactAfterTheStartOfTheReleaseIsNoDrop) {
  const double release_s = MotionPlan(scene(), 0.1).release_start_s();
  const ScenarioResult result = record_of(scene(), [&](StepObservation& seen) {
    if (seen.register_time_s < release_s) return;
    for (FingerObservation& finger : seen.finger) finger = FingerObservation{};
  });
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
}

TEST(HandlingRecord, DoesNotGraspWithOneFingerOrAtTheEndOfTheStroke) {
  const ScenarioResult one = record_of(scene(), [](StepObservation& seen) { seen.finger[1] = {}; });
  EXPECT_EQ(one.outcome, Outcome::not_grasped);
  EXPECT_DOUBLE_EQ(one.outcome_time_s, 0.3);
  const ScenarioResult end = record_of(scene(), [](StepObservation& seen) { seen.end_of_stroke = true; });
  EXPECT_EQ(end.outcome, Outcome::not_grasped);
  EXPECT_DOUBLE_EQ(end.outcome_time_s, kStep_s);
}

TEST(HandlingRecord, SlipComesBeforeDamageAndEachKeepsItsFirstTime) {
  Scenario scenario = scene();
  scenario.limits.finger_force_N = 3.0;
  const auto press = [](StepObservation& seen) {
    if (seen.time_s > 0.355) seen.finger[0].normal_N = 3.5;
  };
  const ScenarioResult damaged = record_of(scenario, press);
  EXPECT_EQ(damaged.outcome, Outcome::damaged);
  EXPECT_DOUBLE_EQ(damaged.outcome_time_s, 0.36);
  const ScenarioResult slipped = record_of(scenario, [&](StepObservation& seen) {
    press(seen);
    if (seen.time_s > 0.455) seen.finger[1].slip_m = 2e-3;
  });
  EXPECT_EQ(slipped.outcome, Outcome::slipped);
  EXPECT_DOUBLE_EQ(slipped.outcome_time_s, 0.46);
  EXPECT_DOUBLE_EQ(slipped.metrics[Metric::slip_max_m], 2e-3);
}

TEST(HandlingRecord, AProductThatPushesOneFingerBackFromTheOtherSlips) {
  const auto leaving = [](double way_m) {
    return record_of(scene(), [way_m](StepObservation& seen) {
      if (seen.time_s < 0.35) return;
      seen.finger[1].closed_contacts = 0.0;
      seen.compression_m = -kJawFingers * way_m;
    });
  };
  EXPECT_EQ(leaving(0.99e-3).outcome, Outcome::held);
  const ScenarioResult result = leaving(1.01e-3);
  EXPECT_EQ(result.outcome, Outcome::slipped);
  EXPECT_EQ(result.cause, "the product leaves a pad by more than limits.slip_m");
  EXPECT_NEAR(result.outcome_time_s, 0.35, 1e-9);
}

TEST(HandlingRecord, AFingerThatSlidesAsAWholeHasTheMarginOfItsSlip) {
  const ScenarioResult result = record_of(scene(), [](StepObservation& seen) {
    seen.finger[0].sliding_contacts = 4.0;
    seen.finger[0].slip_m = 5e-4;
  });
  EXPECT_DOUBLE_EQ(result.metrics[Metric::friction_margin_min], -0.5) << "-slip / limits.slip_m";
}

TEST(HandlingRecord, ARunWhoseEnergyIsUnaccountedForIsNoAnswer) {
  for (const double error : {0.051, -0.051, 2810.0}) {
    HandlingRecord record(scene());
    record.metrics[Metric::energy_balance_error] = error;
    const ScenarioResult result = record.finish(HandlingCycle(scene()), 0.4);
    EXPECT_EQ(result.outcome, Outcome::out_of_range) << error;
    EXPECT_EQ(result.cause, "more than 5 % of the energy put in is unaccounted for");
    EXPECT_EQ(result.outcome_time_s, 0.4);
  }
  HandlingRecord record(scene());
  record.metrics[Metric::energy_balance_error] = -kEnergyErrorMost;
  EXPECT_EQ(record.finish(HandlingCycle(scene()), 0.4).outcome, Outcome::held);
}

TEST(HandlingRecord, AnAbortEndsAllOtherVerdictsAndANumberThatOverflowsIsNoMeasurement) {
  HandlingRecord record(scene());
  record.abort(Outcome::out_of_range, "too far", 0.2);
  record.abort(Outcome::diverged, "later", 0.3);
  const ScenarioResult aborted = record.finish(HandlingCycle(scene()), 0.4);
  EXPECT_EQ(aborted.outcome, Outcome::out_of_range);
  EXPECT_EQ(aborted.cause, "too far");
  EXPECT_EQ(aborted.outcome_time_s, 0.2);
  const ScenarioResult infinite = record_of(scene(), [](StepObservation& seen) {
    seen.center_acceleration_m_s2 = {std::numeric_limits<double>::infinity(), 0.0, 0.0};
  });
  EXPECT_EQ(infinite.outcome, Outcome::diverged);
  EXPECT_TRUE(std::isnan(infinite.metrics[Metric::peak_acceleration_m_s2]));
}

}  // namespace
}  // namespace unbruised
