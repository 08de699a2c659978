// How hard a gripper must press so that a product does not slip, against the closed forms of dry friction.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kMass_kg = 0.008;
constexpr double kFriction = 0.5;

/// A box of 8 g that slips as soon as it moves by a tenth of a millimetre.
Scenario light_box() {
  Scenario scenario = small_box();
  // Stiff enough that the jumps of a trapezoid profile, which ring at the body's own frequency, slip by
  // micrometres.
  lattice_of(scenario).youngs_modulus_Pa = 1e6;
  scenario.cell.lift_height_m = 0.3;
  // Set down just below: braking while lowering needs m (g + a) as well, after a jump of 2 a.
  scenario.cell.place_height_m = 0.295;
  scenario.strategy.lower_acceleration_m_s2 = 0.2;
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.profile = ProfileKind::trapezoid;
  scenario.strategy.lift_acceleration_m_s2 = 2.0;
  scenario.strategy.speed_m_s = 10.0;
  scenario.strategy.contact_force_N = 0.01;
  scenario.strategy.recover_s = 0.0;
  scenario.strategy.settle_s = 0.4;  // until the grip force has settled to 1e-3
  scenario.limits.slip_m = 1e-4;
  return scenario;
}

/// The least grip force that holds, by bisection with a batch of lanes per round, from `low` (slips) to `high`.
double least_force(const Scenario& scenario, double low, double high) {
  for (int round = 0; round < 2; ++round) {
    std::vector<Scenario> batch;
    for (int k = 0; k < lane_count(); ++k) {
      Scenario one = scenario;
      one.strategy.grip_force_N = low + (high - low) * k / (lane_count() - 1);
      batch.push_back(one);
    }
    const auto results = run_side_by_side(batch);
    EXPECT_NE(results.front().outcome, Outcome::held) << "at " << low << " N";
    EXPECT_EQ(results.back().outcome, Outcome::held) << "at " << high << " N: " << results.back().cause;
    std::size_t last_slip = 0;
    for (std::size_t k = 0; k < results.size(); ++k) {
      if (results[k].outcome != Outcome::held) last_slip = k;
    }
    low = batch[last_slip].strategy.grip_force_N;
    high = batch[std::min(last_slip + 1, batch.size() - 1)].strategy.grip_force_N;
  }
  return high;
}

TEST(HoldLimit, OfALiftIsMassTimesGravityAndAccelerationOverTwiceTheFriction) {
  for (double acceleration : {2.0, 6.0}) {
    Scenario scenario = light_box();
    scenario.strategy.lift_acceleration_m_s2 = acceleration;
    const double wanted = kMass_kg * (kGravity + acceleration) / (2.0 * kFriction);
    const double found = least_force(scenario, 0.8 * wanted, 1.2 * wanted);
    EXPECT_NEAR(found, wanted, 0.02 * wanted);
    std::cout << "[ measured ] lift at " << acceleration << " m/s2: " << found / wanted
              << " of m (g + a) / (2 mu)\n";
  }
}

TEST(HoldLimit, OfATransferAcrossTheGripAxisIsTheResultantOverTwiceTheFriction) {
  // Trapezoid profiles jump by 2 a half way; the ringing slips by (2 a / omega)^2 / (2 margin), micrometres at
  // this a.
  const double acceleration = 5.0;
  Scenario scenario = light_box();
  scenario.cell.lift_height_m = 0.02;
  scenario.cell.place_height_m = 0.015;
  scenario.cell.transfer_m = {0.0, 0.3};
  scenario.strategy.lift_acceleration_m_s2 = 0.3;  // needs less than the transfer
  scenario.strategy.transfer_acceleration_m_s2 = acceleration;
  const double wanted = kMass_kg * std::hypot(kGravity, acceleration) / (2.0 * kFriction);
  ASSERT_LT(kMass_kg * (kGravity + 0.3) / (2.0 * kFriction), 0.95 * wanted);
  const double found = least_force(scenario, 0.8 * wanted, 1.2 * wanted);
  EXPECT_NEAR(found, wanted, 0.02 * wanted);
  std::cout << "[ measured ] transfer at " << acceleration << " m/s2: " << found / wanted
            << " of m sqrt(g2 + a2) / (2 mu)\n";
}

TEST(HoldLimit, OfAnEmergencyStopIsTheResultantOfGravityAndItsDecelerationOverTwiceTheFriction) {
  const double deceleration = 5.0;
  // Sideways at full speed, and downwards at full speed, where it adds to gravity.
  for (const bool down : {false, true}) {
    Scenario scenario = light_box();
    scenario.cell.stop_deceleration_m_s2 = deceleration;
    scenario.strategy.speed_m_s = 0.3;
    scenario.strategy.lift_acceleration_m_s2 = 0.5;
    scenario.cell.lift_height_m = down ? 0.4 : 0.02;
    scenario.cell.place_height_m = down ? 0.0 : 0.015;
    scenario.strategy.lower_acceleration_m_s2 = 0.5;
    scenario.cell.transfer_m = {0.0, down ? 0.0 : 0.4};
    // A lift of 0.02 m takes 0.4 s; one of 0.4 m, at 0.3 m/s with ramps of 0.6 s, 1.933 s. Half a second more is
    // 0.25 m/s, on the way.
    const double touch_s = scenario.cell.approach_gap_m.value() / scenario.strategy.approach_speed_m_s;
    const double lifted_s = touch_s + 0.05 + 0.4 + (down ? 0.4 / 0.3 + 0.6 : 0.4);
    scenario.strategy.stop_time_s = lifted_s + 0.5;
    const double load = down ? kGravity + deceleration : std::hypot(kGravity, deceleration);
    const double wanted = kMass_kg * load / (2.0 * kFriction);
    ASSERT_LT(kMass_kg * (kGravity + 0.5) / (2.0 * kFriction), 0.95 * wanted);
    const double found = least_force(scenario, 0.8 * wanted, 1.2 * wanted);
    EXPECT_NEAR(found, wanted, 0.02 * wanted) << (down ? "down" : "sideways");
    std::cout << "[ measured ] stop " << (down ? "downwards" : "sideways") << ": " << found / wanted
              << " of the closed form\n";
  }
}

TEST(Hold, AfterAStopTheProductHangsStillAndTheCycleHasNoTime) {
  Scenario scenario = light_box();
  scenario.strategy.grip_force_N = 0.3;
  scenario.strategy.stop_time_s = 1.0;  // in the lift
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_TRUE(std::isnan(result.metrics[Metric::cycle_time_s]));
  EXPECT_TRUE(std::isnan(result.metrics[Metric::place_error_m]));
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 5e-3);
}

TEST(Grip, AlongItsAxisTheTwoFingerForcesDifferByMassTimesAcceleration) {
  for (FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
    const double acceleration = 5.0, force = 0.3;
    Scenario scenario = light_box();
    jaw_of(scenario).coupling = coupling;
    jaw_of(scenario).finger_mass_kg = 0.05;
    scenario.cell.lift_height_m = 0.02;
    scenario.cell.place_height_m = 0.015;
    scenario.cell.transfer_m = {0.3, 0.0};
    scenario.strategy.grip_force_N = force;
    scenario.strategy.lift_acceleration_m_s2 = 1.0;
    scenario.strategy.transfer_acceleration_m_s2 = coupling == FingerCoupling::centric ? acceleration : 0.5;
    const double a = *scenario.strategy.transfer_acceleration_m_s2;
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    const auto left = column(trace, "finger_force_N", 0), right = column(trace, "finger_force_N", 3);
    // The middle half of the time in which the palm speeds up.
    const double start = result.metrics[Metric::lift_time_s] + 2.0 * std::sqrt(0.02 / 1.0);
    const double speeding_up = std::sqrt(0.3 / a);
    double difference = 0.0, mean = 0.0, least = 1e300;
    int rows = 0;
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (trace.time_s[k] < start + 0.25 * speeding_up || trace.time_s[k] > start + 0.75 * speeding_up) continue;
      difference += left[k] + right[k];
      mean += 0.5 * (left[k] - right[k]);
      least = std::min({least, left[k], -right[k]});
      ++rows;
    }
    difference /= rows;
    mean /= rows;
    EXPECT_GT(least, 0.0);
    EXPECT_NEAR(difference, kMass_kg * a, 0.02 * kMass_kg * a);
    // Rack and pinion: the drive holds the mean of the two. Alone, each finger adds its own inertia to the same
    // side.
    if (coupling == FingerCoupling::centric) {
      EXPECT_NEAR(mean, force, 0.01 * force);
    }
    std::cout << "[ measured ] difference " << difference << " N of m a = " << kMass_kg * a << " N, mean " << mean
              << " N\n";
  }
}

TEST(Hold, DoesNotCreepAtTwiceTheNeededForce) {
  Scenario scenario = light_box();
  scenario.cell.lift_height_m = 0.05;
  scenario.cell.place_height_m = 0.0;
  scenario.strategy.grip_force_N = 2.0 * kMass_kg * kGravity / (2.0 * kFriction);
  scenario.strategy.hold_s = 3.0;
  scenario.strategy.profile = ProfileKind::minimum_jerk;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(result.metrics[Metric::hold_drift_m_s], 1e-6);
  std::cout << "[ measured ] drift " << result.metrics[Metric::hold_drift_m_s] << " m/s over 3 s\n";
}

}  // namespace
}  // namespace unbruised
