#include "optimizer/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include "optimizer/gradient.hpp"

namespace unbruised::optimizer {
namespace {

/// Told instead of an objective while none has been seen.
constexpr double kFirstPenalty = 1e6;
/// Of so many evaluations at least half must be finite.
constexpr std::size_t kRecent = 200;
/// Known points asked for in a row after which an algorithm goes round in circles. A healthy one asks for the same
/// point two or three times: objective, constraints, objective again.
constexpr std::size_t kKnownInARowMost = 1000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string bits_of(std::span<const double> point) {
  std::string bits(point.size_bytes(), '\0');
  std::memcpy(bits.data(), point.data(), bits.size());
  return bits;
}

bool is_finite(double value) { return std::isfinite(value); }

bool all_finite(const Evaluation& evaluation) {
  return is_finite(evaluation.objective) &&
         std::all_of(evaluation.constraints.begin(), evaluation.constraints.end(), is_finite);
}

/// The largest constraint; infinite where anything does not exist.
double violation_of(const Evaluation& evaluation) {
  if (!all_finite(evaluation)) return kInfinity;
  if (evaluation.constraints.empty()) return 0.0;
  return *std::max_element(evaluation.constraints.begin(), evaluation.constraints.end());
}

/// A constraint as it is told: what is exactly zero is met, with no room (an event, a count), and stays so.
double inside(double constraint, double margin) { return constraint == 0.0 ? 0.0 : constraint + margin; }

/// Sets the values of a neighbour that make no difference quotient to those of the centre: where either of the two
/// was not finite.
void flatten(const Evaluation& centre, const Evaluation& neighbour, const std::vector<double>& told_of_centre,
             std::vector<double>& told_of_neighbour) {
  const auto both_finite = [](double a, double b) { return is_finite(a) && is_finite(b); };
  if (!both_finite(centre.objective, neighbour.objective)) told_of_neighbour[0] = told_of_centre[0];
  for (std::size_t i = 0; i < centre.constraints.size(); ++i) {
    if (!both_finite(centre.constraints[i], neighbour.constraints[i])) {
      told_of_neighbour[i + 1] = told_of_centre[i + 1];
    }
  }
}

}  // namespace

Ledger::Ledger(const Problem& problem, const SearchOptions& options, Wanted wanted)
    : problem_(problem),
      options_(options),
      wanted_(wanted),
      differences_(options.central_differences ? Differences::central : Differences::forward),
      most_broken_(problem.constraint_count, 1.0) {
  const std::vector<double> flat(problem.space.size(), 0.0);
  last_words_ = {kFirstPenalty, most_broken_,
                 std::vector<std::vector<double>>(problem.constraint_count + 1, flat)};
}

const Answer& Ledger::at(std::span<const double> unit) {
  std::string key = bits_of(problem_.space.from_unit(unit));
  if (const auto found = memo_.find(key); found != memo_.end()) {
    if (++known_in_a_row_ > kKnownInARowMost) {
      end(Termination::stalled, "the algorithm goes round in circles over known points");
    }
    return found->second;
  }
  known_in_a_row_ = 0;
  if (has_ended_) return last_words_;
  try {
    std::optional<Answer> answer = learn(unit);
    return answer ? memo_.emplace(std::move(key), std::move(*answer)).first->second : last_words_;
  } catch (...) {
    has_ended_ = true;
    throw;
  }
}

/// Evaluates a point, with its neighbours where gradients are wanted; nothing: the search has to end.
std::optional<Answer> Ledger::learn(std::span<const double> unit) {
  if (!std::all_of(unit.begin(), unit.end(), is_finite)) {
    return end(Termination::stalled, "the algorithm asked for a point that is not a number");
  }
  const std::vector<std::vector<double>> points =
      wanted_ == Wanted::values_and_gradients ? difference_points(unit, options_.gradient_step, differences_)
                                              : std::vector<std::vector<double>>{{unit.begin(), unit.end()}};
  if (result_.evaluations + points.size() > options_.evaluations_most) {
    return end(Termination::budget_spent,
               "the budget of " + std::to_string(options_.evaluations_most) + " evaluations is spent");
  }
  const std::optional<std::vector<Evaluation>> evaluations = ask(points);
  if (!evaluations) return end(Termination::stopped, "the search was stopped from outside");
  for (std::size_t i = 0; i < points.size(); ++i) record(points[i], (*evaluations)[i]);
  if (mostly_failing()) {
    end(Termination::stalled,
        "more than half of the last " + std::to_string(kRecent) + " evaluations have no finite values");
  }
  return answer_from(points, *evaluations);
}

std::optional<std::vector<Evaluation>> Ledger::ask(const std::vector<std::vector<double>>& points) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    questions.push_back({problem_.space.from_unit(points[i]), result_.generations, i});
  }
  std::optional<std::vector<Evaluation>> evaluations = problem_.evaluate(questions);
  if (!evaluations) return std::nullopt;
  const bool fits = evaluations->size() == points.size() &&
                    std::all_of(evaluations->begin(), evaluations->end(), [this](const Evaluation& evaluation) {
                      return evaluation.constraints.size() == problem_.constraint_count;
                    });
  if (!fits) throw std::logic_error("an evaluator must answer every question, with all constraints");
  result_.evaluations += points.size();
  ++result_.generations;
  return evaluations;
}

Answer Ledger::answer_from(const std::vector<std::vector<double>>& points,
                           const std::vector<Evaluation>& evaluations) const {
  const std::vector<double> here = told(evaluations[0]);
  Answer answer{here[0], {here.begin() + 1, here.end()}, {}};
  if (wanted_ == Wanted::values) return answer;
  std::vector<std::vector<double>> values = {here};
  for (std::size_t i = 1; i < points.size(); ++i) {
    values.push_back(told(evaluations[i]));
    flatten(evaluations[0], evaluations[i], here, values.back());
  }
  answer.gradient = difference_quotients(points, values, differences_);
  return answer;
}

void Ledger::record(const std::vector<double>& unit, const Evaluation& evaluation) {
  recent_.push_back(all_finite(evaluation));
  if (recent_.size() > kRecent) recent_.pop_front();
  learn_range(evaluation);
  const double violation = violation_of(evaluation);
  const bool feasible = violation <= 0.0;
  const bool better = result_.best.empty() || (feasible && !result_.feasible) ||
                      (feasible && evaluation.objective < result_.at_best.objective) ||
                      (!feasible && !result_.feasible && violation < result_.violation);
  if (!better) return;
  best_unit_ = unit;
  result_.best = problem_.space.from_unit(unit);
  result_.at_best = evaluation;
  result_.feasible = feasible;
  result_.violation = violation;
}

void Ledger::learn_range(const Evaluation& evaluation) {
  if (is_finite(evaluation.objective)) {
    best_seen_ = std::min(best_seen_.value_or(evaluation.objective), evaluation.objective);
    worst_seen_ = std::max(worst_seen_.value_or(evaluation.objective), evaluation.objective);
  }
  for (std::size_t i = 0; i < most_broken_.size(); ++i) {
    if (is_finite(evaluation.constraints[i]))
      most_broken_[i] = std::max(most_broken_[i], evaluation.constraints[i]);
  }
}

/// The objective, then the constraints, all finite.
std::vector<double> Ledger::told(const Evaluation& evaluation) const {
  std::vector<double> values = {is_finite(evaluation.objective) ? evaluation.objective : objective_penalty()};
  for (std::size_t i = 0; i < most_broken_.size(); ++i) {
    const double c = evaluation.constraints[i];
    values.push_back(is_finite(c) ? inside(c, options_.constraint_margin) : most_broken_[i]);
  }
  return values;
}

double Ledger::objective_penalty() const {
  if (!worst_seen_) return kFirstPenalty;
  const double spread = *worst_seen_ - *best_seen_;
  const double more = spread > 0.0 ? spread : (*worst_seen_ != 0.0 ? std::abs(*worst_seen_) : 1.0);
  // Near the largest double there is no room for more.
  return std::min(*worst_seen_ + more, std::numeric_limits<double>::max());
}

bool Ledger::mostly_failing() const {
  const auto failed = static_cast<std::size_t>(std::count(recent_.begin(), recent_.end(), false));
  return recent_.size() == kRecent && 2 * failed > kRecent;
}

std::nullopt_t Ledger::end(Termination termination, std::string sentence) {
  if (!has_ended_) {
    has_ended_ = true;
    result_.termination = termination;
    result_.sentence = std::move(sentence);
  }
  return std::nullopt;
}

}  // namespace unbruised::optimizer
