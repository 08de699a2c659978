#pragma once

/// @file
/// What a second look at the best strategy says against it, in sentences that travel with the answer.

#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// From the table `verification`: checks in which the best strategy breaks a constraint, and a margin against
/// damage that moves by more than kDamageMarginTrust of the limit. Empty without such a table.
std::vector<std::string> check_warnings(const std::vector<ResultTable>& tables);

/// In parts of the limit. A metric that moves more says that the step or the mesh decides, not the product.
inline constexpr double kDamageMarginTrust = 0.05;

}  // namespace unbruised::studies
