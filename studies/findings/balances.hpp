#pragma once

/// @file
/// How well force and energy add up in the rows of a study and whether steps resolve its impacts: which rows are
/// not to be believed.

#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// "worst balances: ..." with the errors of largest size, their signs, scenarios and outcomes, over all rows and
/// among those held. Empty when no row has a balance.
std::string balance_line(const std::vector<ScenarioRow>& rows);
/// Of held rows whose energy error exceeds the bound: how many, the worst, and what it means. Empty: there is
/// none.
std::string balance_doubt(const std::vector<ScenarioRow>& rows);
/// Did the force that decides rise by half of its peak within fewer than kFewestRiseSteps steps? Then what rests
/// on the peak is looked at again at half the step.
bool impact_is_unresolved(const ScenarioResult& result);
/// Of rows with such an impact: how many, the fewest steps, and what it means. Empty: there is none.
std::string impact_doubt(const std::vector<ScenarioRow>& rows);

}  // namespace unbruised::studies
