// What the contact solve of a scenario takes, from closed forms.

#include "core/contact/contact_effort.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "core/contact/layered_face.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A stiff plate of 2 x 2 x 0.6 cm between viscous pads.
Scenario plate(double mass_kg) {
  Scenario scenario = small_box();
  make_product(scenario, {0.006, 0.02, 0.02}, 0.003, mass_kg, 1e8).friction = 0.6;
  jaw_of(scenario).pad_relaxation_time_s = 2e-3;
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.grip_force_N = 2.0;
  scenario.strategy.settle_s = 0.05;
  scenario.strategy.recover_s = 0.0;
  return scenario;
}

TEST(ContactEffort, TheCouplingIsThatOfTheLayersAndTheInertia) {
  const Scenario scenario = plate(0.02);
  const ParallelJawParameters& jaw = *parallel_jaw(scenario);
  const double dt = scenario.simulation.time_step_s, theta_dt = scenario.simulation.theta * dt;
  const double layer = jaw.pad_modulus_Pa / jaw.pad_thickness_m * 0.02 * 0.02;
  const double in_a_step = layer * (1.0 + 3.0 * 2e-3 / theta_dt);
  EXPECT_NEAR(contact_coupling(scenario), 2.0 * in_a_step * theta_dt * theta_dt / (6.0 * 0.02), 1e-9);
}

TEST(ContactEffort, TheStepOfACouplingHasIt) {
  for (const double mass : {1e-3, 0.02, 0.5}) {
    for (const double coupling : {1.0, kLargestCoupling}) {
      Scenario scenario = plate(mass);
      scenario.simulation.time_step_s = time_step_of_coupling_s(scenario, coupling);
      EXPECT_NEAR(contact_coupling(scenario), coupling, 1e-9 * coupling);
    }
  }
}

TEST(ContactEffort, SweepsAreThoseThatARunTakesWithinAFactorOfTwo) {
  for (const auto& [mass, step_s] : {std::pair(0.05, 1e-3), {0.01, 4e-4}, {0.005, 1e-3}}) {
    Scenario scenario = plate(mass);
    scenario.simulation.time_step_s = step_s;
    scenario.simulation.duration_s = 0.4;  // gripped and lifted
    const ScenarioResult result = run(scenario);
    const double held_s = 0.4 - result.metrics[Metric::first_contact_time_s];
    const double each = result.metrics[Metric::contact_iterations] / (held_s / scenario.simulation.time_step_s);
    EXPECT_GT(estimated_sweeps(scenario), each / 2.0) << mass << " kg: " << each;
    EXPECT_LT(estimated_sweeps(scenario), each * 2.0) << mass << " kg: " << each;
  }
}

TEST(LayeredFace, CoversWhatThePadCovers) {
  Scenario scenario = plate(0.02);
  const auto area = [&] {
    return side_at_pad(lattice_of(scenario), *parallel_jaw(scenario), scenario.cell).patch_m2(1.0);
  };
  EXPECT_DOUBLE_EQ(area(), 0.02 * 0.02);
  scenario.cell.grip_offset_m = 0.015;  // from the plate's middle on
  EXPECT_NEAR(area(), 0.01 * 0.02, 1e-15);
  scenario.cell.grip_height_m = 0.026;  // above it
  EXPECT_EQ(area(), 0.0);
}

}  // namespace
}  // namespace unbruised
