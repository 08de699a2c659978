#include "studies/kinds/study_answer.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "studies/findings/claims.hpp"
#include "studies/findings/key_columns.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// "for all youngs_modulus_Pa"; "" where nothing but the strategy was varied.
std::string over_sentence(const std::vector<ColumnInfo>& over) {
  return over.empty() ? std::string() : joined({"for all ", leaves_text(over), " of the study"});
}

void say(AnsweredStrategy& answer, std::string line) {
  if (!line.empty()) answer.says.push_back(std::move(line));
}

std::string with_text(const std::vector<ColumnInfo>& keys, const std::vector<InputValue>& values) {
  return keys.empty() ? std::string() : joined({"with ", inputs_text(keys, values)});
}

}  // namespace

std::optional<AnsweredStrategy> window_strategy(const Study& study, const StudyWindow& window,
                                                const WindowAnswer& answer) {
  const StrategyWindow* best = fastest_best(answer);
  if (best == nullptr) return std::nullopt;
  const double force_N = best->set_point.force_N;
  AnsweredStrategy strategy;
  strategy.scenario = window_scenario(study, window.points[best->rows.front()], force_N);
  strategy.keys = answer.keys;
  strategy.values = best->values;
  say(strategy, best->set_point.sentence);
  say(strategy, with_text(answer.keys, best->values));
  say(strategy, over_sentence(answer.over));
  strategy.keys.push_back({kGripForceKey, "N", "grip force to set"});
  strategy.values.emplace_back(force_N);
  say(strategy, damage_sentence(damage_claim(study)));
  return strategy;
}

std::optional<AnsweredStrategy> grid_strategy(const Study& study, const GridAnswer& answer) {
  if (!answer.best || !answer.following.empty())
    return std::nullopt;  // one strategy for each product is no strategy
  AnsweredStrategy strategy;
  strategy.scenario = study.scenario(*answer.best);
  strategy.keys = answer.keys;
  strategy.values = answer.best_values;
  say(strategy, with_text(answer.keys, answer.best_values));
  say(strategy, damage_sentence(damage_claim(study)));
  return strategy;
}

std::optional<AnsweredStrategy> search_strategy(const Study& study, const SearchFindings& found) {
  const Candidate* best = winner(study, found.candidates);
  if (best == nullptr) return std::nullopt;
  std::vector<std::string> keys;
  AnsweredStrategy strategy;
  for (std::size_t k = 0; k < study.variables().size(); ++k) {
    const SearchVariable& variable = study.variables()[k];
    keys.push_back(variable.key);
    strategy.keys.push_back({variable.key, variable.units, "searched key"});
    strategy.values.emplace_back(best->values[k]);
  }
  strategy.scenario = study.scenario_with(keys, best->values);
  say(strategy, has_several_objectives(study.kind()) ? "the knee of the front" : "the best feasible strategy");
  say(strategy, with_text(strategy.keys, strategy.values));
  say(strategy, damage_sentence(damage_claim(study)));
  return strategy;
}

std::optional<AnsweredStrategy> compare_strategy(const Study& study, const std::vector<ResultTable>& tables) {
  const ResultTable* comparison = find_table(tables, "comparison");
  const std::string winner = comparison == nullptr ? std::string() : text_attribute(*comparison, "winner");
  for (const StrategyCandidate& candidate : study.candidates()) {
    if (winner.empty() || candidate.name != winner) continue;
    return AnsweredStrategy{
        .scenario = candidate.scenario,
        .keys = {{kCandidateColumn, "", "strategy"}},
        .values = {winner},
        .says = {joined({"the candidate ", winner, ": ", text_attribute(*comparison, "verdict")})}};
  }
  return std::nullopt;
}

}  // namespace unbruised::studies
