#pragma once

/// @file
/// What a strategy is worth: its objectives, how far it is from breaking each constraint, and how sure that is.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/outcome/damage_limits.hpp"
#include "core/outcome/outcome.hpp"
#include "studies/config/study.hpp"
#include "studies/goals/goal.hpp"
#include "studies/results/rows.hpp"
#include "studies/statistics/intervals.hpp"
#include "studies/statistics/replicates.hpp"

namespace unbruised::studies {

/// A strategy that a search tried.
struct Candidate {
  SearchPlace place;                 ///< index: the point inside its generation
  std::uint64_t first_scenario = 0;  ///< journal id of its (first) scenario
  std::vector<double> values;        ///< of the study's variables
  std::vector<double> objectives;    ///< one, of a pareto study two or three; NaN where a metric does not exist
  std::vector<double> components;    ///< of all constraints; met when <= 0
  double violation = 0.0;            ///< the largest of them; 0 without constraints
  std::size_t binding = 0;           ///< which one that is
  /// 1 - metric / limit of the damage limit that is nearest to being exceeded in any of its scenarios; < 0:
  /// damaged; NaN: no limit can act.
  double damage_margin = kAbsent;
  std::vector<Proportion> probabilities;  ///< robust: of `StrategyJudge::events`; else none
  std::size_t without_objective = 0;      ///< robust: products for which a metric of an objective does not exist
  bool unresolved_impact = false;         ///< of any of its scenarios (findings/balances.hpp)
  std::string outcomes;                   ///< "dropped"; of products "held 150, dropped 10"

  [[nodiscard]] bool feasible() const;
};

/// An event whose probability a robust study reports.
struct JudgedEvent {
  OutcomeEvent event;
  std::string text;
  std::optional<double> wanted;           ///< P(event) >= wanted
  std::optional<std::size_t> constraint;  ///< number of that constraint
};

/// Judges by the objectives and constraints of one study; immutable.
class StrategyJudge {
 public:
  explicit StrategyJudge(const Study& study);

  /// @param results of the strategy's scenarios: one, or one per product of a robust study
  /// @param sample the structure of the products (ProductSample::structure); empty: one scenario
  [[nodiscard]] Candidate judge(std::vector<double> values, std::span<const ScenarioResult> results,
                                const SampleStructure& sample) const;
  /// The smallest 1 - metric / limit over these scenarios; NaN where no limit can act.
  [[nodiscard]] double damage_margin(std::span<const ScenarioResult> results) const;

  [[nodiscard]] const std::vector<Objective>& objectives() const { return objectives_; }
  /// What each component of the constraints speaks of, e.g. "held: permanent_set_max_m <= limits.permanent_set_m".
  [[nodiscard]] const std::vector<std::string>& component_names() const { return component_names_; }
  [[nodiscard]] const Study& study() const { return study_; }
  /// Of a robust study: those of its probability constraints, and `held` where it is not among them.
  [[nodiscard]] const std::vector<JudgedEvent>& events() const { return events_; }
  /// The number of `held` among the events.
  [[nodiscard]] std::size_t held_number() const;

 private:
  void add_event(const Constraint& constraint, std::size_t number);
  void judge_events(Candidate& candidate, std::span<const ScenarioResult> results,
                    const SampleStructure& sample) const;

  Study study_;
  bool sampled_;
  std::vector<Objective> objectives_;
  LimitParameters limits_;
  std::vector<const DamageLimit*> damage_limits_;  ///< those that can act
  std::vector<std::string> component_names_;
  std::vector<JudgedEvent> events_;
  OutcomeEvent counts_ = kept_event();  ///< products that have an objective
};

/// Candidates as they come, from any thread.
class CandidateLog {
 public:
  void add(Candidate candidate);
  /// By (search, generation, index), whatever the order of arrival.
  [[nodiscard]] std::vector<Candidate> sorted() const;

 private:
  mutable std::mutex mutex_;
  std::vector<Candidate> candidates_;
};

/// The feasible candidate with the least objective, the first where several have it; nullptr: none is feasible.
const Candidate* best_feasible(const std::vector<Candidate>& candidates, std::size_t objective);
/// The candidate with the least violation; nullptr without candidates.
const Candidate* least_violated(const std::vector<Candidate>& candidates);

/// The strategies that no other beats in every objective, by their objectives; feasible ones only.
std::vector<const Candidate*> front_of(const std::vector<Candidate>& candidates);
/// The strategy that is checked again: the best, of a pareto study the knee of the front; nullptr: none is
/// feasible.
const Candidate* winner(const Study& study, const std::vector<Candidate>& candidates);

}  // namespace unbruised::studies
