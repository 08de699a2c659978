#pragma once

/// @file
/// A body that flies freely and spins, and what its trace says of its turning.

#include <array>
#include <cmath>
#include <vector>

#include "core/door/eigen.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

/// A box of 80 x 50 x 30 mm in cells of 10 mm, without gravity and with nothing around it.
inline Scenario spinning_box(const std::array<double, 3>& spin_rad_s, double time_step_s, double duration_s,
                             double youngs_modulus_Pa = 2e5) {
  Scenario scenario;
  LatticeParameters box;
  box.size_m = {0.08, 0.05, 0.03};
  box.cell_size_m = 0.01;
  box.density_kg_m3 = 1000.0;
  box.youngs_modulus_Pa = youngs_modulus_Pa;
  box.poisson_ratio = 0.25;
  box.relaxation_time_s = 2e-3;
  box.initial_spin_rad_s = spin_rad_s;
  scenario.product = box;
  scenario.cell.support = false;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.simulation.time_step_s = time_step_s;
  scenario.simulation.duration_s = duration_s;
  return scenario;
}

/// The masses and places at rest from their centre, of the simulator's own lattice.
struct Points {
  std::vector<double> mass_kg;
  std::vector<Eigen::Vector3d> X;
};
Points points_of(const Scenario& scenario);

/// One row of a trace.
struct SpinRow {
  Eigen::Quaterniond attitude;
  Eigen::Vector3d spin_rad_s;        ///< as the trace has it
  Eigen::Vector3d momentum_kg_m2_s;  ///< sum m y x v from the particles of the trace, about their centre
  Eigen::Matrix3Xd u;                ///< in the axes of the attitude, from the body at rest
  Eigen::Vector3d center_motion_m;
};
SpinRow spin_row(const Trace& trace, const Points& points, std::size_t row);
inline SpinRow last_row(const Trace& trace, const Points& points) {
  return spin_row(trace, points, trace.time_s.size() - 1);
}

/// Angle between two attitudes [rad].
inline double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return 2.0 * (a.conjugate() * b).vec().norm();
}

}  // namespace unbruised::testing
