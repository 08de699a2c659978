#pragma once

/// @file
/// Products that fall, roll and tip on the surfaces of a cell, and what their traces say.

#include "tests/core/frame/spin_scenes.hpp"

namespace unbruised::testing {

/// A support whose layer has this stiffness per area [N/m3].
inline void lay_support(CellParameters& cell, double layer_N_m3, double friction) {
  cell.support_thickness_m = 0.005;
  cell.support_modulus_Pa = layer_N_m3 * cell.support_thickness_m;
  cell.support_friction = friction;
}

/// 60 mm across, 100 g, five cells across, at rest on a slope that leans by `slope_rad` towards x.
inline Scenario roller(Shape shape, double slope_rad) {
  Scenario scenario;
  LatticeParameters product;
  product.shape = shape;
  product.size_m = {0.06, 0.06, 0.06};
  product.axis = Axis::y;
  product.cell_size_m = 0.012;
  product.mass_kg = 0.1;
  product.youngs_modulus_Pa = 2e6;
  product.relaxation_time_s = 1e-4;
  scenario.product = product;
  lay_support(scenario.cell, 4e7, 0.8);
  scenario.cell.gravity_m_s2 = {kGravity * std::sin(slope_rad), 0.0, -kGravity * std::cos(slope_rad)};
  scenario.simulation.contact_set = ContactSet::whole_surface;
  scenario.simulation.duration_s = 0.5;
  scenario.simulation.max_rotation_rad = 100.0;
  return scenario;
}

/// A box in cells of 10 mm that begins turned.
inline Scenario turned_box(const std::array<double, 3>& size_m, const std::array<double, 3>& rotation_rad) {
  Scenario scenario;
  LatticeParameters box;
  box.size_m = size_m;
  box.cell_size_m = 0.01;
  box.density_kg_m3 = 1000.0;
  box.youngs_modulus_Pa = 2e5;
  box.relaxation_time_s = 2e-3;
  box.initial_rotation_rad = rotation_rad;
  scenario.product = box;
  lay_support(scenario.cell, 2e8, 0.6);
  scenario.cell.support_relaxation_time_s = 2e-3;
  scenario.simulation.max_rotation_rad = 100.0;
  return scenario;
}

/// A box that falls leaning, by a centimetre, and tumbles.
inline Scenario thrown_box(double step_s, double duration_s) {
  Scenario scenario = turned_box({0.06, 0.04, 0.03}, {0.3, 0.4, 0.1});
  std::get<LatticeParameters>(scenario.product).initial_height_m = 0.01;
  scenario.simulation.contact_set = ContactSet::whole_surface;
  scenario.simulation.duration_s = duration_s;
  scenario.simulation.time_step_s = step_s;
  return scenario;
}

/// Motion of the centre of mass at the end of a trace.
struct Center {
  Eigen::Vector3d motion_m, velocity_m_s;
};
inline Center last_center(const Trace& trace, const Points& points) {
  const std::size_t n = points.X.size(), row = trace.time_s.size() - 1;
  Center center{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double total = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    const std::size_t at = 3 * (n * row + p);
    total += points.mass_kg[p];
    center.motion_m += points.mass_kg[p] * Eigen::Map<const Eigen::Vector3d>(trace.displacement_m.data() + at);
    center.velocity_m_s += points.mass_kg[p] * Eigen::Map<const Eigen::Vector3d>(trace.velocity_m_s.data() + at);
  }
  center.motion_m /= total;
  center.velocity_m_s /= total;
  return center;
}

/// Force of the support at the end of a trace.
inline Eigen::Vector3d last_support_N(const Trace& trace) {
  const auto& values = signal(trace, "support_force_N").values;
  return Eigen::Map<const Eigen::Vector3d>(values.data() + values.size() - 3);
}

}  // namespace unbruised::testing
