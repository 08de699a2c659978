#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "studies/findings/found_parts.hpp"
#include "studies/findings/front_check.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Searches whose best lies within this part of the best of all count as having found it.
constexpr double kSameOptimum = 0.01;

std::string best_sentence(const ResultTable& best) {
  if (number_in(best, "feasible", 0) == 1.0) {
    const std::string outcome = text_in(best, "outcomes", 0);
    const bool is_one = number_attribute(best, "products") == std::nullopt;
    return joined({"best: ", text_attribute(best, "objective"), " = ",
                   short_number(number_in(best, "objective", 0)), at_keys(best, 0), scenario_text(best, 0),
                   is_one && outcome != "held" ? joined({", ", outcome}) : std::string()});
  }
  const std::string outcomes = joined({" (", text_in(best, "outcomes", 0), ")"});
  if (const std::string reason = text_attribute(best, "reason"); !reason.empty()) {
    return joined({"none feasible: ", reason, "; e.g.", at_keys(best, 0), scenario_text(best, 0), outcomes});
  }
  return joined({"none feasible: of all strategies tried the least violated breaks a constraint by ",
                 percent(number_in(best, "violation", 0)), at_keys(best, 0), scenario_text(best, 0), outcomes,
                 "; binding: ", text_in(best, "binding", 0)});
}

std::string probability_text(const ResultTable& best, const std::string& name, const std::string& event) {
  return joined({"P(", event, ") = ",
                 interval_text(number_in(best, name, 0), number_in(best, joined({name, "_low"}), 0),
                               number_in(best, joined({name, "_high"}), 0),
                               number_attribute(best, "confidence").value_or(0.95)),
                 " on ",
                 with_thousands(static_cast<unsigned long long>(number_attribute(best, "products").value_or(0.0))),
                 " products"});
}

/// Below this part of products held the answer says so by itself.
constexpr double kFewHeld = 0.5;

/// What is known of the products: how often the event happens, how often they are held, what the objective is
/// over.
void add_probability(const ResultTable& best, std::vector<std::string>& lines) {
  if (std::isnan(number_in(best, "probability", 0))) return;
  lines.push_back(probability_text(best, "probability", text_attribute(best, "event")));
  double held = number_in(best, "probability", 0);
  if (const double other = number_in(best, "probability_held", 0); !std::isnan(other)) {
    held = other;
    lines.push_back(probability_text(best, "probability_held", "held"));
  }
  if (number_in(best, "feasible", 0) == 1.0 && held < kFewHeld) {
    lines.push_back(
        joined({"careful: with this strategy most products are not held (", text_in(best, "outcomes", 0), ")"}));
  }
  const double without = number_in(best, "without_objective", 0);
  if (without > 0.0) {
    lines.push_back(
        joined({"the objective is of the products that have it: it does not exist for ", short_number(without),
                " of ", short_number(number_attribute(best, "products").value_or(0.0)), " (",
                text_in(best, "outcomes", 0), ")"}));
  }
}

/// Is what the constraints ask for met by the estimate only, or shown?
void add_shown(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* constraints = find_table(tables, "constraints");
  if (constraints == nullptr) return;
  for (std::size_t i = 0; i < row_count(*constraints); ++i) {
    const std::string says = text_in(*constraints, "says", i);
    if (!says.empty()) lines.push_back(joined({text_in(*constraints, "text", i), ": ", says}));
  }
}

void add_active(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* constraints = find_table(tables, "constraints");
  if (constraints == nullptr) return;
  std::vector<std::string> active;
  for (std::size_t i = 0; i < row_count(*constraints); ++i) {
    if (number_in(*constraints, "active", i) == 1.0) active.push_back(text_in(*constraints, "text", i));
  }
  lines.push_back(joined({"active constraints: ", active.empty() ? "none" : separated(active, "; ")}));
}

void add_bounds(const ResultTable& best, std::vector<std::string>& lines) {
  const std::string bounds = text_attribute(best, "at_bounds");
  if (!bounds.empty())
    lines.push_back(joined({"at the end of its range: ", bounds, "; a wider range may do better"}));
}

/// "+2 %", "0 as before", "0.3 (0 as found)", or that it does not exist.
std::string change_text(const ResultTable& checks, std::size_t i) {
  const bool one =
      !std::isnan(number_in(checks, "objective", 0)) || !std::isnan(number_in(checks, "objective", i));
  const char* column = one ? "objective" : "objective_1";
  const double found = number_in(checks, column, 0);
  const double now = number_in(checks, column, i);
  if (std::isnan(now)) return "does not exist";
  if (found == 0.0) return now == 0.0 ? "0 as before" : joined({short_number(now), " (0 as found)"});
  return signed_percent(number_in(checks, "objective_change", i));
}

std::string check_text(const ResultTable& checks, std::size_t i) {
  if (const std::string says = text_in(checks, "says", i); !says.empty()) {
    return joined({text_in(checks, "check", i), ": ", says});
  }
  std::string text = joined({text_in(checks, "check", i), ": objective ", change_text(checks, i)});
  const double probability = number_in(checks, "probability", i);
  if (!std::isnan(probability)) {
    text +=
        joined({", P = ", short_number(probability), " (", short_number(number_in(checks, "probability_low", i)),
                " to ", short_number(number_in(checks, "probability_high", i)), ")"});
  }
  const double margin = number_in(checks, "damage_margin", i);
  if (!std::isnan(margin)) {
    text += joined({", margin to damage ", percent(margin), " (as found ",
                    percent(number_in(checks, "damage_margin", 0)), ")"});
  }
  const double violation = number_in(checks, "violation", i);
  if (!(violation > 0.0)) return text + ", every constraint kept";
  return text + joined({", BREAKS ", text_in(checks, "binding", i), " by ", percent(violation), " (",
                        text_in(checks, "outcomes", i), ")"});
}

void add_checks(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* checks = find_table(tables, "verification");
  if (checks == nullptr) return;
  // Row 0 is the strategy as found: what the others are compared with.
  for (std::size_t i = 1; i < row_count(*checks); ++i)
    lines.push_back(joined({"checked, ", check_text(*checks, i)}));
  const ResultTable* pareto = find_table(tables, "pareto");
  if (pareto == nullptr) return;
  if (auto line = front_check_line(*pareto)) lines.push_back(std::move(*line));
}

void add_terminations(const ResultTable& searches, std::vector<std::string>& lines) {
  std::vector<std::pair<std::string, std::size_t>> reasons;
  for (std::size_t i = 0; i < row_count(searches); ++i) {
    const std::string reason = text_in(searches, "termination", i);
    const auto known =
        std::find_if(reasons.begin(), reasons.end(), [&](const auto& r) { return r.first == reason; });
    if (known != reasons.end()) {
      ++known->second;
    } else {
      reasons.emplace_back(reason, 1);
    }
  }
  for (const auto& [reason, count] : reasons)
    lines.push_back(joined({"  ", std::to_string(count), " ended: ", reason}));
}

void add_searches(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* searches = find_table(tables, "searches");
  if (searches == nullptr) return;
  const std::size_t count = row_count(*searches);
  double evaluations = 0.0;
  double least = INFINITY;
  for (std::size_t i = 0; i < count; ++i) {
    evaluations += number_in(*searches, "evaluations", i);
    least = std::fmin(least, number_in(*searches, "best_objective", i));
  }
  std::size_t agreeing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double objective = number_in(*searches, "best_objective", i);
    agreeing += objective - least <= kSameOptimum * std::abs(least) ? 1U : 0U;
  }
  std::string line =
      joined({"searches: ", std::to_string(count), ", ",
              with_thousands(static_cast<unsigned long long>(evaluations)), " strategies evaluated"});
  const bool one_problem = find_table(tables, "pareto") == nullptr;
  if (one_problem && std::isfinite(least) && count > 1) {
    line += joined({"; ", std::to_string(agreeing), " of ", std::to_string(count), " end within 1 % of the best"});
  }
  lines.push_back(std::move(line));
  add_terminations(*searches, lines);
}

void add_best(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* best = find_table(tables, "best");
  // Of other kinds than optimize and robust it only repeats their answer.
  if (best == nullptr || row_count(*best) == 0 || text_attribute(*best, "objective").empty()) return;
  lines.push_back(best_sentence(*best));
  add_probability(*best, lines);
  if (number_in(*best, "feasible", 0) != 1.0) return;
  add_shown(tables, lines);
  add_active(tables, lines);
  add_bounds(*best, lines);
}

}  // namespace

void add_best_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  add_best(tables, lines);
}

void add_check_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  add_checks(tables, lines);
  add_searches(tables, lines);
}

}  // namespace unbruised::studies
