#pragma once

/// @file
/// What the kinds beside sweep and window found, in lines for people.

#include <string>
#include <string_view>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The answer first: best strategy, probability, checks, front, verdict, effects. Empty without such tables.
/// @param held_words what `held` may be called (claims.hpp)
std::vector<std::string> found_lines(const std::vector<ResultTable>& tables, std::string_view held_words);

}  // namespace unbruised::studies
