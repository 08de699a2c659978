#pragma once

/// @file
/// The study kinds that search: optimize, robust and pareto. Searches run at once and ask one broker; what they
/// find is a function of the study alone.

#include <cstddef>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/execution/evaluation_broker.hpp"
#include "studies/findings/search_findings.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/results/rows.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {

/// The input columns of such a study's rows: variables, random keys, then the time step and the size of the cells,
/// which the checks change.
std::vector<ColumnInfo> search_columns(const Study& study);
/// The scenario of such inputs.
Scenario scenario_of_search_inputs(const Study& study, const std::vector<InputValue>& inputs);

/// Runs all searches and checks. Throws what the broker throws.
SearchFindings run_searches(const StrategyJudge& judge, EvaluationBroker& broker);

/// Scenarios such as the study will ask for: the strategy as written on the first products, at most `count` of
/// them.
ScenarioSet search_probes(const Study& study, std::size_t count);

/// Evaluations that the study may ask for, at most, checks included; for progress and `check`.
std::size_t evaluations_at_most(const Study& study);

}  // namespace unbruised::studies
