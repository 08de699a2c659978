#pragma once

/// @file
/// Products pressed between shaped pads until they rest.

#include <cmath>
#include <iostream>

#include "tests/core/contact/pads_at_rest.hpp"

namespace unbruised::testing {

/// A frictionless product of 1 MPa without weight, pressed between pads of `layer_N_m3`.
inline Scenario pressed_product(Shape shape, const std::array<double, 3>& size_m, double cell_m,
                                double layer_N_m3) {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.shape = shape;
  product.size_m = size_m;
  product.cell_size_m = cell_m;
  product.youngs_modulus_Pa = 1e6;
  product.poisson_ratio = 0.3;
  product.friction = 0.0;
  product.relaxation_time_s = 5e-3;
  only_grip(scenario);
  scenario.cell.approach_gap_m = 1e-4;
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad_thickness_m = 8.5e-3;
  jaw.pad_modulus_Pa = layer_N_m3 * jaw.pad_thickness_m;
  jaw.pad_size_m = {0.04, 0.04};
  jaw.drive_viscous_N_s_m = 50.0;
  jaw.max_force_N = 1000.0;
  scenario.strategy.approach_speed_m_s = 0.01;
  scenario.strategy.contact_force_N = 0.3;
  scenario.strategy.grip_ramp_s = 0.2;
  scenario.strategy.settle_s = 10.0;
  scenario.simulation.time_step_s = 2e-3;
  scenario.simulation.duration_s = 0.5;
  scenario.simulation.trace_interval_s = 0.02;
  return scenario;
}

inline double plane_Pa(const Scenario& scenario) {
  const auto& product = std::get<LatticeParameters>(scenario.product);
  return product.youngs_modulus_Pa / (1.0 - product.poisson_ratio * product.poisson_ratio);
}

struct AtRest {
  double approach_m = 0.0, yield_ratio = 0.0, energy_error = 0.0;
  std::array<double, 3> force_N{};  ///< of the left finger on the product
};

/// @param tolerance of the grip force at rest
inline AtRest press(const Scenario& scenario, double tolerance = 2e-3) {
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  AtRest rest;
  rest.approach_m = approach_at_rest_m(trace, scenario, tolerance);
  rest.yield_ratio = result.metrics[Metric::contact_yield_ratio_max];
  rest.energy_error = result.metrics[Metric::energy_balance_error];
  for (std::size_t i = 0; i < 3; ++i) rest.force_N[i] = last_of(trace, "finger_force_N", i);
  return rest;
}

inline PadParameters& pad_of(Scenario& scenario) { return jaw_of(scenario).pad; }

}  // namespace unbruised::testing
