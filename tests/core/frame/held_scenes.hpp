#pragma once

/// @file
/// A block between two pads that turn it.

#include <numbers>

#include "core/motion/motion_plan.hpp"
#include "tests/core/frame/spin_scenes.hpp"

namespace unbruised::testing {

inline constexpr double kQuarter_rad = std::numbers::pi / 2.0;

/// A block of 50 mm and 0.1 kg in cells of 10 mm, gripped where it stands, lifted 60 mm, tilted and held.
inline Scenario tilted_block(const std::array<double, 3>& tilt_rad, double grip_force_N, double time_step_s) {
  Scenario scenario = small_box();
  LatticeParameters& block = make_product(scenario, {0.05, 0.05, 0.05}, 0.01, 0.1, 2e5);
  block.friction = 1.0;
  block.relaxation_time_s = 2e-3;
  jaw_of(scenario).pad_size_m = {0.03, 0.03};
  jaw_of(scenario).pad_relaxation_time_s = 2e-3;
  scenario.cell.lift_height_m = 0.06;
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.grip_force_N = grip_force_N;
  scenario.strategy.contact_force_N = 0.2;
  scenario.strategy.settle_s = 0.1;
  scenario.strategy.lift_acceleration_m_s2 = 3.0;
  scenario.strategy.tilt_rad = tilt_rad;
  scenario.strategy.hold_s = 0.3;
  scenario.simulation.time_step_s = time_step_s;
  return scenario;
}

/// Forces of the fingers on the product along the axes of the palm, and its rotation, in one row of a trace.
struct GripRow {
  Eigen::Vector3d left_N, right_N, rotation_rad;
  /// Towards the product each.
  [[nodiscard]] double mean_normal_N() const { return 0.5 * (left_N.x() - right_N.x()); }
  [[nodiscard]] double normal_difference_N() const { return -right_N.x() - left_N.x(); }
};

inline Eigen::Quaterniond palm_attitude(const Eigen::Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_rad / angle));
}

inline GripRow grip_row(const Trace& trace, std::size_t row) {
  const double* force = signal(trace, "finger_force_N").values.data() + 6 * row;
  const double* turn = signal(trace, "palm_rotation_rad").values.data() + 3 * row;
  GripRow out{{force[0], force[1], force[2]}, {force[3], force[4], force[5]}, {turn[0], turn[1], turn[2]}};
  const Eigen::Quaterniond back = palm_attitude(out.rotation_rad).conjugate();
  out.left_N = back * out.left_N;
  out.right_N = back * out.right_N;
  return out;
}

/// The last row in a phase of the cycle.
inline std::size_t last_in_phase(const Trace& trace, CyclePhase phase) {
  const std::vector<double> phases = column(trace, "phase");
  std::size_t last = 0;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i] == static_cast<double>(phase)) last = i;
  }
  return last;
}

}  // namespace unbruised::testing
