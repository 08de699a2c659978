#pragma once

/// @file
/// What a study wants: objectives and constraints as they are written in a config, e.g. "cycle_time_s + 0.5 *
/// peak_finger_force_N", "friction_margin_min >= 0.2", "P(held) >= 0.99".

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/goals/event.hpp"
#include "studies/text/value_or.hpp"

namespace unbruised::studies {

/// What is done with a metric over the products of a robust study; none: one scenario.
enum class Statistic { none, mean, quantile, worst };

/// weight x statistic(metric)
struct GoalTerm {
  double weight = 1.0;
  Statistic statistic = Statistic::none;
  double level = 0.0;  ///< of a quantile, 0 < level < 1
  Metric metric = Metric::cycle_time_s;
};

/// The sum of its terms is to be least.
struct Objective {
  std::vector<GoalTerm> terms;
  std::string text;
};

/// Something that has to hold.
struct Constraint {
  enum class Kind {
    outcome,      ///< the event happens
    metric,       ///< term >= or <= bound
    probability,  ///< P(event) >= bound
  };
  Kind kind = Kind::outcome;
  OutcomeEvent event;
  GoalTerm term;
  bool at_least = false;  ///< >= ; else <=
  double bound = 0.0;
  std::string text;
};

/// Single: one scenario per strategy. Sampled: many products per strategy, so metrics need a statistic.
enum class GoalContext { single, sampled };

/// The goal, or why it is none, for whoever wrote it.
template <class Goal>
using Parsed = ValueOr<Goal, std::string>;

Parsed<Objective> parse_objective(std::string_view text, GoalContext context);
Parsed<Constraint> parse_constraint(std::string_view text, GoalContext context);
/// Is a larger value the better one? Of the friction margin; of all others less is better.
bool more_is_better(Metric metric);

/// A metric by its name; else "unknown metric 'x'; did you mean 'y'?".
Parsed<Metric> parse_metric(std::string_view name);

/// The objective of one scenario; NaN when one of its metrics does not exist. A product that does not count has
/// none, and without its product a cycle has no cycle time, whatever counts.
/// @param counts kept to the end, and what constraints name beside
double objective_value(const Objective& objective, const ScenarioResult& result,
                       const OutcomeEvent& counts = kept_event());
/// The objective over products. A mean is taken over the products that have the metric (`products_without` says
/// how many have not), NaN when they are fewer than half; in quantile and worst a product without the metric
/// counts as the worst of all.
double objective_value(const Objective& objective, std::span<const ScenarioResult> results,
                       const OutcomeEvent& counts = kept_event());
/// Products for which a metric of the objective does not exist.
std::size_t products_without(const Objective& objective, std::span<const ScenarioResult> results,
                             const OutcomeEvent& counts = kept_event());

/// How far a constraint is from being broken, without dimension: <= 0 exactly when it is met, always finite.
/// Metrics: (value - bound) / |bound|, or value - bound where the bound is zero, signed so that more is worse.
/// Events have one component per limit (event.hpp), so that a solver sees each of them vary smoothly.
std::vector<double> violations(const Constraint& constraint, const ScenarioResult& result,
                               const LimitParameters& limits);
/// As long as `violations`: what each component speaks of.
std::vector<std::string> violation_names(const Constraint& constraint, const LimitParameters& limits);
/// The largest component.
double violation(const Constraint& constraint, const ScenarioResult& result, const LimitParameters& limits);

/// The violation over products. P(event) >= p: the p-quantile over products of the event's violation, which is <=
/// 0 exactly when at least the part p of the products meets the event, and continuous in the strategy where the
/// frequency is a staircase.
double violation(const Constraint& constraint, std::span<const ScenarioResult> results,
                 const LimitParameters& limits);

}  // namespace unbruised::studies
