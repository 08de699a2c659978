#pragma once

/// @file
/// The rows of a `Trace` and its signals.

#include <array>
#include <optional>
#include <vector>

#include "core/body/body_state.hpp"
#include "core/motion/handling_cycle.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"
#include "core/simulation/energies.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// Wrenches that a six-axis sensor reads.
struct SensorRow {
  std::array<double, 6> reading{}, compensated{};
};

/// The signals of one row; forces act on the product and hold at the end of their step.
struct TraceRow {
  double time_s = 0;
  bool gripper = false;
  bool yields = false;  ///< the product can keep a deformation
  bool ranged = false;  ///< there are range sensors
  std::size_t surface_count = 0, finger_count = kJawFingers;
  /// In the order of traces: pads, support, what the cell lists.
  std::array<std::array<double, 3>, kSurfaceCount> surface_force_N{}, surface_torque_N_m{};
  std::array<double, kSurfaceCount> closed{}, sliding{};
  std::array<double, kMostFingers> finger_way_m{}, finger_speed_m_s{};
  std::array<double, 3> palm_m{}, palm_rotation_rad{};
  CyclePhase phase = CyclePhase::approach;
  std::array<double, kMostFingers> yield_ratio{}, slip_m{}, slip_rad{}, range_m{};
  double support_yield_ratio = 0;
  double patch_pressure_Pa = 0;
  double plastic_strain = 0;
  double absorbed_energy_J = 0;
  double plastic_work_J = 0;  ///< of the cells alone
  StoredEnergy stored;
  Dissipated dissipated;
  WorkDone work;
  std::array<double, kMostFingers> friction_margin{};
  /// Where the product has a floating frame: a unit quaternion w, x, y, z, and the angular velocity of the whole.
  std::optional<std::array<double, 4>> attitude;
  std::array<double, 3> spin_rad_s{};
  std::optional<SensorRow> sensor;  ///< where there is a six-axis sensor
};

/// Declares the signals and stores the rest positions.
void start_trace(const std::vector<std::array<double, 3>>& position_m, const Scenario& scenario, Trace& trace);

/// Appends one row.
void append_row(const TraceRow& row, const BodyState& state, Trace& trace);

}  // namespace unbruised
