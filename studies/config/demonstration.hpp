#pragma once

/// @file
/// A recorded demonstration as a strategy: where the palm went between closing and opening the gripper becomes
/// lift, waypoints and place.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

/// The key that names the file.
inline constexpr std::string_view kDemonstrationKey = "strategy.demonstration";

struct DemonstrationText {
  std::string_view content;
  std::shared_ptr<const std::string> file;
  int rank = 0;
  double tolerance_m = 0.002;
  double tolerance_rad = 0.03;
  bool as_shown = true;  ///< it takes the time that it took; else only its way counts
};

/// Entries of lift, waypoints and place: straight ways between places of the demonstration, blended, and nowhere
/// further from it than the tolerances. Columns: time_s, x_m, y_m, z_m of the palm (z up); its rotation as rx_rad,
/// ry_rad, rz_rad or qw, qx, qy, qz, whose x is the grip axis; closed (0 or 1); grip_force_N of each finger.
/// Places are taken from where the gripper closes.
std::vector<Entry> demonstration_entries(const DemonstrationText& text, Problems& problems);

}  // namespace unbruised::studies
