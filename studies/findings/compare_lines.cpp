#include <algorithm>
#include <cmath>

#include "studies/findings/found_parts.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Pairs that are listed one by one.
constexpr std::size_t kPairsMost = 24;

/// "gentle (grip_force_N = 2): P(held) = 1 (95 % interval 0.8 to 1); mean cycle_time_s = 2.1 over 16 products
/// held"
std::string candidate_line(const ResultTable& candidates, std::size_t i) {
  const double confidence = number_attribute(candidates, "confidence").value_or(0.95);
  const std::string settings = keys_text(candidates, i);
  std::string line = joined(
      {text_in(candidates, "name", i), settings.empty() ? "" : joined({" (", settings, ")"}), ": P(held) = ",
       interval_text(number_in(candidates, "probability", i), number_in(candidates, "probability_low", i),
                     number_in(candidates, "probability_high", i), confidence)});
  for (const ResultColumn& column : candidates.columns) {
    if (!column.name.starts_with("mean_")) continue;
    const std::string metric = column.name.substr(5);
    const double products = number_in(candidates, joined({"products_", metric}), i);
    if (products == 0.0) {
      line += joined({"; ", metric, " is of no product: none is held"});
      continue;
    }
    line += joined({"; mean ", metric, " = ", short_number(number_in(candidates, column.name, i))});
    if (std::isnan(products)) continue;  // a file from before the products were counted
    line += joined({" over ", short_number(products), products == 1.0 ? " product held" : " products held"});
  }
  return line;
}

std::string pair_line(const ResultTable& comparison, std::size_t i) {
  const auto count = [&](const char* column) {
    return std::to_string(static_cast<long long>(number_in(comparison, column, i)));
  };
  return joined({text_in(comparison, "a", i), " against ", text_in(comparison, "b", i), ", held first, then ",
                 text_in(comparison, "metric", i), ": better on ", count("wins"), ", equal on ", count("ties"),
                 ", worse on ", count("losses"), " products"});
}

}  // namespace

void add_compare_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines) {
  const ResultTable* candidates = find_table(tables, "candidates");
  const ResultTable* comparison = find_table(tables, "comparison");
  if (candidates == nullptr || comparison == nullptr) return;
  const std::string headline = text_attribute(*comparison, "headline");
  if (!headline.empty()) lines.push_back(headline);
  lines.push_back(joined({"verdict: ", text_attribute(*comparison, "verdict")}));
  for (std::size_t i = 0; i < row_count(*candidates); ++i) lines.push_back(candidate_line(*candidates, i));
  const std::size_t shown = std::min(row_count(*comparison), kPairsMost);
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(pair_line(*comparison, i));
}

}  // namespace unbruised::studies
