#pragma once

/// @file
/// The faces of a scenario's cell and gripper, as a replay shows them.

#include <vector>

#include "core/outcome/replay.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// In the order of traces.
std::vector<ReplaySurface> replay_surfaces(const Scenario& scenario);

}  // namespace unbruised
