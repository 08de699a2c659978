#pragma once

/// @file
/// The step lengths that a scenario may use.

#include <cstddef>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Multiples of `simulation.time_step_s`, ascending from 1.
struct StepLevels {
  std::vector<int> ticks = {1};
};

/// Of a scenario with `simulation.levels = "auto"` whose events are all foreseen by its own plan and gaps: a
/// product that stays upright between the flat pads of a jaw, its support at rest. All others take one step
/// length. Light products between hard pads take shorter ones, so that the contact solves do not get harder.
StepLevels step_levels(const Scenario& scenario);

}  // namespace unbruised
