#include "studies/goals/goal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/outcome/damage_limits.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Stands for an infinite violation: solvers take no infinities, and nothing simulated comes near it.
constexpr double kWorstViolation = 1e6;
/// Of an event that did not happen although no component says why.
constexpr double kJustBroken = 1e-3;

/// How bad it is that a run ended early; -1 for one that ran to its end.
double rank_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::dropped:
      return 1.0;
    case Outcome::not_grasped:
      return 2.0;
    case Outcome::out_of_range:
      return 3.0;
    case Outcome::diverged:
    case Outcome::not_run:
      return 4.0;
    default:
      return -1.0;
  }
}

bool ended_early(Outcome outcome) { return rank_of(outcome) > 0.0; }

double finite(double violation) {
  if (std::isnan(violation)) return kWorstViolation;
  return std::clamp(violation, -kWorstViolation, kWorstViolation);
}

/// value / limit - 1, or the rank of an early end where it is worse.
double over_limit(double value, double limit, Outcome outcome) {
  const double rank = rank_of(outcome);
  if (std::isnan(value)) return ended_early(outcome) ? rank : -1.0;
  const double over = limit > 0.0 ? value / limit - 1.0 : (value > limit ? 1.0 : 0.0);
  return finite(over);
}

/// A component list of an event: which parts of `held` it asks for.
struct EventParts {
  bool undamaged = false;
  bool unslipped = false;
  bool completed = false;
};
EventParts parts_of(const OutcomeEvent& event) {
  EventParts parts;
  parts.undamaged = !event.contains(Outcome::damaged);
  parts.unslipped = !event.contains(Outcome::slipped);
  parts.completed = !event.contains(Outcome::dropped) || !event.contains(Outcome::not_grasped) ||
                    !event.contains(Outcome::out_of_range) || !event.contains(Outcome::diverged);
  return parts;
}

/// Events that are a part of what `held` asks for have smooth components; others are met or not.
bool is_smooth(const OutcomeEvent& event) { return event.contains(Outcome::held); }

std::vector<double> event_violations(const OutcomeEvent& event, const ScenarioResult& result,
                                     const LimitParameters& limits) {
  if (!is_smooth(event)) return {event.contains(result.outcome) ? -1.0 : 1.0};
  const EventParts parts = parts_of(event);
  std::vector<double> all;
  const Outcome outcome = result.outcome;
  if (parts.undamaged) {
    for (const DamageLimit& each : kDamageLimits) {
      if (const auto bound = bound_of(each, limits)) {
        all.push_back(over_limit(result.metrics[each.metric], *bound, outcome));
      }
    }
  }
  if (parts.unslipped) all.push_back(over_limit(result.metrics[Metric::slip_max_m], limits.slip_m, outcome));
  if (parts.completed) all.push_back(event.contains(outcome) ? -1.0 : rank_of(outcome));
  // The outcome has the last word: an outcome earlier in the list hides the later ones, whatever their metrics
  // say.
  const bool met = event.contains(outcome);
  if (all.empty()) return {met ? -1.0 : 1.0};
  if (met) {
    for (double& part : all) part = std::min(part, 0.0);
  } else if (*std::max_element(all.begin(), all.end()) <= 0.0) {
    all.back() = kJustBroken;
  }
  return all;
}

double metric_violation(const Constraint& constraint, double value, Outcome worst_outcome) {
  if (std::isnan(value)) return ended_early(worst_outcome) ? rank_of(worst_outcome) : kWorstViolation;
  const double scale = constraint.bound == 0.0 ? 1.0 : std::abs(constraint.bound);
  const double over = (constraint.at_least ? constraint.bound - value : value - constraint.bound) / scale;
  return finite(over);
}

/// @param low_is_bad a product without the metric counts as the lowest
double statistic_value(const GoalTerm& term, std::span<const ScenarioResult> results, bool low_is_bad) {
  std::vector<double> values;
  double sum = 0.0;
  std::size_t missing = 0;
  for (const ScenarioResult& result : results) {
    const double value = result.metrics[term.metric];
    if (std::isnan(value)) {
      ++missing;
      values.push_back(low_is_bad ? -kInfinity : kInfinity);
    } else {
      sum += value;
      values.push_back(value);
    }
  }
  switch (term.statistic) {
    case Statistic::quantile:
      return sample_quantile(std::move(values), term.level);
    case Statistic::worst:
      return low_is_bad ? *std::min_element(values.begin(), values.end())
                        : *std::max_element(values.begin(), values.end());
    default:
      if (2 * missing > values.size()) return std::numeric_limits<double>::quiet_NaN();
      return sum / static_cast<double>(values.size() - missing);
  }
}

}  // namespace

bool more_is_better(Metric metric) { return metric == Metric::friction_margin_min; }

OutcomeEvent held_event() { return {1U << static_cast<unsigned>(Outcome::held)}; }

std::string event_words(const OutcomeEvent& event) {
  std::string has;
  std::string has_not;
  for (std::size_t k = 0; k < kOutcomeWords.size(); ++k) {
    const bool in = ((event.outcomes >> k) & 1U) != 0;
    std::string& words = in ? has : has_not;
    if (!words.empty()) words += in ? " or " : " and ";
    words += (in ? "" : "not ") + std::string(kOutcomeWords[k]);
  }
  return has.size() <= has_not.size() ? has : has_not;
}

double objective_value(const Objective& objective, const ScenarioResult& result) {
  double sum = 0.0;
  for (const GoalTerm& term : objective.terms) sum += term.weight * result.metrics[term.metric];
  return sum;
}

double objective_value(const Objective& objective, std::span<const ScenarioResult> results) {
  double sum = 0.0;
  for (const GoalTerm& term : objective.terms) {
    sum += term.weight * statistic_value(term, results, term.weight < 0.0);
  }
  return sum;
}

std::vector<double> violations(const Constraint& constraint, const ScenarioResult& result,
                               const LimitParameters& limits) {
  if (constraint.kind == Constraint::Kind::metric) {
    return {metric_violation(constraint, result.metrics[constraint.term.metric], result.outcome)};
  }
  return event_violations(constraint.event, result, limits);
}

std::vector<std::string> violation_names(const Constraint& constraint, const LimitParameters& limits) {
  if (constraint.kind == Constraint::Kind::metric || !is_smooth(constraint.event)) return {constraint.text};
  const EventParts parts = parts_of(constraint.event);
  std::vector<std::string> names;
  if (parts.undamaged) {
    for (const DamageLimit& each : kDamageLimits) {
      if (bound_of(each, limits)) names.push_back(constraint.text + ": " + std::string(each.rule));
    }
  }
  if (parts.unslipped) names.push_back(constraint.text + ": slip_max_m <= limits.slip_m");
  if (parts.completed) names.push_back(constraint.text + ": the cycle is completed");
  return names.empty() ? std::vector<std::string>{constraint.text} : names;
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
      if (rank_of(result.outcome) > rank_of(worst)) worst = result.outcome;
    }
    return metric_violation(constraint, statistic_value(constraint.term, results, constraint.at_least), worst);
  }
  std::vector<double> each;
  for (const ScenarioResult& result : results) {
    const std::vector<double> parts = event_violations(constraint.event, result, limits);
    each.push_back(*std::max_element(parts.begin(), parts.end()));
  }
  const double part = constraint.kind == Constraint::Kind::probability ? constraint.bound : 1.0;
  return finite(sample_quantile(std::move(each), part));
}

double event_measure(const OutcomeEvent& event, const ScenarioResult& result, const LimitParameters& limits) {
  const std::vector<double> parts = event_violations(event, result, limits);
  return std::clamp(*std::max_element(parts.begin(), parts.end()), -1.0, 1.0);
}

bool event_happens(const OutcomeEvent& event, const ScenarioResult& result) {
  return event.contains(result.outcome);
}

double frequency(const OutcomeEvent& event, std::span<const ScenarioResult> results) {
  const auto count = std::count_if(results.begin(), results.end(),
                                   [&](const ScenarioResult& result) { return event_happens(event, result); });
  return static_cast<double>(count) / static_cast<double>(results.size());
}

}  // namespace unbruised::studies
