#pragma once

/// @file
/// The study kinds that search: optimize, robust and pareto. Searches run at once and ask one broker; what they find is
/// a function of the study alone.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/search.hpp"
#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"
#include "studies/runner/evaluation_broker.hpp"
#include "studies/runner/product_sample.hpp"
#include "studies/runner/scenario_set.hpp"
#include "studies/runner/strategy_judge.hpp"

namespace unbruised::studies {

/// One search as it is planned and as it ended.
struct SearchRecord {
  std::string purpose;  ///< "" of plain multistart, else "anchor of ...", "point 3"
  std::vector<double> start;
  optimizer::SearchResult result;
};

/// A second look at the best strategy.
struct Check {
  std::string name;  ///< "as found", "half the time step", "finer mesh", "other products"
  std::string what;  ///< "simulation.time_step_s = 0.0005"; empty: nothing differs
  Candidate candidate;
  std::string outcome;  ///< of one scenario: its word; of a sample: how many are held
};

struct SearchFindings {
  std::vector<Candidate> candidates;   ///< by place
  std::vector<SearchRecord> searches;  ///< by number; those that never began are missing
  std::vector<Check> checks;           ///< none where nothing is feasible
  std::optional<ProductSample> products;
  bool interrupted = false;
  LaneUse searching;  ///< how full the lanes were while the searches ran, checks not counted
  double search_seconds = 0.0;  ///< until the answer was there, before it was checked
};

/// The input columns of such a study's rows: variables, random keys, then the time step and the size of the cells,
/// which the checks change.
std::vector<ColumnInfo> search_columns(const Study& study);
/// The scenario of such inputs.
Scenario scenario_of_search_inputs(const Study& study, const std::vector<InputValue>& inputs);

/// Runs all searches and checks. Throws what the broker throws.
SearchFindings run_searches(const StrategyJudge& judge, EvaluationBroker& broker);

/// Scenarios such as the study will ask for: the strategy as written on the first products, at most `count` of them.
ScenarioSet search_probes(const Study& study, std::size_t count);

/// Evaluations that the study may ask for, at most, checks included; for progress and `check`.
std::size_t evaluations_at_most(const Study& study);

}  // namespace unbruised::studies
