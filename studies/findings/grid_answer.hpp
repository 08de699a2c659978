#pragma once

/// @file
/// The answer of a sweep that does not vary the grip force: which strategy is held unmarked over all products and
/// cells that were tried, with the shortest cycle.

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct GridAnswer {
  ResultTable table;                     ///< `strategies` (docs/results.md): one row per strategy
  std::optional<std::uint64_t> best;     ///< a scenario with the best strategy; nothing: none is held in all
  std::vector<std::uint64_t> best_rows;  ///< all scenarios with it, ascending
  std::vector<ColumnInfo> keys;          ///< varied keys that are chosen or stand apart
  std::vector<InputValue> best_values;   ///< of `keys`; empty without a best
  /// Keys of the strategy that have one value for each product or cell, so that the answer is about the rest: a
  /// force of its own for each fruit.
  std::vector<ColumnInfo> following;
};

/// @param rows all of the study's, by id. Of equal cycle times the first wins.
GridAnswer grid_answer(const std::vector<ColumnInfo>& inputs, const StudyRows& rows);

}  // namespace unbruised::studies
