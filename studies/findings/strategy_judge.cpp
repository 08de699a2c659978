#include "studies/findings/strategy_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimizer/pareto.hpp"

namespace unbruised::studies {

bool Candidate::feasible() const {
  // An objective that does not exist cannot be the answer, whatever the constraints say.
  const bool exists =
      std::none_of(objectives.begin(), objectives.end(), [](double f) { return !std::isfinite(f); });
  return exists && violation <= 0.0;
}

StrategyJudge::StrategyJudge(const Study& study)
    : study_(study),
      sampled_(study.kind() == StudyKind::robust),
      limits_(study.scenario(0).limits),
      damage_limits_(active_damage_limits(study.scenario(0))) {
  const SearchSettings& search = study.search();
  objectives_ = study.kind() == StudyKind::pareto ? search.objectives : std::vector<Objective>{search.objective};
  bool has_event = false;
  for (const Constraint& constraint : search.constraints) {
    if (sampled_) {
      component_names_.push_back(constraint.text);
      if (constraint.kind == Constraint::Kind::probability && !std::exchange(has_event, true)) {
        event_ = constraint.event;
        event_text_ = event_words(constraint.event);
      }
    } else {
      for (std::string& name : violation_names(constraint, limits_)) component_names_.push_back(std::move(name));
    }
  }
  if (!has_event) event_ = held_event();
}

Candidate StrategyJudge::judge(std::vector<double> values, std::span<const ScenarioResult> results,
                               std::span<const std::size_t> group) const {
  Candidate candidate;
  candidate.values = std::move(values);
  for (const Objective& objective : objectives_) {
    candidate.objectives.push_back(sampled_ ? objective_value(objective, results)
                                            : objective_value(objective, results.front()));
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
  if (sampled_) {
    std::vector<bool> happens;
    std::vector<double> measure;
    for (const ScenarioResult& result : results) {
      happens.push_back(event_happens(event_, result));
      measure.push_back(event_measure(event_, result, limits_));
    }
    candidate.probability = proportion(happens, group, study_.sampling().confidence, measure);
  }
  candidate.damage_margin = damage_margin(results);
  return candidate;
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
  if (study.kind() != StudyKind::pareto) return best_feasible(candidates, 0);
  const std::vector<const Candidate*> front = front_of(candidates);
  if (front.empty()) return nullptr;
  std::vector<optimizer::Objectives> points;
  for (const Candidate* candidate : front) points.push_back(candidate->objectives);
  return front[optimizer::knee(points)];
}

}  // namespace unbruised::studies
