#pragma once

/// @file
/// A list of waypoints from a CSV file.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

/// The key that names the file.
inline constexpr std::string_view kWaypointFileKey = "strategy.waypoint_file";

/// Entries of [[strategy.waypoint]], one for each row. The header names the columns: x_m, y_m, z_m; a rotation as
/// rx_rad, ry_rad, rz_rad or qw, qx, qy, qz; time_s (since the lift ended, ascending) or speed_m_s; blend_m,
/// wait_s.
/// @param file, rank of the text, for messages
std::vector<Entry> waypoint_entries(std::string_view content, const std::shared_ptr<const std::string>& file,
                                    int rank, Problems& problems);

}  // namespace unbruised::studies
