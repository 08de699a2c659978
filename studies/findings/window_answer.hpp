#pragma once

/// @file
/// The answer of a study that has grip windows: for each strategy the window common to every product and cell that
/// was tried, its set-point, and the strategy with the shortest cycle among those that have one.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/findings/set_point.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// A strategy (on one gripper) and what it does over all products and cells.
struct StrategyWindow {
  std::vector<InputValue> values;         ///< of WindowAnswer::keys
  std::vector<std::size_t> rows;          ///< of the window table
  bool exists = false;                    ///< some force holds in every row and marks in none
  double hold_force_N = kAbsent;          ///< the largest of the rows' lower ends
  double damage_force_N = kAbsent;        ///< the smallest of the rows' upper ends
  bool hold_is_bound = false;             ///< the least force tried holds already
  bool damage_is_bound = false;           ///< the greatest force tried does not damage
  std::optional<std::size_t> hold_row;    ///< which row sets the lower end; nothing: no row has a window
  std::optional<std::size_t> damage_row;  ///< which row sets the upper end
  SetPoint set_point;
  double cycle_time_s = kAbsent;  ///< the longest of the rows' near the set-point
  bool is_best = false;           ///< the shortest cycle of those with a set-point, of its gripper
};

struct WindowAnswer {
  std::vector<ColumnInfo> keys;  ///< the varied keys that are chosen or stand apart, in the study's order
  std::vector<ColumnInfo> over;  ///< the varied keys that the answer has to hold over
  std::vector<StrategyWindow> strategies;
};

/// What the gripper of a row of the window table can set.
using SettingOfRow = std::function<ForceSetting(std::size_t row)>;

/// Fills the set-point columns of every row, each for itself, from the safe ends (at half the time step where that
/// was looked at and is narrower).
void add_set_points(WindowTable& window, const SettingOfRow& setting);

/// @param inputs, rows of all scenarios: their cycle times are read
WindowAnswer window_answer(const WindowTable& window, const SettingOfRow& setting,
                           const std::vector<ColumnInfo>& inputs, const StudyRows& rows);

/// The fastest of the best strategies; nullptr: none has a set-point.
const StrategyWindow* fastest_best(const WindowAnswer& answer);

/// Table `set_points`: a row per strategy (docs/results.md); its attribute `answer` is the sentence to read,
/// `told` the row that it tells of: the fastest with a set-point, else the first with a window, else the first.
ResultTable set_points_table(const WindowAnswer& answer);

}  // namespace unbruised::studies
