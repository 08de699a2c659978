#include "studies/findings/found_lines.hpp"

#include <algorithm>
#include <cmath>

#include "studies/findings/table_text.hpp"
#include "studies/statistics/intervals.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Searches whose best lies within this part of the best of all count as having found it.
constexpr double kSameOptimum = 0.01;
/// Points of a front, effects and strategies that are listed one by one.
constexpr std::size_t kLinesMost = 24;
constexpr std::size_t kPointsMost = 12;

std::string interval_text(double estimate, double low, double high, double confidence) {
  return joined({short_number(estimate), " (", percent(confidence), " interval ", short_number(low), " to ",
                 short_number(high), ")"});
}

std::string scenario_text(const ResultTable& table, std::size_t row) {
  const double scenario = number_in(table, "scenario", row);
  return std::isnan(scenario) ? std::string()
                              : joined({" (scenario ", std::to_string(static_cast<long long>(scenario)), ")"});
}

std::string at_keys(const ResultTable& table, std::size_t row) {
  const std::string keys = keys_text(table, row);
  return keys.empty() ? " with the strategy as written" : joined({" with ", keys});
}

// -- optimize and robust. ------------------------------------------------------------------------------------

std::string best_sentence(const ResultTable& best) {
  if (number_in(best, "feasible", 0) == 1.0) {
    return joined({"best: ", text_attribute(best, "objective"), " = ",
                   short_number(number_in(best, "objective", 0)), at_keys(best, 0), scenario_text(best, 0)});
  }
  return joined({"none feasible: of all strategies tried the least violated breaks a constraint by ",
                 percent(number_in(best, "violation", 0)), at_keys(best, 0), scenario_text(best, 0),
                 "; binding: ", text_in(best, "binding", 0)});
}

void add_probability(const ResultTable& best, std::vector<std::string>& lines) {
  const double estimate = number_in(best, "probability", 0);
  if (std::isnan(estimate)) return;
  const double confidence = number_attribute(best, "confidence").value_or(0.95);
  const double products = number_attribute(best, "products").value_or(0.0);
  lines.push_back(joined({"P(", text_attribute(best, "event"), ") = ",
                          interval_text(estimate, number_in(best, "probability_low", 0),
                                        number_in(best, "probability_high", 0), confidence),
                          " on ", with_thousands(static_cast<unsigned long long>(products)), " products"}));
}

void add_active(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* constraints = find_table(tables, "constraints");
  if (constraints == nullptr) return;
  std::string text;
  for (std::size_t i = 0; i < row_count(*constraints); ++i) {
    if (number_in(*constraints, "active", i) != 1.0) continue;
    text += joined({text.empty() ? "" : "; ", text_in(*constraints, "text", i)});
  }
  lines.push_back(joined({"active constraints: ", text.empty() ? "none" : text}));
}

void add_bounds(const ResultTable& best, std::vector<std::string>& lines) {
  const std::string bounds = text_attribute(best, "at_bounds");
  if (!bounds.empty())
    lines.push_back(joined({"at the end of its range: ", bounds, "; a wider range may do better"}));
}

std::string check_text(const ResultTable& checks, std::size_t i) {
  const double change = number_in(checks, "objective_change", i);
  std::string text = joined(
      {text_in(checks, "check", i), ": objective ",
       std::isnan(change) ? std::string("does not exist") : joined({change < 0.0 ? "" : "+", percent(change)})});
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
  const bool keeps = number_in(checks, "feasible", i) == 1.0;
  return text + (keeps ? ", every constraint kept"
                       : joined({", BREAKS ", text_in(checks, "binding", i), " by ",
                                 percent(number_in(checks, "violation", i))}));
}

void add_checks(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* checks = find_table(tables, "verification");
  if (checks == nullptr) return;
  // Row 0 is the strategy as found: what the others are compared with.
  for (std::size_t i = 1; i < row_count(*checks); ++i)
    lines.push_back(joined({"checked, ", check_text(*checks, i)}));
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
  add_active(tables, lines);
  add_bounds(*best, lines);
}

// -- sweep without a window. ------------------------------------------------------------------------------------

std::string over_all(const ResultTable& strategies) {
  const std::string over = text_attribute(strategies, "over");
  return over.empty() ? over : joined({" over all ", over});
}

void add_strategies(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* table = find_table(tables, "strategies");
  if (table == nullptr) return;
  const std::size_t count = row_count(*table);
  std::size_t usable = 0;
  std::size_t best = count;
  for (std::size_t i = 0; i < count; ++i) {
    usable += number_in(*table, "held", i) == number_in(*table, "combinations", i) ? 1U : 0U;
    if (number_in(*table, "best", i) == 1.0) best = i;
  }
  if (best == count) {
    lines.push_back(joined({"best: none; no strategy is held without damage", over_all(*table)}));
    return;
  }
  lines.push_back(joined({"best:", at_keys(*table, best).substr(5), ": the shortest cycle, ",
                          short_number(number_in(*table, "cycle_time_s", best)), " s, of ", std::to_string(usable),
                          usable == 1 ? " strategy" : " strategies", " held without damage", over_all(*table)}));
}

// -- pareto. -------------------------------------------------------------------------------------------------

std::string point_text(const ResultTable& pareto, std::size_t i) {
  std::string text;
  for (const ResultColumn& column : pareto.columns) {
    if (!column.name.starts_with("objective_")) continue;
    text += joined(
        {text.empty() ? "" : ", ", column.long_name, " = ", short_number(number_in(pareto, column.name, i))});
  }
  return text + joined({at_keys(pareto, i), scenario_text(pareto, i)});
}

void add_front(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* pareto = find_table(tables, "pareto");
  if (pareto == nullptr) return;
  const std::size_t count = row_count(*pareto);
  if (count == 0) return;
  lines.push_back(
      joined({"front: ", std::to_string(count), " strategies that no other beats in every objective; hypervolume ",
              short_number(number_attribute(*pareto, "hypervolume").value_or(0.0))}));
  for (std::size_t i = 0; i < count; ++i) {
    if (number_in(*pareto, "knee", i) == 1.0) lines.push_back(joined({"knee: ", point_text(*pareto, i)}));
  }
  // Evenly chosen where there are too many to list.
  const std::size_t shown = std::min(count, kPointsMost);
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t i = shown == 1 ? 0 : k * (count - 1) / (shown - 1);
    lines.push_back(joined({"  ", point_text(*pareto, i)}));
  }
  if (shown < count) lines.push_back(joined({"  ... and ", std::to_string(count - shown), " more in /pareto"}));
}

// -- compare, sensitivity, sample. -----------------------------------------------------------------------------

void add_comparison(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* candidates = find_table(tables, "candidates");
  const ResultTable* comparison = find_table(tables, "comparison");
  if (candidates == nullptr || comparison == nullptr) return;
  const double confidence = number_attribute(*candidates, "confidence").value_or(0.95);
  for (std::size_t i = 0; i < row_count(*candidates); ++i) {
    std::string line = joined(
        {text_in(*candidates, "name", i), ": P(held) = ",
         interval_text(number_in(*candidates, "probability", i), number_in(*candidates, "probability_low", i),
                       number_in(*candidates, "probability_high", i), confidence)});
    for (const ResultColumn& column : candidates->columns) {
      if (!column.name.starts_with("mean_")) continue;
      line +=
          joined({", mean ", column.name.substr(5), " = ", short_number(number_in(*candidates, column.name, i))});
    }
    lines.push_back(std::move(line));
  }
  for (std::size_t i = 0; i < std::min(row_count(*comparison), kLinesMost); ++i) {
    const auto count = [&](const char* column) {
      return std::to_string(static_cast<long long>(number_in(*comparison, column, i)));
    };
    lines.push_back(joined({text_in(*comparison, "a", i), " against ", text_in(*comparison, "b", i), " in ",
                            text_in(*comparison, "metric", i), ": better on ", count("wins"), ", equal on ",
                            count("ties"), ", worse on ", count("losses"), " products"}));
  }
  lines.push_back(joined({"verdict: ", text_attribute(*comparison, "verdict")}));
}

void add_effects(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* table = find_table(tables, "sensitivity");
  if (table == nullptr) return;
  const bool sobol = text_attribute(*table, "method") == "sobol";
  const char* rank = sobol ? "total" : "mean_absolute";
  std::vector<std::size_t> order(row_count(*table));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const std::string metric_a = text_in(*table, "metric", a);
    const std::string metric_b = text_in(*table, "metric", b);
    if (metric_a != metric_b) return metric_a < metric_b;
    return number_in(*table, rank, a) > number_in(*table, rank, b);
  });
  const double confidence = number_attribute(*table, "confidence").value_or(0.95);
  for (std::size_t k = 0; k < std::min(order.size(), kLinesMost); ++k) {
    const std::size_t i = order[k];
    const std::string low = joined({rank, "_low"});
    const std::string high = joined({rank, "_high"});
    std::string line = joined({text_in(*table, "metric", i), ", ", text_in(*table, "key", i), ": ",
                               sobol ? "total effect " : "mean absolute effect ",
                               interval_text(number_in(*table, rank, i), number_in(*table, low, i),
                                             number_in(*table, high, i), confidence)});
    line += sobol ? joined({", alone ", short_number(number_in(*table, "first_order", i))})
                  : joined({", mean ", short_number(number_in(*table, "mean", i)), ", spread ",
                            short_number(number_in(*table, "standard_deviation", i))});
    lines.push_back(std::move(line));
  }
  const double left_out = number_attribute(*table, "left_out").value_or(0.0);
  if (left_out > 0.0) {
    lines.push_back(
        joined({short_number(left_out), " of ", short_number(number_attribute(*table, "samples").value_or(0.0)),
                " samples are left out: a metric does not exist in them"}));
  }
}

void add_statistics(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* table = find_table(tables, "statistics");
  if (table == nullptr) return;
  lines.push_back(
      joined({"P(held) = ", interval_text(number_attribute(*table, "probability").value_or(kAbsent),
                                          number_attribute(*table, "probability_low").value_or(kAbsent),
                                          number_attribute(*table, "probability_high").value_or(kAbsent),
                                          number_attribute(*table, "confidence").value_or(0.95))}));
  for (std::size_t i = 0; i < row_count(*table); ++i) {
    // What does not spread, and what only counts work, is left to /statistics.
    const bool spreads = number_in(*table, "quantile_95", i) > number_in(*table, "quantile_05", i);
    const std::string metric = text_in(*table, "metric", i);
    if (!spreads || metric.ends_with("_count") || metric.ends_with("_iterations") || metric.ends_with("_error"))
      continue;
    lines.push_back(joined({metric, ": mean ", short_number(number_in(*table, "mean", i)),
                            ", 5 to 95 % of the products ", short_number(number_in(*table, "quantile_05", i)),
                            " to ", short_number(number_in(*table, "quantile_95", i))}));
  }
}

}  // namespace

std::vector<std::string> found_lines(const std::vector<ResultTable>& tables) {
  std::vector<std::string> lines;
  add_best(tables, lines);
  add_strategies(tables, lines);
  add_front(tables, lines);
  add_checks(tables, lines);
  add_searches(tables, lines);
  add_comparison(tables, lines);
  add_effects(tables, lines);
  add_statistics(tables, lines);
  return lines;
}

}  // namespace unbruised::studies
