#include "studies/goals/goal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "studies/goals/finite_violation.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double metric_violation(const Constraint& constraint, double value, Outcome worst_outcome) {
  if (std::isnan(value)) {
    const double rank = rank_of_early_end(worst_outcome);
    return rank > 0.0 ? rank : kWorstViolation;
  }
  const double scale = constraint.bound == 0.0 ? 1.0 : std::abs(constraint.bound);
  const double over = (constraint.at_least ? constraint.bound - value : value - constraint.bound) / scale;
  return finite_violation(over);
}

bool is_kept(const ScenarioResult& result) { return rank_of_early_end(result.outcome) < 0.0; }

/// A metric as goals see it: a cycle that ended without its product has no cycle time.
double goal_metric(const ScenarioResult& result, Metric metric) {
  if (metric == Metric::cycle_time_s && !is_kept(result)) return std::numeric_limits<double>::quiet_NaN();
  return result.metrics[metric];
}

/// The same for an objective, which exists only for products that count.
double objective_metric(const ScenarioResult& result, Metric metric, const OutcomeEvent& counts) {
  // What a product is kept with is decided by the outcome alone; whether it slipped and was damaged is not asked.
  const bool is_counted = counts.contains(static_cast<Ending>(result.outcome));
  return is_counted ? goal_metric(result, metric) : std::numeric_limits<double>::quiet_NaN();
}

/// On which side of the others a product counts that does not have the metric.
enum class Worst { lowest, highest };

/// @param values of the products, NaN where there is none
double statistic_value(const GoalTerm& term, std::vector<double> values, Worst worst) {
  double sum = 0.0;
  std::size_t missing = 0;
  for (double& value : values) {
    if (std::isnan(value)) {
      ++missing;
      value = worst == Worst::lowest ? -kInfinity : kInfinity;
    } else {
      sum += value;
    }
  }
  switch (term.statistic) {
    case Statistic::quantile:
      return sample_quantile(std::move(values), term.level);
    case Statistic::worst:
      return worst == Worst::lowest ? *std::min_element(values.begin(), values.end())
                                    : *std::max_element(values.begin(), values.end());
    default:
      if (2 * missing > values.size()) return std::numeric_limits<double>::quiet_NaN();
      return sum / static_cast<double>(values.size() - missing);
  }
}

}  // namespace

bool more_is_better(Metric metric) { return metric == Metric::friction_margin_min; }

double objective_value(const Objective& objective, const ScenarioResult& result, const OutcomeEvent& counts) {
  double sum = 0.0;
  for (const GoalTerm& term : objective.terms) {
    sum += term.weight * objective_metric(result, term.metric, counts);
  }
  return sum;
}

double objective_value(const Objective& objective, std::span<const ScenarioResult> results,
                       const OutcomeEvent& counts) {
  double sum = 0.0;
  for (const GoalTerm& term : objective.terms) {
    std::vector<double> values;
    for (const ScenarioResult& result : results) values.push_back(objective_metric(result, term.metric, counts));
    sum +=
        term.weight * statistic_value(term, std::move(values), term.weight < 0.0 ? Worst::lowest : Worst::highest);
  }
  return sum;
}

std::size_t products_without(const Objective& objective, std::span<const ScenarioResult> results,
                             const OutcomeEvent& counts) {
  return static_cast<std::size_t>(std::count_if(results.begin(), results.end(), [&](const ScenarioResult& result) {
    return std::isnan(objective_value(objective, result, counts));
  }));
}

std::vector<double> violations(const Constraint& constraint, const ScenarioResult& result,
                               const LimitParameters& limits) {
  if (constraint.kind == Constraint::Kind::metric) {
    return {metric_violation(constraint, goal_metric(result, constraint.term.metric), result.outcome)};
  }
  return event_violations(constraint.event, result, limits);
}

std::vector<std::string> violation_names(const Constraint& constraint, const LimitParameters& limits) {
  if (constraint.kind == Constraint::Kind::metric) return {constraint.text};
  return event_violation_names(constraint.event, constraint.text, limits);
}

double violation(const Constraint& constraint, const ScenarioResult& result, const LimitParameters& limits) {
  const std::vector<double> parts = violations(constraint, result, limits);
  return *std::max_element(parts.begin(), parts.end());
}

double violation(const Constraint& constraint, std::span<const ScenarioResult> results,
                 const LimitParameters& limits) {
  if (constraint.kind == Constraint::Kind::metric) {
    Outcome worst = Outcome::held;
    for (const ScenarioResult& result : results) {
      if (rank_of_early_end(result.outcome) > rank_of_early_end(worst)) worst = result.outcome;
    }
    std::vector<double> values;
    for (const ScenarioResult& result : results) values.push_back(goal_metric(result, constraint.term.metric));
    const double value =
        statistic_value(constraint.term, std::move(values), constraint.at_least ? Worst::lowest : Worst::highest);
    return metric_violation(constraint, value, worst);
  }
  std::vector<double> each;
  for (const ScenarioResult& result : results) {
    const std::vector<double> parts = event_violations(constraint.event, result, limits);
    each.push_back(*std::max_element(parts.begin(), parts.end()));
  }
  const double part = constraint.kind == Constraint::Kind::probability ? constraint.bound : 1.0;
  return finite_violation(sample_quantile(std::move(each), part));
}

}  // namespace unbruised::studies
