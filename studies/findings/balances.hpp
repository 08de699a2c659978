#pragma once

/// @file
/// How well force and energy add up in the rows of a study and whether steps resolve its impacts: which rows are
/// not to be believed.

#include <string>

#include "studies/results/row_summary.hpp"
#include "studies/results/study_rows.hpp"

namespace unbruised::studies {

/// "worst balances: ..." with the errors of largest size, their signs, scenarios and outcomes, over all rows and
/// among those held. Empty when no row has a balance.
std::string balance_line(const StudyRows& rows);
/// Of held rows whose energy error exceeds the bound: how many, the worst, and what it means. Empty: there is
/// none.
std::string balance_doubt(const StudyRows& rows);
/// Of rows with such an impact: how many, the fewest steps, and what it means. Empty: there is none.
std::string impact_doubt(const StudyRows& rows);

}  // namespace unbruised::studies
