#pragma once

/// @file
/// A sphere pressed between two stiff plates, and what Hertz says about it.

#include <cmath>
#include <iostream>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

/// Presses a sphere of `cells` across until Hertz's contact radius is `radius_cells` cells.
/// @return measured force over Hertz's force at the measured approach
inline double force_over_hertz(int cells, double radius_cells) {
  const double E = 1e6, nu = 0.3, R = 0.03;
  const double plane = E / (1.0 - nu * nu);
  const double cell = 2.0 * R / cells;
  const double radius = radius_cells * cell;
  const double wanted_m = radius * radius / R;  // approach of one plate
  const double force = 4.0 / 3.0 * plane * std::sqrt(R) * std::pow(wanted_m, 1.5);
  Scenario scenario = small_box();
  LatticeParameters& ball = lattice_of(scenario);
  ball.shape = Shape::sphere;
  ball.size_m = {2 * R, 2 * R, 2 * R};
  ball.cell_size_m = cell;
  ball.youngs_modulus_Pa = E;
  ball.poisson_ratio = nu;
  ball.friction = 0.0;
  ball.relaxation_time_s = 5e-3;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  scenario.cell.approach_gap_m = 1e-4;
  scenario.gripper->pad_size_m = {0.06, 0.06};
  // A layer 300 times as stiff as a column of the product one contact radius deep.
  scenario.gripper->pad_thickness_m = 1e-3;
  scenario.gripper->pad_modulus_Pa = 300.0 * E * 1e-3 / radius;
  scenario.gripper->drive_viscous_N_s_m = 200.0;
  scenario.strategy.approach_speed_m_s = 0.01;
  scenario.strategy.grip_force_N = force;
  scenario.strategy.contact_force_N = 0.01 * force;
  scenario.strategy.grip_ramp_s = 0.5;
  scenario.strategy.settle_s = 10.0;
  scenario.simulation.time_step_s = 5e-3;
  scenario.simulation.duration_s = 1.0;
  scenario.simulation.trace_interval_s = 0.1;
  Trace trace;
  run(scenario, &trace);
  const auto last = [&](const char* name, std::size_t at) {
    const std::vector<double> values = column(trace, name, at);
    return values.empty() ? std::nan("") : values[values.size() - 1];
  };
  const double way = last("finger_way_m", 0) + last("finger_way_m", 1);
  const double pressed = last("finger_force_N", 0);
  EXPECT_NEAR(pressed, force, 1e-3 * force) << "at rest";
  const double approach = 0.5 * way - scenario.cell.approach_gap_m;
  const double hertz = 4.0 / 3.0 * plane * std::sqrt(R) * std::pow(approach, 1.5);
  std::cout << "[ measured ] " << cells << " cells, a = " << radius_cells << " cells, indentation / R = " << approach / R
            << ", " << last("contact_count", 0) << " contacts: force / Hertz = " << pressed / hertz
            << "\n";
  return pressed / hertz;
}

}  // namespace unbruised::testing
