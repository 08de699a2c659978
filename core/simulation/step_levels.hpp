#pragma once

/// @file
/// The step lengths that a scenario may use.

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Multiples of `simulation.time_step_s`: 1 <= medium <= longest.
struct StepLevels {
  int medium = 1;
  int longest = 1;

  /// Is there anything to choose?
  [[nodiscard]] bool any() const { return longest > 1; }
  /// The longest of them that is no longer than `most`; 1 or more.
  [[nodiscard]] int not_beyond(int most) const { return longest <= most ? longest : medium <= most ? medium : 1; }
};

/// Of a scenario with `simulation.levels = "auto"` whose events are all foreseen by its own plan and gaps: a
/// product that stays upright between the flat pads of a jaw, its support at rest. All others take one step
/// length.
StepLevels step_levels(const Scenario& scenario);

}  // namespace unbruised
