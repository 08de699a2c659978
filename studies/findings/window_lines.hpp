#pragma once

/// @file
/// Grip windows and set-points in lines for people.

#include <cstddef>
#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The window of each combination; then, for each strategy, the window over everything that is not chosen and its
/// set-point; then the best strategy.
/// @param set_points table of that name; null: no such lines
/// @param most_lines of combinations, and of strategies; where there are more, those without a window come first.
std::vector<std::string> window_lines(const WindowTable& window, const ResultTable* set_points,
                                      std::size_t most_lines);

}  // namespace unbruised::studies
