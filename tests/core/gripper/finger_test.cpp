// What the driven fingers do: speed, force, impact, and phases at real times.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Finger, PressesAtRestWithExactlyTheGripForce) {
  for (double force : {0.3, 0.5}) {
    for (FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
      Scenario scenario = small_box();
      jaw_of(scenario).coupling = coupling;
      scenario.strategy.grip_force_N = force;
      scenario.strategy.settle_s = 0.4;
      Trace trace;
      const ScenarioResult result = run(scenario, &trace);
      const auto left = column(trace, "finger_force_N", 0), right = column(trace, "finger_force_N", 3);
      const auto k = static_cast<std::size_t>(result.metrics[Metric::lift_time_s] / 1e-3) - 1;
      EXPECT_NEAR(left[k], force, 1e-6 * force);
      EXPECT_NEAR(-right[k], force, 1e-6 * force);
    }
  }
}

TEST(Finger, ReachesTheApproachSpeedThatTheDriveAllows) {
  Scenario scenario = small_box();
  scenario.cell.approach_gap_m = 0.02;
  scenario.strategy.contact_force_N = 0.2;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const auto speed = column(trace, "finger_speed_m_s", 0);
  const auto k = static_cast<std::size_t>(result.metrics[Metric::first_contact_time_s] / 1e-3) - 1;
  // Drive gain x (set speed - speed) balances the guide's friction: v = v_set gain / (gain + friction).
  const double wanted = 0.05 * 500.0 / 501.0;
  EXPECT_NEAR(speed[k], wanted, 1e-6);
}

TEST(Finger, DriveNeverGivesMoreThanItsLimit) {
  // Against a guide that brakes with 1 N at full speed a drive of 0.4 N sinks to the speed of balance, limit /
  // friction.
  Scenario scenario = small_box();
  scenario.cell.approach_gap_m = 0.035;
  jaw_of(scenario).drive_viscous_N_s_m = 20.0;
  jaw_of(scenario).finger_mass_kg = 0.02;
  scenario.strategy.approach_speed_m_s = 0.05;
  scenario.strategy.contact_force_N = 0.4;
  scenario.strategy.grip_force_N = 0.5;
  Trace trace;
  run(scenario, &trace);
  const auto speed = column(trace, "finger_speed_m_s", 0);
  for (std::size_t k = 50; k < 500; ++k) EXPECT_NEAR(speed[k], 0.4 / 20.0, 1e-9) << k;
}

TEST(Finger, CoastsWithoutDriveAsTheClosedForm) {
  // w = v (m/c) (1 - exp(-c t/m)) reaches the gap at -(m/c) ln(1 - c gap/(m v)).
  const double m = 0.1, c = 0.9, v = 0.05, gap = 5e-3;
  const double wanted = -(m / c) * std::log(1.0 - c * gap / (m * v));
  std::vector<double> error;
  for (const double dt : {2e-3, 1e-3}) {
    Scenario scenario = small_box();
    scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
    scenario.cell.approach_gap_m = gap;
    jaw_of(scenario).finger_mass_kg = m;
    jaw_of(scenario).drive_viscous_N_s_m = c;
    scenario.strategy.approach_speed_m_s = v;
    scenario.strategy.contact_force_N = 0.0;
    scenario.simulation.time_step_s = dt;
    error.push_back(run(scenario).metrics[Metric::first_contact_time_s] / wanted - 1.0);
  }
  // Linear between steps, a braked way lags by w'' dt^2/8 over w': 1e-4 of the time at 1 ms. First order had 3 %.
  EXPECT_LT(std::abs(error[1]), 1.5e-4);
  EXPECT_LT(std::abs(error[1]), 0.5 * std::abs(error[0]) + 1e-6);
}

TEST(Finger, RestsAgainstTheEndOfItsStroke) {
  // The stop leaves the product the squeeze of the way beyond the gap, whatever the drive pushes with.
  for (const FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
    Scenario scenario = small_box();
    jaw_of(scenario).coupling = coupling;
    const double gap = 5e-3;
    scenario.cell.approach_gap_m = gap;
    jaw_of(scenario).stroke_m = gap + 2e-4;
    scenario.strategy.grip_force_N = 20.0;
    scenario.strategy.settle_s = 0.4;
    scenario.simulation.time_step_s = 1e-4;  // six steps in the period of finger and stop
    Trace trace;
    run(scenario, &trace);
    const auto way = column(trace, "finger_way_m", 0), speed = column(trace, "finger_speed_m_s", 0);
    const auto force = column(trace, "finger_force_N", 0);
    double deepest = 0.0;
    for (const double w : way) deepest = std::max(deepest, w);
    // 20 N press a stop of 1e7 N/m in by 2 um; what the impact adds at 0.05 m/s is v sqrt(m/k) = 5 um.
    EXPECT_LT(deepest, jaw_of(scenario).stroke_m + 1e-5);
    const auto k = static_cast<std::size_t>((gap / scenario.strategy.approach_speed_m_s + 0.3) /
                                            scenario.simulation.time_step_s);
    EXPECT_NEAR(way[k], jaw_of(scenario).stroke_m, 3e-6);
    EXPECT_NEAR(speed[k], 0.0, 1e-7);
    EXPECT_LT(force[k], 19.0) << "the stop carries the rest";
    EXPECT_GT(force[k], 0.0);
  }
}

TEST(Finger, StrikesWithItsMomentum) {
  // What fast fingers bring along is their momentum, and it goes into the product.
  Scenario scenario = small_box();
  jaw_of(scenario).coupling = FingerCoupling::independent;
  scenario.strategy.approach_speed_m_s = 0.2;
  scenario.strategy.grip_force_N = 0.3;
  jaw_of(scenario).drive_viscous_N_s_m = 0.0;
  scenario.cell.approach_gap_m = 0.02;
  scenario.strategy.contact_force_N = 0.3;
  scenario.strategy.grip_ramp_s = 0.0;
  scenario.simulation.time_step_s = 2e-4;
  scenario.simulation.duration_s = 0.5;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const auto force = column(trace, "finger_force_N", 0), speed = column(trace, "finger_speed_m_s", 0);
  const auto first = static_cast<std::size_t>(result.metrics[Metric::first_contact_time_s] / 2e-4);
  ASSERT_NEAR(speed[first], 0.2, 1e-3);
  // Until it stands still the pad takes m v plus what the drive pushes, F t; both are known.
  double impulse = 0.0;
  std::size_t k = first;
  while (speed[k] > 0.0) {
    impulse += 0.5 * (force[k] + force[k + 1]) * 2e-4;
    ++k;
  }
  const double pushed = 0.3 * static_cast<double>(k - first) * 2e-4;
  const double wanted = 0.1 * (speed[first] - speed[k]) + pushed;
  EXPECT_NEAR(impulse, wanted, 0.02 * wanted);
  // At the same speed the peak grows with the root of the finger's mass, or less where the drive pushes along.
  Scenario heavy = scenario;
  jaw_of(heavy).finger_mass_kg = 0.15;
  EXPECT_GT(run(heavy).metrics[Metric::peak_finger_force_N], 1.1 * result.metrics[Metric::peak_finger_force_N]);
  std::cout << "[ measured ] impulse " << impulse << " N s of " << wanted << " N s, peak "
            << result.metrics[Metric::peak_finger_force_N] << " N\n";
}

TEST(Cycle, PhasesAreRealNumbersAndNotMultiplesOfTheStep) {
  const Scenario scenario = small_box();
  const ScenarioResult base = run(scenario);
  const double lift = base.metrics[Metric::lift_time_s], contact = base.metrics[Metric::first_contact_time_s];
  EXPECT_NEAR(lift, contact + 0.05 + 0.1, 1e-12);
  EXPECT_GT(std::abs(contact / 1e-3 - std::round(contact / 1e-3)), 1e-3);
  // A smaller step moves the first contact by far less than a step: it is interpolated.
  Scenario fine = scenario;
  fine.simulation.time_step_s = 2.5e-4;
  EXPECT_NEAR(run(fine).metrics[Metric::first_contact_time_s], contact, 1e-5);
}

TEST(Cycle, TimeChangesByExactlyWhatTheStrategyChanges) {
  const Scenario scenario = small_box();
  const ScenarioResult base = run(scenario);
  ASSERT_EQ(base.outcome, Outcome::held) << base.cause;
  const double h = 1e-6;
  std::vector<Scenario> changed(5, scenario);
  changed[0].strategy.settle_s += h;
  changed[1].strategy.hold_s += h;
  changed[2].strategy.place_settle_s += h;
  changed[3].strategy.grip_ramp_s += h;
  changed[4].strategy.recover_s += h;  // after the release: outside the cycle
  const auto results = run_side_by_side(changed);
  for (std::size_t k = 0; k < results.size(); ++k) {
    const double change = results[k].metrics[Metric::cycle_time_s] - base.metrics[Metric::cycle_time_s];
    EXPECT_NEAR(change, k == 4 ? 0.0 : h, 1e-3 * h) << k;
  }
}

TEST(Cycle, MetricsVarySmoothlyWithTheStrategy) {
  // Neighbouring strategies give neighbouring metrics: no metric jumps by a step's worth.
  Scenario scenario = small_box();
  std::vector<Scenario> swept;
  for (int k = 0; k < 16; ++k) {
    swept.push_back(scenario);
    swept.back().strategy.approach_speed_m_s = 0.05 * (1.0 + 1e-4 * k);
  }
  const auto results = run_side_by_side(swept);
  for (Metric metric : {Metric::cycle_time_s, Metric::first_contact_time_s, Metric::peak_finger_force_N,
                        Metric::compression_max_m, Metric::energy_input_J}) {
    double least = 1e300, most = -1e300;
    for (std::size_t k = 1; k < results.size(); ++k) {
      const double slope = results[k].metrics[metric] - results[k - 1].metrics[metric];
      least = std::min(least, slope);
      most = std::max(most, slope);
    }
    const double size = std::abs(results[0].metrics[metric]);
    // A change of the speed by 1e-4 moves a smooth metric by some 1e-4 of itself; a whole step of 1 ms of the
    // cycle would be 1e-3.
    EXPECT_LT(most - least, 2e-4 * size) << info_of(metric).name;
  }
}

}  // namespace
}  // namespace unbruised
