#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "optimizer/pareto.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/front_check.hpp"
#include "studies/findings/shown_probability.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// A constraint whose slack is smaller than this part of its bound counts as active.
constexpr double kActiveSlack = 0.02;
/// A variable this near to the end of its range lies at its bound.
constexpr double kAtBound = 1e-3;
/// The reference point of the hypervolume lies this part of the front's extent beyond its worst values.
constexpr double kReferenceMargin = 0.1;

class SearchTables {
 public:
  SearchTables(const StrategyJudge& judge, const SearchFindings& found, const StudyRows& rows)
      : judge_(judge), study_(judge.study()), found_(found) {
    for (const ScenarioRow& row : rows) row_of_.emplace(journal_id(row), row.id);
  }

  std::vector<ResultTable> all() {
    std::vector<ResultTable> tables;
    if (!found_.searches.empty()) tables.push_back(searches());
    if (!found_.candidates.empty()) {
      tables.push_back(evaluations());
      if (has_several_objectives(study_.kind())) tables.push_back(pareto());
      const Candidate* best = best_feasible(found_.candidates, 0);
      const Candidate& shown = best != nullptr ? *best : *least_violated(found_.candidates);
      if (!has_several_objectives(study_.kind()) || best == nullptr) tables.push_back(this->best(shown));
      if (!shown.components.empty() && !has_several_objectives(study_.kind()))
        tables.push_back(constraints(shown));
    }
    if (!found_.checks.empty()) tables.push_back(verification());
    if (found_.products) {
      for (ResultTable& table : random_tables(study_, *found_.products)) tables.push_back(std::move(table));
    }
    return tables;
  }

 private:
  [[nodiscard]] double row_of(std::uint64_t id) const {
    const auto found = row_of_.find(id);
    return found == row_of_.end() ? kAbsent : static_cast<double>(found->second);
  }

  /// One column per variable.
  void add_variables(ResultTable& table, const std::vector<const Candidate*>& candidates) const {
    for (std::size_t k = 0; k < study_.variables().size(); ++k) {
      std::vector<double> values;
      for (const Candidate* candidate : candidates) values.push_back(candidate->values[k]);
      const SearchVariable& variable = study_.variables()[k];
      table.columns.push_back({variable.key, variable.units, "searched key", std::move(values)});
    }
  }

  /// `objective`, or `objective_1`, `objective_2`, ...
  void add_objectives(ResultTable& table, const std::vector<const Candidate*>& candidates) const {
    for (std::size_t k = 0; k < judge_.objectives().size(); ++k) {
      std::vector<double> values;
      for (const Candidate* candidate : candidates) values.push_back(candidate->objectives[k]);
      const std::string name =
          judge_.objectives().size() == 1 ? "objective" : joined({"objective_", std::to_string(k + 1)});
      table.columns.push_back({name, "", judge_.objectives()[k].text, std::move(values)});
    }
  }

  template <class Field>
  static ResultColumn column(const std::string& name, const std::string& units, const std::string& long_name,
                             const std::vector<const Candidate*>& candidates, Field field) {
    std::vector<double> values;
    for (const Candidate* candidate : candidates) values.push_back(static_cast<double>(field(*candidate)));
    return {name, units, long_name, std::move(values)};
  }

  void add_verdicts(ResultTable& table, const std::vector<const Candidate*>& candidates) const {
    table.columns.push_back(column("violation", "1", "largest violation of a constraint, <= 0: feasible",
                                   candidates, [](const Candidate& c) { return c.violation; }));
    table.columns.push_back(column("feasible", "1", "1: every constraint is met", candidates,
                                   [](const Candidate& c) { return c.feasible(); }));
    std::vector<std::string> binding;
    for (const Candidate* c : candidates) {
      binding.push_back(c->components.empty() ? "" : judge_.component_names()[c->binding]);
    }
    table.columns.push_back(
        {"binding", "", "the constraint that is nearest to being broken, or most broken", binding});
    table.columns.push_back(column("scenario", "1", "row of its (first) scenario", candidates,
                                   [this](const Candidate& c) { return row_of(c.first_scenario); }));
    if (is_sampled_search(study_.kind())) add_probabilities(table, candidates);
  }

  /// Of the first event, and beside it of `held` where that is another one.
  void add_probabilities(ResultTable& table, const std::vector<const Candidate*>& candidates) const {
    const auto add = [&](const std::string& name, std::size_t number) {
      table.columns.push_back(column(name, "1", joined({"estimated P(", judge_.events()[number].text, ")"}),
                                     candidates,
                                     [&](const Candidate& c) { return c.probabilities[number].estimate; }));
      table.columns.push_back(column(joined({name, "_low"}), "1", "lower end of its interval", candidates,
                                     [&](const Candidate& c) { return c.probabilities[number].interval.low; }));
      table.columns.push_back(column(joined({name, "_high"}), "1", "upper end of its interval", candidates,
                                     [&](const Candidate& c) { return c.probabilities[number].interval.high; }));
    };
    add("probability", 0);
    if (judge_.held_number() != 0) add("probability_held", judge_.held_number());
    table.columns.push_back(column("without_objective", "1", "products for which the objective does not exist",
                                   candidates, [](const Candidate& c) { return c.without_objective; }));
  }

  static ResultColumn outcomes(const std::vector<const Candidate*>& candidates) {
    std::vector<std::string> texts;
    for (const Candidate* candidate : candidates) texts.push_back(candidate->outcomes);
    return {"outcomes", "", "how its runs ended", std::move(texts)};
  }

  ResultTable searches() const {
    std::vector<std::string> purposes;
    std::vector<std::string> starts;
    std::vector<std::string> terminations;
    std::vector<double> evaluations;
    std::vector<double> objectives;
    std::vector<double> violations;
    for (const SearchRecord& search : found_.searches) {
      purposes.push_back(search.purpose);
      starts.push_back(values_text(study_.variables(), search.start));
      terminations.push_back(search.result.sentence);
      evaluations.push_back(static_cast<double>(search.result.evaluations));
      objectives.push_back(search.result.feasible ? search.result.at_best.objective : kAbsent);
      violations.push_back(search.result.violation);
    }
    return {.name = "searches",
            .row = "search_number",
            .columns = {{"purpose", "", "what it looked for", std::move(purposes)},
                        {"start", "", "where it started", std::move(starts)},
                        {"evaluations", "1", "strategies evaluated", std::move(evaluations)},
                        {"best_objective", "", "of its best feasible strategy", std::move(objectives)},
                        {"best_violation", "1", "of its best strategy", std::move(violations)},
                        {"termination", "", "why it ended", std::move(terminations)}},
            .attributes = {}};
  }

  ResultTable evaluations() const {
    std::vector<const Candidate*> all;
    for (const Candidate& candidate : found_.candidates) all.push_back(&candidate);
    ResultTable table{.name = "evaluations", .row = "evaluation", .columns = {}, .attributes = {}};
    table.columns.push_back(
        column("search", "1", "number of the search", all, [](const Candidate& c) { return c.place.search; }));
    table.columns.push_back(column("generation", "1", "number of the question inside its search", all,
                                   [](const Candidate& c) { return c.place.generation; }));
    table.columns.push_back(
        column("index", "1", "number inside the question", all, [](const Candidate& c) { return c.place.index; }));
    add_variables(table, all);
    add_objectives(table, all);
    add_verdicts(table, all);
    return table;
  }

  ResultTable best(const Candidate& shown) const {
    const std::vector<const Candidate*> one = {&shown};
    ResultTable table{.name = "best", .row = "best_number", .columns = {}, .attributes = {}};
    add_variables(table, one);
    add_objectives(table, one);
    add_verdicts(table, one);
    table.columns.push_back(
        column("search", "1", "number of the search", one, [](const Candidate& c) { return c.place.search; }));
    table.columns.push_back(outcomes(one));
    table.attributes.emplace_back("objective", judge_.objectives().front().text);
    table.attributes.emplace_back("at_bounds", at_bounds(shown));
    table.attributes.emplace_back("reason", shown.feasible() ? std::string() : why_infeasible(shown));
    if (is_sampled_search(study_.kind())) {
      table.attributes.emplace_back("event", judge_.events().front().text);
      table.attributes.emplace_back("confidence", study_.sampling().confidence);
      table.attributes.emplace_back("products", static_cast<double>(found_.products->size()));
    }
    return table;
  }

  /// The variables that want to leave the box, e.g. "lift_acceleration_m_s2 (upper)".
  [[nodiscard]] std::string at_bounds(const Candidate& shown) const {
    std::vector<std::string> bounds;
    for (std::size_t k = 0; k < shown.values.size(); ++k) {
      const SearchVariable& v = study_.variables()[k];
      const double room = kAtBound * (v.to - v.from);
      const bool lower = shown.values[k] - v.from < room;
      const bool upper = v.to - shown.values[k] < room;
      if (lower || upper) bounds.push_back(joined({key_leaf(v.key), lower ? " (lower)" : " (upper)"}));
    }
    return comma_list(bounds);
  }

  /// Of the least violated strategy: what is in the way, where it is no constraint.
  [[nodiscard]] std::string why_infeasible(const Candidate& shown) const {
    if (shown.violation > 0.0) return {};
    std::vector<std::string> missing;
    for (std::size_t k = 0; k < shown.objectives.size(); ++k) {
      if (!std::isfinite(shown.objectives[k])) missing.push_back(judge_.objectives()[k].text);
    }
    const auto keeps_all = [](const Candidate& c) { return c.violation <= 0.0; };
    const auto keeping = std::count_if(found_.candidates.begin(), found_.candidates.end(), keeps_all);
    const bool all = static_cast<std::size_t>(keeping) == found_.candidates.size();
    return joined({separated(missing, " and "), " exists for none of the ",
                   with_thousands(static_cast<unsigned long long>(keeping)), " strategies tried",
                   all ? "" : " that keep every constraint"});
  }

  /// What the sample shows of each probability constraint; NaN and "" of the others.
  void add_shown(ResultTable& table, const Candidate& best) const {
    const std::size_t count = study_.search().constraints.size();
    std::vector<double> wanted(count, kAbsent), estimate(count, kAbsent), low(count, kAbsent),
        high(count, kAbsent), is_shown(count, kAbsent);
    std::vector<std::string> says(count);
    for (std::size_t k = 0; k < judge_.events().size(); ++k) {
      const JudgedEvent& judged = judge_.events()[k];
      if (!judged.constraint) continue;
      const Proportion& found = best.probabilities[k];
      const std::size_t i = *judged.constraint;
      wanted[i] = *judged.wanted;
      estimate[i] = found.estimate;
      low[i] = found.interval.low;
      high[i] = found.interval.high;
      is_shown[i] = shown(wanted[i], found) == Shown::shown ? 1.0 : 0.0;
      says[i] = shown_text(wanted[i], found, study_);
    }
    table.columns.push_back({"wanted", "1", "least probability asked for", std::move(wanted)});
    table.columns.push_back({"estimate", "1", "part of the products for which it holds", std::move(estimate)});
    table.columns.push_back({"low", "1", "lower end of its interval", std::move(low)});
    table.columns.push_back({"high", "1", "upper end of its interval", std::move(high)});
    table.columns.push_back({"shown", "1", "1: the whole interval lies at or above what is asked for", is_shown});
    table.columns.push_back({"says", "", "is it shown, and what would show it", std::move(says)});
  }

  ResultTable constraints(const Candidate& best) const {
    std::vector<double> slack;
    std::vector<double> active;
    for (const double part : best.components) {
      slack.push_back(-part);
      active.push_back(part > -kActiveSlack ? 1.0 : 0.0);
    }
    ResultTable table{
        .name = "constraints",
        .row = "constraint",
        .columns = {{"text", "", "what has to hold", judge_.component_names()},
                    {"slack", "1", "distance to the bound at the best strategy, in parts of the bound", slack},
                    {"active", "1", "1: closer than 2 % of the bound", active}},
        .attributes = {}};
    if (is_sampled_search(study_.kind())) add_shown(table, best);
    return table;
  }

  ResultTable verification() const {
    std::vector<const Candidate*> all;
    std::vector<std::string> names;
    std::vector<std::string> changes;
    std::vector<double> differences;
    const double as_found = found_.checks.front().candidate.objectives.front();
    for (const Check& check : found_.checks) {
      all.push_back(&check.candidate);
      names.push_back(check.name);
      changes.push_back(check.what);
      const double now = check.candidate.objectives.front();
      differences.push_back(as_found == 0.0 ? kAbsent : now / as_found - 1.0);
    }
    ResultTable table{.name = "verification", .row = "check_number", .columns = {}, .attributes = {}};
    table.columns.push_back({"check", "", "what was looked at again", std::move(names)});
    table.columns.push_back({"change", "", "what differs", std::move(changes)});
    add_objectives(table, all);
    table.columns.push_back(
        {"objective_change", "1", "relative to as found; NaN where that is zero", std::move(differences)});
    add_verdicts(table, all);
    table.columns.push_back(column("damage_margin", "1",
                                   "1 - metric / limit of the nearest damage limit, < 0: damaged", all,
                                   [](const Candidate& c) { return c.damage_margin; }));
    table.columns.push_back(outcomes(all));
    return table;
  }

  ResultTable pareto() const {
    const std::vector<const Candidate*> front = front_of(found_.candidates);
    std::vector<optimizer::Objectives> front_points;
    for (const Candidate* candidate : front) front_points.push_back(candidate->objectives);
    ResultTable table{.name = "pareto", .row = "point", .columns = {}, .attributes = {}};
    add_variables(table, front);
    add_objectives(table, front);
    std::vector<double> is_knee(front.size(), 0.0);
    if (!front.empty()) is_knee[optimizer::knee(front_points)] = 1.0;
    table.columns.push_back(
        {"knee", "1", "1: the best bargain: farthest from the line through the ends", is_knee});
    add_verdicts(table, front);
    add_half_step_columns(front, found_.front_again, table);
    table.columns.push_back(
        column("search", "1", "number of the search", front, [](const Candidate& c) { return c.place.search; }));
    if (!front.empty()) add_hypervolume(table, front_points);
    return table;
  }

  static void add_hypervolume(ResultTable& table, const std::vector<optimizer::Objectives>& front) {
    optimizer::Objectives reference;
    for (std::size_t k = 0; k < front.front().size(); ++k) {
      double low = front.front()[k];
      double high = low;
      for (const optimizer::Objectives& point : front) {
        low = std::min(low, point[k]);
        high = std::max(high, point[k]);
      }
      reference.push_back(high + kReferenceMargin * (high - low));
      table.attributes.emplace_back(joined({"reference_", std::to_string(k + 1)}), reference.back());
    }
    table.attributes.emplace_back("hypervolume", optimizer::hypervolume(front, reference));
  }

  const StrategyJudge& judge_;
  const Study& study_;
  const SearchFindings& found_;
  std::unordered_map<std::uint64_t, std::uint64_t> row_of_;
};

}  // namespace

std::vector<ResultTable> search_tables(const StrategyJudge& judge, const SearchFindings& found,
                                       const StudyRows& rows) {
  return SearchTables(judge, found, rows).all();
}

}  // namespace unbruised::studies
