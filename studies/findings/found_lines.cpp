#include "studies/findings/found_lines.hpp"

#include <algorithm>
#include <cmath>

#include "studies/findings/found_parts.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Points of a front and effects that are listed one by one.
constexpr std::size_t kLinesMost = 24;
constexpr std::size_t kPointsMost = 12;

// -- sweep without a window. ------------------------------------------------------------------------------------

std::string over_all(const ResultTable& strategies) {
  const std::string over = text_attribute(strategies, "over");
  return over.empty() ? over : joined({" over all ", over});
}

void add_strategies(const std::vector<ResultTable>& tables, std::string_view held_words,
                    std::vector<std::string>& lines) {
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
    lines.push_back(joined({"best: none; no strategy is ", held_words, over_all(*table)}));
    return;
  }
  lines.push_back(joined({"best:", at_keys(*table, best).substr(5), ": the shortest cycle, ",
                          short_number(number_in(*table, "cycle_time_s", best)), " s, of ", std::to_string(usable),
                          usable == 1 ? " strategy " : " strategies ", held_words, over_all(*table)}));
}

// -- pareto. -------------------------------------------------------------------------------------------------

std::string point_text(const ResultTable& pareto, std::size_t i) {
  std::vector<std::string> objectives;
  for (const ResultColumn& column : pareto.columns) {
    if (!column.name.starts_with("objective_")) continue;
    objectives.push_back(joined({column.long_name, " = ", short_number(number_in(pareto, column.name, i))}));
  }
  return joined({comma_list(objectives), at_keys(pareto, i), scenario_text(pareto, i)});
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

// -- sensitivity, sample. ---------------------------------------------------------------------------------------

/// The rows of the table, metric by metric, most effective first.
std::vector<std::size_t> effect_order(const ResultTable& table, const char* rank) {
  std::vector<std::size_t> order(row_count(table));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const std::string metric_a = text_in(table, "metric", a);
    const std::string metric_b = text_in(table, "metric", b);
    if (metric_a != metric_b) return metric_a < metric_b;
    return number_in(table, rank, a) > number_in(table, rank, b);
  });
  return order;
}

/// "slip_max_m does not vary, whatever the keys are", or the effect of one key.
std::string effect_line(const ResultTable& table, const std::string& rank, std::size_t i) {
  const std::string metric = text_in(table, "metric", i);
  if (const std::string note = text_in(table, kEffectNoteColumn, i); !note.empty()) {
    return joined({metric, " ", note});
  }
  const bool sobol = text_attribute(table, "method") == "sobol";
  const std::string rest = sobol ? joined({", alone ", short_number(number_in(table, "first_order", i))})
                                 : joined({", mean ", short_number(number_in(table, "mean", i)), ", spread ",
                                           short_number(number_in(table, "standard_deviation", i))});
  return joined({metric, ", ", text_in(table, "key", i), ": ", sobol ? "total effect " : "mean absolute effect ",
                 interval_text(number_in(table, rank, i), number_in(table, joined({rank, "_low"}), i),
                               number_in(table, joined({rank, "_high"}), i),
                               number_attribute(table, "confidence").value_or(0.95)),
                 rest});
}

void add_effects(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* table = find_table(tables, "sensitivity");
  if (table == nullptr) return;
  const char* rank = text_attribute(*table, "method") == "sobol" ? "total" : "mean_absolute";
  std::size_t told = 0;
  std::string before;  // a metric without effects has the same line for each of its keys
  for (const std::size_t i : effect_order(*table, rank)) {
    std::string line = effect_line(*table, rank, i);
    if (line == before) continue;
    if (++told > kLinesMost) break;
    before = line;
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
  double products = 0.0;  // some metric exists for each of them
  for (std::size_t i = 0; i < row_count(*table); ++i)
    products = std::fmax(products, number_in(*table, "count", i));
  for (std::size_t i = 0; i < row_count(*table); ++i) {
    // What does not spread, and what only counts work, is left to /statistics.
    const bool spreads = number_in(*table, "quantile_95", i) > number_in(*table, "quantile_05", i);
    const std::string metric = text_in(*table, "metric", i);
    if (!spreads || metric.ends_with("_count") || metric.ends_with("_iterations") || metric.ends_with("_error"))
      continue;
    const double without = products - number_in(*table, "count", i);
    lines.push_back(
        joined({metric, ": mean ", short_number(number_in(*table, "mean", i)), ", 5 to 95 % of the products ",
                short_number(number_in(*table, "quantile_05", i)), " to ",
                short_number(number_in(*table, "quantile_95", i)),
                without > 0.0 ? joined({" (", short_number(without), " products have none)"}) : std::string()}));
  }
}

}  // namespace

std::string interval_text(double estimate, double low, double high, double confidence) {
  if (std::isnan(estimate)) return "not known";
  if (!std::isfinite(low) || !std::isfinite(high)) {
    return joined({short_number(estimate), " (too few samples for an interval)"});
  }
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

std::vector<std::string> found_lines(const std::vector<ResultTable>& tables, std::string_view held_words) {
  std::vector<std::string> lines;
  add_best_lines(tables, lines);
  add_strategies(tables, held_words, lines);
  add_front(tables, lines);
  add_compare_lines(tables, lines);
  add_check_lines(tables, lines);
  add_effects(tables, lines);
  add_statistics(tables, lines);
  add_calibration_lines(tables, lines);
  return lines;
}

}  // namespace unbruised::studies
