#pragma once

/// @file
/// Products that fall onto a support, and the energy at which they yield there.

#include <cmath>

#include "tests/core/contact/kiwi_scenes.hpp"

namespace unbruised::testing {

/// Meets the support without gravity and without damping.
inline Scenario falling(const LatticeParameters& product, double energy_J) {
  Scenario scenario = small_box();
  scenario.product = product;
  LatticeParameters& body = lattice_of(scenario);
  body.loss_ratio.reset();
  body.at_frequency_Hz.reset();
  body.relaxation_time_s = 0.0;
  body.initial_velocity_m_s = {0.0, 0.0, -std::sqrt(2.0 * energy_J / *body.mass_kg)};
  scenario.gripper = NoGripper{};
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support_relaxation_time_s = 0.0;
  scenario.simulation.time_step_s = 2e-4;
  scenario.simulation.duration_s = 0.02;
  return scenario;
}

/// Energy of the fall at which the ratio passes 1, from one that is near: the force grows with its 3/5 power, the
/// ratio with the cube root of the force (Hertz).
inline double yield_energy_J(const LatticeParameters& product, double near_J) {
  const ScenarioResult result = run(falling(product, near_J));
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  const double ratio = result.metrics[Metric::contact_yield_ratio_max];
  EXPECT_NEAR(ratio, 1.0, 0.1) << "too far for the power law";
  return near_J / std::pow(ratio, 5.0);
}

}  // namespace unbruised::testing
