#pragma once

/// @file
/// What the kinds beside sweep and window found, in lines for people.

#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The answer first: best strategy, probability, checks, front, verdict, effects. Empty without such tables.
std::vector<std::string> found_lines(const std::vector<ResultTable>& tables);

}  // namespace unbruised::studies
