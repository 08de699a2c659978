#pragma once

/// @file
/// The grip window from sampled grip forces: between which of them the holding starts, and between which the
/// damage starts. Sweeps read it from their grid, window studies refine it (window_search.hpp).

#include <optional>
#include <string>
#include <vector>

#include "studies/goals/verdict.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// What one run says about its grip force.
struct GripSample {
  double grip_force_N = 0.0;
  Verdict holds = Verdict::unknown;
  Verdict undamaged = Verdict::unknown;
  double peak_finger_force_N = kAbsent;
};

/// The window that the samples show.
///
/// F_hold = least force from which on every sample holds: looked for among the forces up to the first damaging
/// one, and among all of them when none of those holds. F_damage = greatest force up to which every sample is
/// undamaged. Each value is the bracket's end on the safe side; NaN, and the reason in the note, where the samples
/// do not enclose it. The window exists when a sampled force neither fails to hold nor damages, i.e. when
/// hold_bracket_high_N <= damage_bracket_low_N. Unknown verdicts count as failures at the outer side only: for the
/// holding when no lower force holds, for the damage when no higher force is undamaged.
/// @param samples at least one, any order, forces all different.
/// @return a row without inputs.
WindowRow read_grip_window(std::vector<GripSample> samples);

/// The window common to all rows.
struct CommonWindow {
  bool exists = false;
  double hold_force_N = kAbsent;          ///< the largest F_hold
  double damage_force_N = kAbsent;        ///< the smallest F_damage
  bool hold_is_bound = false;             ///< the least force tried holds already: F_hold lies below
  bool damage_is_bound = false;           ///< the greatest force tried does not damage: F_damage lies above
  const WindowRow* hold_row = nullptr;    ///< the row that sets the lower end
  const WindowRow* damage_row = nullptr;  ///< the row that sets the upper end
};
CommonWindow common_window(const std::vector<WindowRow>& rows);

}  // namespace unbruised::studies
