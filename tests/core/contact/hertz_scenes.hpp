#pragma once

/// @file
/// A sphere pressed between two plates, and what Hertz says about it.

#include <cmath>
#include <iostream>
#include <numbers>

#include "tests/core/contact/pads_at_rest.hpp"

namespace unbruised::testing {

struct Pressed {
  double approach_m = 0;     ///< of one plate past the undeformed sphere
  double over_hertz = 0;     ///< force / Hertz's force at the approach without the layer's own compression
  double contact_count = 0;  ///< on one plate
};

/// Presses a frictionless sphere of R = 30 mm, E = 1 MPa, nu = 0.3 with a force until it rests.
/// @param layer_ratio stiffness of the plates' layer over that of a column of the product 8.5 mm deep
/// @param change of the sphere, as it is
inline Pressed press_sphere(int cells_across, double force_N, double layer_ratio,
                            void (*change)(LatticeParameters&) = nullptr) {
  const double E = 1e6, nu = 0.3, R = 0.03;
  const double plane = E / (1.0 - nu * nu);
  const double layer = layer_ratio * E / 0.0085;
  Scenario scenario = small_box();
  LatticeParameters& ball = lattice_of(scenario);
  ball.shape = Shape::sphere;
  ball.size_m = {2 * R, 2 * R, 2 * R};
  if (change != nullptr) change(ball);
  ball.cell_size_m = 2 * R / cells_across;
  ball.youngs_modulus_Pa = E;
  ball.poisson_ratio = nu;
  ball.friction = 0.0;
  ball.relaxation_time_s = 5e-3;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  scenario.cell.approach_gap_m = 1e-4;
  jaw_of(scenario).pad_size_m = {0.06, 0.06};
  jaw_of(scenario).pad_thickness_m = 8.5e-3;  // no place is pressed flat
  jaw_of(scenario).pad_modulus_Pa = layer * 8.5e-3;
  jaw_of(scenario).drive_viscous_N_s_m = 50.0;
  jaw_of(scenario).max_force_N = 1000.0;
  scenario.strategy.approach_speed_m_s = 0.01;
  scenario.strategy.grip_force_N = force_N;
  scenario.strategy.contact_force_N = 0.6;
  scenario.strategy.grip_ramp_s = 0.3;
  scenario.strategy.settle_s = 10.0;
  scenario.simulation.time_step_s = 2e-3;
  scenario.simulation.duration_s = 0.6;
  scenario.simulation.trace_interval_s = 0.02;
  Trace trace;
  run(scenario, &trace);
  Pressed pressed;
  pressed.contact_count = last_of(trace, "contact_count");
  pressed.approach_m = approach_at_rest_m(trace, scenario, 1e-3);
  // Hertz's largest pressure presses the layer by p0 / layer; small beside the approach for a stiff layer only.
  const double ideal_m = std::pow(0.75 * force_N / (plane * std::sqrt(R)), 2.0 / 3.0);
  const double p0 = 2.0 * plane / std::numbers::pi * std::sqrt(ideal_m / R);
  const double sphere_m = pressed.approach_m - p0 / layer;
  pressed.over_hertz = force_N / (4.0 / 3.0 * plane * std::sqrt(R) * std::pow(sphere_m, 1.5));
  std::cout << "[ measured ] " << cells_across << " cells, layer ratio " << layer_ratio << ", " << force_N
            << " N: approach " << pressed.approach_m * 1e3 << " mm (Hertz " << ideal_m * 1e3
            << " mm), contact radius " << std::sqrt(R * ideal_m) / ball.cell_size_m << " cells, "
            << pressed.contact_count << " contacts, force / Hertz = " << pressed.over_hertz << "\n";
  return pressed;
}

}  // namespace unbruised::testing
