#pragma once

/// @file
/// An arm out of a URDF file: the one place that knows urdfdom. Fixed joints are taken into the links that they
/// stand between; joints off the way to the tip stay at angle 0; what is only to be seen or hit is not looked at,
/// so meshes (package://) need not be there.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

struct UrdfText {
  std::string_view content;
  std::string tip_link;  ///< empty: the only link at an end
  std::shared_ptr<const std::string> file;
  int rank = 0;
};

/// The entries robot.joint[].*, robot.flange_place_m and robot.flange_rotation_rad of the chain from the root to
/// the tip; none where there is a problem.
std::vector<Entry> urdf_entries(const UrdfText& text, Problems& problems);

}  // namespace unbruised::studies
