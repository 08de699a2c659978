#pragma once

/// @file
/// What a second look at the best strategy says against it, in sentences that travel with the answer.

#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// From the tables `verification` and `pareto`: checks in which the best strategy or points of the front break a
/// constraint or the winner is none any more, and a margin against damage that moves by more than
/// kDamageMarginTrust of the limit. Empty without such tables.
std::vector<std::string> check_warnings(const std::vector<ResultTable>& tables);

/// The check of a winner with half the time step, as tables, lines and page name it.
inline constexpr const char* kHalfStep = "half the time step";

/// In parts of the limit. A metric that moves more says that the step or the mesh decides, not the product.
inline constexpr double kDamageMarginTrust = 0.05;

}  // namespace unbruised::studies
