#include "studies/findings/strategy_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimizer/pareto.hpp"
#include "studies/results/outcome_counts.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// "dropped", or of several runs "held 150, dropped 10".
std::string outcomes_text(std::span<const ScenarioResult> results) {
  if (results.size() == 1) return std::string(outcome_word(results.front().outcome));
  OutcomeCounts counts;
  for (const ScenarioResult& result : results) counts.add(result.outcome);
  return counts_text(counts);
}

}  // namespace

bool Candidate::feasible() const {
  // An objective that does not exist cannot be the answer, whatever the constraints say.
  const bool exists =
      std::none_of(objectives.begin(), objectives.end(), [](double f) { return !std::isfinite(f); });
  return exists && violation <= 0.0;
}

StrategyJudge::StrategyJudge(const Study& study)
    : study_(study),
      sampled_(is_sampled_search(study.kind())),
      limits_(study.scenario(0).limits),
      damage_limits_(active_damage_limits(study.scenario(0))) {
  const SearchSettings& search = study.search();
  objectives_ =
      has_several_objectives(study.kind()) ? search.objectives : std::vector<Objective>{search.objective};
  for (std::size_t i = 0; i < search.constraints.size(); ++i) {
    const Constraint& constraint = search.constraints[i];
    counts_.endings |= constraint.event.endings;
    if (sampled_) {
      component_names_.push_back(constraint.text);
      add_event(constraint, i);
    } else {
      for (std::string& name : violation_names(constraint, limits_)) component_names_.push_back(std::move(name));
    }
  }
  if (sampled_ && held_number() == events_.size()) events_.push_back({held_event(), "held", {}, {}});
}

void StrategyJudge::add_event(const Constraint& constraint, std::size_t number) {
  if (constraint.kind != Constraint::Kind::probability) return;
  events_.push_back({constraint.event, event_words(constraint.event), constraint.bound, number});
}

std::size_t StrategyJudge::held_number() const {
  const auto held = std::find_if(events_.begin(), events_.end(),
                                 [](const JudgedEvent& judged) { return judged.event == held_event(); });
  return static_cast<std::size_t>(held - events_.begin());
}

Candidate StrategyJudge::judge(std::vector<double> values, std::span<const ScenarioResult> results,
                               const SampleStructure& sample) const {
  Candidate candidate;
  candidate.values = std::move(values);
  for (const Objective& objective : objectives_) {
    candidate.objectives.push_back(sampled_ ? objective_value(objective, results, counts_)
                                            : objective_value(objective, results.front(), counts_));
    if (sampled_) candidate.without_objective = products_without(objective, results, counts_);
  }
  for (const Constraint& constraint : study_.search().constraints) {
    if (sampled_) {
      candidate.components.push_back(violation(constraint, results, limits_));
    } else {
      for (const double part : violations(constraint, results.front(), limits_))
        candidate.components.push_back(part);
    }
  }
  if (!candidate.components.empty()) {
    const auto largest = std::max_element(candidate.components.begin(), candidate.components.end());
    candidate.violation = *largest;
    candidate.binding = static_cast<std::size_t>(largest - candidate.components.begin());
  }
  candidate.outcomes = outcomes_text(results);
  candidate.damage_margin = damage_margin(results);
  if (sampled_) judge_events(candidate, results, sample);
  return candidate;
}

void StrategyJudge::judge_events(Candidate& candidate, std::span<const ScenarioResult> results,
                                 const SampleStructure& sample) const {
  for (const JudgedEvent& judged : events_) {
    std::vector<bool> happens;
    std::vector<double> measure;
    for (const ScenarioResult& result : results) {
      happens.push_back(event_happens(judged.event, result, limits_));
      measure.push_back(event_measure(judged.event, result, limits_));
    }
    candidate.probabilities.push_back(sampled_proportion(happens, sample, study_.sampling().confidence, measure));
  }
}

double StrategyJudge::damage_margin(std::span<const ScenarioResult> results) const {
  double margin = kAbsent;
  for (const DamageLimit* limit : damage_limits_) {
    for (const ScenarioResult& result : results) {
      margin = std::fmin(margin, 1.0 - result.metrics[limit->metric] / *bound_of(*limit, limits_));
    }
  }
  return margin;
}

void CandidateLog::add(Candidate candidate) {
  const std::lock_guard lock(mutex_);
  candidates_.push_back(std::move(candidate));
}

std::vector<Candidate> CandidateLog::sorted() const {
  const std::lock_guard lock(mutex_);
  std::vector<Candidate> all = candidates_;
  std::sort(all.begin(), all.end(),
            [](const Candidate& a, const Candidate& b) { return journal_id(a.place) < journal_id(b.place); });
  return all;
}

const Candidate* best_feasible(const std::vector<Candidate>& candidates, std::size_t objective) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates) {
    if (!candidate.feasible()) continue;
    if (best == nullptr || candidate.objectives[objective] < best->objectives[objective]) best = &candidate;
  }
  return best;
}

const Candidate* least_violated(const std::vector<Candidate>& candidates) {
  const Candidate* least = nullptr;
  for (const Candidate& candidate : candidates) {
    if (least == nullptr || candidate.violation < least->violation) least = &candidate;
  }
  return least;
}

std::vector<const Candidate*> front_of(const std::vector<Candidate>& candidates) {
  std::vector<const Candidate*> feasible;
  std::vector<optimizer::Objectives> points;
  for (const Candidate& candidate : candidates) {
    if (!candidate.feasible()) continue;
    feasible.push_back(&candidate);
    points.push_back(candidate.objectives);
  }
  std::vector<const Candidate*> front;
  for (const std::size_t i : optimizer::nondominated(points)) front.push_back(feasible[i]);
  std::sort(front.begin(), front.end(),
            [](const Candidate* a, const Candidate* b) { return a->objectives < b->objectives; });
  return front;
}

const Candidate* winner(const Study& study, const std::vector<Candidate>& candidates) {
  if (!has_several_objectives(study.kind())) return best_feasible(candidates, 0);
  const std::vector<const Candidate*> front = front_of(candidates);
  if (front.empty()) return nullptr;
  std::vector<optimizer::Objectives> points;
  for (const Candidate* candidate : front) points.push_back(candidate->objectives);
  return front[optimizer::knee(points)];
}

}  // namespace unbruised::studies
