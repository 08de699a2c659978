// Products that relax, through the whole simulator: a bar between stiff, slippery pads, in which the stress is the
// same everywhere, so that force and closure have to obey the material's own integral.

#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/core/material/pressed_bar.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kArea_m2 = kWidth_m * kWidth_m;

Scenario bar(double stress_Pa, double hold_s) {
  Scenario scenario = pressed_bar();
  lattice_of(scenario).relaxation_time_s = 2e-3;
  jaw_of(scenario).pad_modulus_Pa = 5e6;
  scenario.strategy.grip_force_N = stress_Pa * kArea_m2;
  scenario.strategy.grip_ramp_s = 0.1;
  scenario.strategy.settle_s = 0.1;
  scenario.strategy.hold_s = hold_s;
  scenario.strategy.recover_s = 0.2;
  scenario.simulation.time_step_s = 4e-3;
  return scenario;
}

LatticeParameters& carrot(Scenario& scenario) {
  LatticeParameters& product = lattice_of(scenario);
  product.prony_modulus = {0.218, 0.233};
  product.prony_time_s = {1.68, 26.3};
  return product;
}

/// int E(t - s) e'(s) ds of a strain that is linear between rows, in closed form, at row `at`.
double stress_Pa(const LatticeParameters& product, const std::vector<double>& strain, double dt, std::size_t at) {
  double stress = 0.0, g_inf = 1.0;
  for (std::size_t i = 0; i < product.prony_modulus.size(); ++i) {
    const double tau = product.prony_time_s[i];
    g_inf -= product.prony_modulus[i];
    for (std::size_t k = 0; k < at; ++k) {
      const double age = dt * static_cast<double>(at - k - 1);
      stress += product.prony_modulus[i] * (strain[k + 1] - strain[k]) * tau / dt * -std::expm1(-dt / tau) *
                std::exp(-age / tau);
    }
  }
  return kE_Pa * (stress + g_inf * (strain[at] - strain[0]));
}

TEST(RelaxingGrip, LockedFingersLoseTheForceThatTheBarLoses) {
  Scenario scenario = bar(1e4, 60.5);
  const LatticeParameters product = carrot(scenario);
  jaw_of(scenario).hold = HoldMode::position;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  // Of the little work that locked fingers do more than 5 % is unaccounted for at steps of 4 ms.
  ASSERT_NE(result.outcome, Outcome::diverged) << result.cause;
  const std::vector<double> force = column(trace, "finger_force_N", 0), strain = bar_strain(trace);
  const double dt = scenario.simulation.time_step_s, locked_s = result.metrics[Metric::lift_time_s];
  double worst = 0.0;
  for (const double after_s : {0.5, 2.0, 5.0, 10.0, 60.0}) {
    const auto at = static_cast<std::size_t>(std::lround((locked_s + after_s) / dt));
    worst = std::max(worst, std::abs(force[at] / kArea_m2 / stress_Pa(product, strain, dt, at) - 1.0));
    const double left = 0.549 + 0.218 * std::exp(-after_s / 1.68) + 0.233 * std::exp(-after_s / 26.3);
    // Gripped 0.15 s before it was locked, it has lost two per cent of what it then loses by then.
    EXPECT_NEAR(force[at] / scenario.strategy.grip_force_N, left, 0.02) << after_s;
    std::cout << "[ measured ] locked for " << after_s << " s: " << force[at] / scenario.strategy.grip_force_N
              << " of the grip force, " << left << " of a closure at once\n";
  }
  EXPECT_LT(worst, 1e-3);
  std::cout << "[ measured ] force over that of the strain's history: off by " << worst << "\n";
}

TEST(RelaxingGrip, UnderAForceThatIsHeldTheBarCreeps) {
  Scenario scenario = bar(1e4, 60.5);
  const LatticeParameters product = carrot(scenario);
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  const std::vector<double> strain = bar_strain(trace);
  const double dt = scenario.simulation.time_step_s, from_s = result.metrics[Metric::lift_time_s];
  double worst = 0.0;
  for (const double after_s : {0.5, 2.0, 10.0, 60.0}) {
    const auto at = static_cast<std::size_t>(std::lround((from_s + after_s) / dt));
    worst = std::max(worst, std::abs(stress_Pa(product, strain, dt, at) / 1e4 - 1.0));
  }
  EXPECT_LT(worst, 1.2e-3);  // 1.0e-3 seen, at steps of 4 ms
  EXPECT_EQ(result.metrics[Metric::permanent_set_max_m], 0.0) << "all of it recovers";
  std::cout << "[ measured ] stress of the creep's history: off by " << worst << "\n";
}

/// A bar that yields, relaxes within seconds, and is pressed beyond its yield stress and held there.
Scenario yielding_bar(double time_step_s) {
  Scenario scenario = bar(5.4e4, 1.0);
  LatticeParameters& product = lattice_of(scenario);
  product.prony_modulus = {0.2, 0.3};
  product.prony_time_s = {0.1, 1.0};
  product.yield_stress_Pa = 3e4;
  product.tangent_modulus_Pa = 3e5;
  product.relaxation_time_s = 5e-3;
  scenario.strategy.grip_ramp_s = 1.5;
  scenario.strategy.recover_s = 0.5;
  scenario.simulation.max_strain = 0.4;
  scenario.simulation.time_step_s = time_step_s;
  return scenario;
}

TEST(RelaxingGrip, ABarYieldsByTheStressThatIsThere) {
  // Whatever it creeps, under a given force it flows plastically as an elastic bar does, p = (s - Y)/H, and keeps
  // that.
  const double strain = (5.4e4 - 3e4) * (1.0 / 3e5 - 1.0 / kE_Pa);
  std::vector<double> error;
  for (const double dt : {4e-3, 2e-3, 1e-3}) {
    const ScenarioResult result = run(yielding_bar(dt));
    ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
    EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], strain, 0.02 * strain);
    const double corner = strain * std::hypot(0.5 * kLength_m, 0.25 * kWidth_m * std::sqrt(2.0));
    EXPECT_NEAR(result.metrics[Metric::permanent_set_max_m], corner, 0.02 * corner);
    error.push_back(std::abs(result.metrics[Metric::energy_balance_error]));
    std::cout << "[ measured ] dt " << dt << ": plastic strain "
              << result.metrics[Metric::plastic_strain_max] / strain << ", set "
              << result.metrics[Metric::permanent_set_max_m] / corner << " of the closed form, energy error "
              << result.metrics[Metric::energy_balance_error] << "\n";
  }
  EXPECT_LT(error[2], 5e-3);
  EXPECT_LT(error[2], 0.7 * error[0]) << "the energy error falls with the step";
}

TEST(RelaxingGrip, ABurgersBarKeepsImpulseOverItsViscosity) {
  Scenario scenario = bar(1e4, 4.0);
  LatticeParameters& product = lattice_of(scenario);
  product.burgers_flow_time_s = 50.0;
  product.burgers_recovery_modulus = 2.0;
  product.burgers_recovery_time_s = 0.5;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  double impulse = 0.0;
  for (const double force : column(trace, "finger_force_N", 0)) impulse += scenario.simulation.time_step_s * force;
  const double strain = impulse / (kArea_m2 * kE_Pa * 50.0);
  const double corner = strain * std::hypot(0.5 * kLength_m, 0.3 * 0.5 * kWidth_m * std::sqrt(2.0));
  EXPECT_NEAR(result.metrics[Metric::permanent_set_max_m], corner, 5e-3 * corner);
  EXPECT_EQ(result.metrics[Metric::plastic_strain_max], 0.0);
  std::cout << "[ measured ] set of a Burgers bar: " << result.metrics[Metric::permanent_set_max_m] / corner
            << " of F t / c1, energy error " << result.metrics[Metric::energy_balance_error] << "\n";
}

TEST(RelaxingGrip, TheEnergyErrorFallsWithTheStep) {
  std::vector<double> error;
  for (const double dt : {4e-3, 2e-3, 1e-3}) {
    Scenario scenario = bar(1e4, 0.5);
    LatticeParameters& product = lattice_of(scenario);
    product.prony_modulus = {0.218, 0.233};
    product.prony_time_s = {0.1, 0.5};
    product.relaxation_time_s = 5e-3;
    scenario.simulation.time_step_s = dt;
    const ScenarioResult result = run(scenario);
    error.push_back(std::abs(result.metrics[Metric::energy_balance_error]));
    std::cout << "[ measured ] dt " << dt << ": energy error " << result.metrics[Metric::energy_balance_error]
              << "\n";
  }
  EXPECT_LT(error[2], 0.01);
  EXPECT_LT(error[2], 0.25 * error[0]);
}

TEST(RelaxingGrip, AProductThatHasStoodForLongDoesNotSinkAnyFurther) {
  Scenario scenario = small_box();
  carrot(scenario).prony_time_s = {0.02, 0.2};
  scenario.cell.approach_gap_m = 0.01;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  const std::vector<double> top = freedom(trace, trace.displacement_m, 3 * (trace.particle_count - 1) + 2);
  EXPECT_LT(top[0], -1e-6) << "it sags under its weight";
  EXPECT_NEAR(top[150] / top[0], 1.0, 1e-6) << "and has done so for long";
  Scenario elastic = small_box();
  Trace stiff;
  run(elastic, &stiff);
  const double sag = freedom(stiff, stiff.displacement_m, 3 * (stiff.particle_count - 1) + 2)[0];
  // The support's layer does not fade.
  EXPECT_GT(top[0] / sag, 1.3);
  EXPECT_LT(top[0] / sag, 1.0 / 0.549);
}

TEST(RelaxingGrip, HasTheSameBitsBesideAnyNeighbour) {
  Scenario first = yielding_bar(4e-3), second = first;
  second.strategy.grip_force_N *= 0.7;
  const auto both = run_side_by_side({first, second, first});
  expect_same_bits(run(first), both[0], "first");
  expect_same_bits(run(second), both[1], "second");
  expect_same_bits(both[0], both[2], "third");
}

TEST(RelaxingGrip, ATurnedProductRelaxesAsOneThatStands) {
  std::vector<double> left;
  for (const double tilt : {0.0, 1.5707963267948966}) {
    Scenario scenario = small_box();
    LatticeParameters& product = lattice_of(scenario);
    product.prony_modulus = {0.3};
    product.prony_time_s = {1.0};
    jaw_of(scenario).hold = HoldMode::position;
    scenario.cell.transfer_m = {0.0, 0.0};
    scenario.cell.gravity_m_s2 = {0.0, 0.0, -0.1};  // hardly any: asked is the force of the grip
    scenario.strategy.hold_s = 2.0;
    scenario.strategy.tilt_rad = {tilt, 0.0, 0.0};
    scenario.strategy.tilt_speed_rad_s = 3.0;
    scenario.strategy.tilt_acceleration_rad_s2 = 20.0;
    scenario.strategy.stop_time_s = 2.5;
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    const std::vector<double> force = column(trace, "finger_force_N", 0),
                              across = column(trace, "finger_force_N", 1), up = column(trace, "finger_force_N", 2);
    left.push_back(std::hypot(force.back(), across.back(), up.back()));
    EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 2e-2);
  }
  EXPECT_NEAR(left[1] / left[0], 1.0, 1e-2);
  EXPECT_LT(left[0], 0.85 * small_box().strategy.grip_force_N);
  std::cout << "[ measured ] force left in a turned product over that in one that stands: " << left[1] / left[0]
            << "\n";
}

}  // namespace
}  // namespace unbruised
