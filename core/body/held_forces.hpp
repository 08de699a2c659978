#pragma once

/// @file
/// Contact forces that a step begins with (docs/theory.md, "Solving a step").

#include <span>

#include "core/lanes/lane.hpp"

namespace unbruised {

/// Those of the last solve, on touchable particles.
struct HeldForces {
  const LaneArray* force_N = nullptr;  ///< rows 3 x touchable particle + axis; null: none are held
  std::span<const int> on;             ///< touchable particles on which they may not be zero, ascending
};

}  // namespace unbruised
