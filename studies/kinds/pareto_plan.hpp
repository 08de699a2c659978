#pragma once

/// @file
/// Which searches a study is made of: multistart for one objective, anchors and points for a Pareto front.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/problem.hpp"
#include "optimizer/search_space.hpp"
#include "studies/config/study.hpp"
#include "studies/findings/strategy_judge.hpp"

namespace unbruised::studies {

/// A search that is to be run.
struct PlannedSearch {
  std::string purpose;
  std::vector<double> start;  ///< of the variables, then of the slack where there is one
  std::size_t evaluations_most = 0;
  std::size_t constraint_count = 0;
  /// An extra variable t >= max_i w_i (f_i - ideal_i) / range_i that makes the Chebyshev norm smooth.
  std::optional<optimizer::Variable> slack;
  /// What the solver is told about a candidate.
  std::function<optimizer::Evaluation(const Candidate&, double slack)> worth;
};

/// The study's one objective from every start; the budget is shared evenly.
std::vector<PlannedSearch> plan_multistart(const Study& study, const StrategyJudge& judge,
                                           const std::vector<std::vector<double>>& starts);

/// How a pareto study spends its budget.
struct ParetoBudget {
  std::size_t anchor_starts = 1;     ///< of each anchor
  std::size_t starts = 1;            ///< of each end and each point
  std::size_t evaluations_each = 0;  ///< of one search
};
ParetoBudget pareto_budget(const Study& study);

/// Each objective alone: the ends of the front.
std::vector<PlannedSearch> plan_anchors(const Study& study, const StrategyJudge& judge,
                                        const std::vector<std::vector<double>>& starts);
/// The points between the ends, by epsilon-constraint or weighted Chebyshev norm, each from the nearest candidate
/// known and from further starts. @param known candidates of the anchors; none feasible: no searches
std::vector<PlannedSearch> plan_points(const Study& study, const StrategyJudge& judge,
                                       const std::vector<Candidate>& known,
                                       const std::vector<std::vector<double>>& starts);

}  // namespace unbruised::studies
