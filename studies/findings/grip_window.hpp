#pragma once

/// @file
/// The grip window from sampled grip forces: from which of them on the product is held, and up to which of those
/// that hold it stays unmarked. Sweeps read it from their grid, window studies refine it (window_search.hpp).

#include <cstddef>
#include <string>
#include <vector>

#include "studies/findings/claims.hpp"
#include "studies/goals/verdict.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// What one run says about its grip force.
struct GripSample {
  double grip_force_N = 0.0;
  Verdict holds = Verdict::unknown;
  Verdict undamaged = Verdict::unknown;
  double peak_finger_force_N = kAbsent;
  DamageClaim damage = DamageClaim::judged;  ///< the same of all samples of a window
  bool unresolved_impact = false;            ///< its peak force came within too few steps
};

/// What a grip force does, as far as the window is concerned: damage counts where the product is held.
enum class GripState {
  fails,   ///< does not hold, damaged or not
  safe,    ///< holds and leaves the product unmarked
  marks,   ///< damages, and is not known to fail
  untold,  ///< the run ended before it could be told
};

/// The states of samples in ascending order of force. Untold ones between two safe ones count as safe.
std::vector<GripState> grip_states(const std::vector<GripSample>& samples);

/// Safe forces that follow each other: indices first .. last.
struct SafeInterval {
  std::size_t first = 0;
  std::size_t last = 0;
};
/// All of them, in ascending order.
std::vector<SafeInterval> safe_intervals(const std::vector<GripState>& states);

/// Two neighbouring forces between which a window begins or ends.
struct ForceBracket {
  double low_N = 0.0;
  double high_N = 0.0;
  friend bool operator==(const ForceBracket&, const ForceBracket&) = default;
};

/// The brackets that a search has to narrow, in ascending order: the ends of the safe intervals (the widest few of
/// them); where no force is safe, every step from a force that fails to one that marks, for a window may lie
/// between them, and the bracket in which the damage begins.
std::vector<ForceBracket> deciding_brackets(std::vector<GripSample> samples);

/// The window that the samples show: it exists when some force holds the product and leaves it unmarked.
///
/// Safe forces that follow each other are an interval, and the widest (in ratio, then the lower) is the window:
/// F_hold is its least force, F_damage its greatest. Each is the bracket's end on the safe side; NaN, and the
/// reason in the note, where the samples do not enclose it. `intervals` lists all of them. Where there is none,
/// F_hold is the least force of the first held ones, and F_damage the greatest one below it that leaves the
/// product unmarked, held or not.
/// Where damage is not judged the window has a lower end only: the damage columns are NaN, and the note says why.
/// @param samples any order, forces all different.
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
  const WindowRow* damage_row = nullptr;  ///< the row that sets the upper end; none: damage is judged in no row
};
CommonWindow common_window(const std::vector<WindowRow>& rows);

}  // namespace unbruised::studies
