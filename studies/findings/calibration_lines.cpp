#include <algorithm>
#include <cmath>

#include "studies/findings/found_parts.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Specimens that are listed one by one.
constexpr std::size_t kSpecimensMost = 12;

std::string whole(double count) { return std::to_string(static_cast<long long>(count)); }

void add_population(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* table = find_table(tables, "population");
  if (table == nullptr) return;
  const double specimens = number_attribute(*table, "specimens").value_or(0.0);
  for (std::size_t i = 0; i < row_count(*table); ++i) {
    const double mean = number_in(*table, "mean", i);
    const double deviation = number_in(*table, "standard_deviation", i);
    lines.push_back(specimens < 2.0 ? joined({text_in(*table, "key", i), " = ", short_number(mean)})
                                    : joined({text_in(*table, "key", i), ": mean ", short_number(mean),
                                              ", deviation ", short_number(deviation), " (",
                                              percent(deviation / std::abs(mean)), ") between specimens"}));
  }
  const ResultTable* pairs = find_table(tables, "population_correlation");
  for (std::size_t i = 0; pairs != nullptr && i < row_count(*pairs); ++i) {
    lines.push_back(
        joined({"rank correlation of ", text_in(*pairs, "first", i), " and ", text_in(*pairs, "second", i), ": ",
                short_number(number_in(*pairs, "rank_correlation", i))}));
  }
}

std::string specimen_line(const ResultTable& table, std::size_t i) {
  std::vector<std::string> values;
  const double confidence = number_attribute(table, "confidence").value_or(0.95);
  for (const ResultColumn& column : table.columns) {
    if (column.name.find('.') == std::string::npos || column.name.ends_with("_low") ||
        column.name.ends_with("_high"))
      continue;
    const std::string leaf = column.name.substr(column.name.rfind('.') + 1);
    values.push_back(
        joined({leaf, " = ",
                interval_text(number_in(table, column.name, i), number_in(table, column.name + "_low", i),
                              number_in(table, column.name + "_high", i), confidence)}));
  }
  std::string line = joined({"  ", text_in(table, "specimen", i), ": ", comma_list(values), ", residual ",
                             short_number(number_in(table, "rms_residual", i))});
  add_part(line, "; ", text_in(table, "note", i));
  return line;
}

void add_prediction(const ResultTable& table, std::vector<std::string>& lines) {
  const double count = number_attribute(table, "predicted").value_or(0.0);
  if (count == 0.0) return;
  lines.push_back(
      joined({text_attribute(table, "outcome"), " of each specimen from its keys, by the others: mean error ",
              short_number(number_attribute(table, "mean_error").value_or(kAbsent)), " (",
              percent(number_attribute(table, "mean_error_relative").value_or(kAbsent)), "), without its curve ",
              short_number(number_attribute(table, "mean_absolute_deviation").value_or(kAbsent)), "; ",
              whole(number_attribute(table, "predicted_covered").value_or(0.0)), " of ", whole(count),
              " inside their ", percent(number_attribute(table, "confidence").value_or(0.95)), " interval"}));
}

}  // namespace

void add_calibration_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* table = find_table(tables, "calibration");
  if (table == nullptr) return;
  const std::size_t count = row_count(*table);
  lines.push_back(joined({"calibrated: ", whole(number_attribute(*table, "told").value_or(0.0)), " of ",
                          std::to_string(count), count == 1 ? " specimen (" : " specimens (",
                          text_attribute(*table, "measured"), " over ", text_attribute(*table, "over"), ")"}));
  add_population(tables, lines);
  const std::size_t shown = std::min(count, kSpecimensMost);
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(specimen_line(*table, i));
  if (shown < count)
    lines.push_back(joined({"  ... and ", std::to_string(count - shown), " more in /calibration"}));
  add_prediction(*table, lines);
}

}  // namespace unbruised::studies
