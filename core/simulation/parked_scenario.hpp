#pragma once

/// @file
/// A scenario between two steps, outside any lane.

#include "core/lanes/lane_archive.hpp"
#include "core/simulation/lane_run.hpp"

namespace unbruised {

struct ParkedScenario {
  int ticks = 1;  ///< of its last step
  LaneRun run;
  LaneContent content;
};

}  // namespace unbruised
