// Permanent deformation through the whole simulator, against the elastic-plastic bar.

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/material/material.hpp"
#include "core/simulation/model_parts.hpp"
#include "tests/core/material/pressed_bar.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(CellPlasticity, ABarFollowsTheElasticPlasticLineAndKeepsTheRest) {
  const double most = 1.8 * kYield_Pa;
  const Scenario scenario = yielding_bar(most);
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  const std::vector<double> strain = bar_strain(trace), force = column(trace, "finger_force_N", 0),
                            plastic = column(trace, "plastic_strain_max");
  const double area = kWidth_m * kWidth_m;
  // Onset: the stress at which the first plastic strain appears.
  std::size_t onset = 0;
  while (plastic[onset] == 0.0) ++onset;
  EXPECT_NEAR(force[onset] / area, kYield_Pa, 0.02 * kYield_Pa);
  // Slopes before and after: strains at chosen stresses on the way up.
  const auto strain_at = [&](double stress) {
    std::size_t k = 0;
    while (force[k] / area < stress) ++k;
    const double w = (stress - force[k - 1] / area) / ((force[k] - force[k - 1]) / area);
    return strain[k - 1] + w * (strain[k] - strain[k - 1]);
  };
  const double elastic = (0.9 - 0.5) * kYield_Pa / (strain_at(0.9 * kYield_Pa) - strain_at(0.5 * kYield_Pa));
  const double tangent = (1.7 - 1.2) * kYield_Pa / (strain_at(1.7 * kYield_Pa) - strain_at(1.2 * kYield_Pa));
  EXPECT_NEAR(elastic, kE_Pa, 0.02 * kE_Pa);
  EXPECT_NEAR(tangent, kTangent_Pa, 0.02 * kTangent_Pa);
  const double residual = (most - kYield_Pa) * (1.0 / kTangent_Pa - 1.0 / kE_Pa);
  EXPECT_NEAR(strain.back(), residual, 0.02 * residual);
  EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], residual, 0.02 * residual);
  // The set's farthest particle is a corner: half the length shorter, half the width thicker by half the strain.
  const double corner = residual * std::hypot(0.5 * kLength_m, 0.25 * kWidth_m * std::sqrt(2.0));
  EXPECT_NEAR(result.metrics[Metric::permanent_set_max_m], corner, 0.02 * corner);
  // Plastic work of the bilinear bar: mean stress times plastic strain times volume.
  const double work = 0.5 * (kYield_Pa + most) * residual * area * kLength_m;
  EXPECT_NEAR(result.metrics[Metric::absorbed_energy_J], work, 0.02 * work);
  std::cout << "[ measured ] onset " << force[onset] / area / kYield_Pa << " Y, E " << elastic / kE_Pa << ", E_t "
            << tangent / kTangent_Pa << ", residual " << strain.back() / residual << ", set "
            << result.metrics[Metric::permanent_set_max_m] / corner << ", work "
            << result.metrics[Metric::absorbed_energy_J] / work << " (all over the closed form); rounds per step "
            << result.metrics[Metric::plasticity_iterations] / result.metrics[Metric::step_count]
            << ", energy error " << result.metrics[Metric::energy_balance_error] << "\n";
}

TEST(CellPlasticity, BelowYieldNothingStays) {
  const ScenarioResult result = run(yielding_bar(0.95 * kYield_Pa));
  EXPECT_EQ(result.metrics[Metric::plastic_strain_max], 0.0);
  EXPECT_EQ(result.metrics[Metric::permanent_set_max_m], 0.0);
  EXPECT_EQ(result.metrics[Metric::absorbed_energy_J], 0.0);
}

TEST(CellPlasticity, SoftHardeningStillConvergesWithinItsSteps) {
  // E_t / E = 0.1: the fixed point of the initial-strain iteration contracts by about 0.9 per round.
  Scenario scenario = yielding_bar(1.3 * kYield_Pa);
  lattice_of(scenario).tangent_modulus_Pa = 1e5;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  const double residual = 0.3 * kYield_Pa * (1.0 / 1e5 - 1.0 / kE_Pa);
  EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], residual, 0.03 * residual);
  std::cout << "[ measured ] E_t / E = 0.1: plastic strain "
            << result.metrics[Metric::plastic_strain_max] / residual << " of the closed form, rounds per step "
            << result.metrics[Metric::plasticity_iterations] / result.metrics[Metric::step_count] << "\n";
}

/// A ripe kiwi, coarse.
Scenario kiwi(double time_step_s) {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.shape = Shape::ellipsoid;
  product.size_m = {0.048, 0.048, 0.064};
  product.cell_size_m = 0.008;
  product.density_kg_m3 = 1022.0;
  product.youngs_modulus_Pa = 0.288e6;
  product.poisson_ratio = 0.35;
  product.yield_stress_Pa = 0.024e6;
  product.tangent_modulus_Pa = 0.08e6;
  product.relaxation_time_s = 2e-3;
  scenario.strategy.approach_speed_m_s = 0.02;
  scenario.strategy.grip_force_N = 25.0;
  scenario.strategy.grip_ramp_s = 0.2;
  scenario.simulation.time_step_s = time_step_s;
  return scenario;
}

TEST(CellPlasticity, ThePermanentSetOfAGrippedKiwiDoesNotDependOnTheStep) {
  const ScenarioResult coarse = run(kiwi(1e-3)), fine = run(kiwi(5e-4));
  ASSERT_EQ(coarse.outcome, Outcome::held) << coarse.cause;
  ASSERT_EQ(fine.outcome, Outcome::held) << fine.cause;
  const double a = coarse.metrics[Metric::permanent_set_max_m], b = fine.metrics[Metric::permanent_set_max_m];
  EXPECT_GT(b, 1e-4);
  EXPECT_NEAR(a, b, 0.01 * b);
  std::cout << "[ measured ] kiwi: set " << a << " m at 1 ms, " << b << " m at 0.5 ms, rounds per step "
            << coarse.metrics[Metric::plasticity_iterations] / coarse.metrics[Metric::step_count] << "\n";
}

TEST(Material, RefusesLanesAndDisplacementsThatDoNotFit) {
  Scenario springs = oscillator(1.0, 100.0, 1e-3, 10);
  network_of(springs).spring.front().yield_force_N = 1.0;
  for (const Scenario& scenario : {small_box(), springs}) {
    const auto model = build(scenario);
    const auto material = make_material(model->parts().body, *model->parts().wilson);
    EXPECT_THROW(material->load(kLanes, scenario), std::logic_error);
    EXPECT_THROW(material->load(-1, scenario), std::logic_error);
    EXPECT_THROW(material->update(LaneArray(3), Mask(true)), std::logic_error);
  }
}

TEST(SpringPlasticity, ASpringKeepsTheSetOfItsClosedForm) {
  // |f| <= F_y + h k p: past yield dF = k h / (1 + h) de, so the set is (F - F_y) / (h k).
  const double k = 1000.0, yield = 5.0, h = 0.25, most = 8.0, damping = 63.0;  // nearly critical for 1 kg
  for (double sign : {1.0, -1.0}) {
    Scenario scenario = oscillator(1.0, k, 2e-3, 7000);
    NetworkSpring& spring = network_of(scenario).spring[0];
    spring.yield_force_N = yield;
    spring.hardening_ratio = h;
    spring.damping_N_s_m = damping;
    // Held for four seconds: the damper lets go with its time constant c (1 + h) / (k h) = 0.3 s.
    network_of(scenario).load = {
        {1, {0.0, 4.0, 8.0, 11.0}, {{0, 0, 0}, {sign * most, 0, 0}, {sign * most, 0, 0}, {0, 0, 0}}}};
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    const std::vector<double> u = freedom(trace, trace.displacement_m, 3);
    const double set = (most - yield) / (h * k);
    EXPECT_NEAR(sign * u[3950], most / k + set, 1e-3 * set);  // under load, t = 7.9 s
    EXPECT_NEAR(sign * u.back(), set, 1e-3 * set);
    EXPECT_NEAR(result.metrics[Metric::permanent_set_max_m], set, 1e-3 * set);
    EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], set / 1.0, 1e-3 * set);
    const double work = 0.5 * (yield + most) * set;
    EXPECT_NEAR(result.metrics[Metric::absorbed_energy_J], work, 2e-3 * work);
    std::cout << "[ measured ] spring: set " << sign * u.back() / set << " of the closed form\n";
  }
}

TEST(SpringPlasticity, ASpringMountedBeyondItsYieldForceFlowsAtOnce) {
  // Mounted 10 mm longer than its rest length it would carry 10 N, yields at 5 N: 10 N - k p = 5 N + h k p, so
  // p = 5 / (k (1 + h)), and it pulls with what is left until it carries nothing.
  const double k = 1000.0, yield = 5.0, h = 0.1, elongation = 0.01;
  for (const double sign : {1.0, -1.0}) {
    Scenario scenario = oscillator(0.1, k, 1e-3, 2000);
    NetworkSpring& spring = network_of(scenario).spring[0];
    const double length = network_of(scenario).particle[1].position_m[0];
    spring.rest_length_m = length - sign * elongation;
    spring.yield_force_N = yield;
    spring.hardening_ratio = h;
    spring.damping_N_s_m = 5.0;
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    const double flow = (k * elongation - yield) / (k * (1.0 + h));
    // It swings with a tenth of its damping and is at rest after 2 s: exp(-25 x 2) of the amplitude.
    EXPECT_NEAR(freedom(trace, trace.displacement_m, 3).back(), -sign * (elongation - flow), 1e-9);
    EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], flow / *spring.rest_length_m, 1e-12);
  }
}

TEST(SpringPlasticity, BelowItsYieldForceASpringIsElastic) {
  Scenario scenario = oscillator(1.0, 1000.0, 2e-3, 1000);
  network_of(scenario).spring[0].yield_force_N = 5.0;
  network_of(scenario).load = {{1, {0.0, 1.0}, {{0, 0, 0}, {4.9, 0, 0}}}};
  EXPECT_EQ(run(scenario).metrics[Metric::plastic_strain_max], 0.0);
}

}  // namespace
}  // namespace unbruised
