#include "studies/findings/front_check.hpp"

#include <cmath>
#include <utility>

#include "studies/findings/check_warnings.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr const char* kViolationColumn = "half_step_violation";

std::string objective_column(std::size_t k) { return joined({"objective_", std::to_string(k + 1)}); }
std::string half_step_column(const std::string& column) { return joined({"half_step_", column}); }

struct FrontCounts {
  std::size_t looked_at = 0;
  std::size_t broken = 0;
};

FrontCounts counts_of(const ResultTable& pareto) {
  FrontCounts counts;
  for (std::size_t i = 0; i < row_count(pareto); ++i) {
    const double violation = number_in(pareto, kViolationColumn, i);
    if (std::isnan(violation)) continue;
    ++counts.looked_at;
    counts.broken += violation > 0.0 ? 1U : 0U;
  }
  return counts;
}

/// The largest move of an objective, in parts of it; NaN where there is none to tell.
double largest_move(const ResultTable& pareto, const std::string& column) {
  double largest = kAbsent;
  for (std::size_t i = 0; i < row_count(pareto); ++i) {
    const double found = number_in(pareto, column, i);
    if (found == 0.0) continue;
    largest = std::fmax(largest, std::abs(number_in(pareto, half_step_column(column), i) / found - 1.0));
  }
  return largest;
}

}  // namespace

std::vector<std::size_t> points_on_impacts(const std::vector<const Candidate*>& front) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (front[i]->unresolved_impact) places.push_back(i);
  }
  return places;
}

void add_half_step_columns(const std::vector<const Candidate*>& front, const std::vector<Candidate>& again,
                           ResultTable& pareto) {
  if (again.empty()) return;
  const std::vector<std::size_t> places = points_on_impacts(front);
  const auto add = [&](const std::string& name, const std::string& long_name, const auto& value_of) {
    std::vector<double> values(front.size(), kAbsent);
    for (std::size_t k = 0; k < places.size(); ++k) values[places[k]] = value_of(again[k]);
    pareto.columns.push_back({name, "", long_name, std::move(values)});
  };
  for (std::size_t k = 0; k < front.front()->objectives.size(); ++k) {
    add(half_step_column(objective_column(k)), joined({"the objective at ", kHalfStep}),
        [k](const Candidate& candidate) { return candidate.objectives[k]; });
  }
  add(kViolationColumn, joined({"violation at ", kHalfStep}),
      [](const Candidate& candidate) { return candidate.violation; });
}

std::optional<std::string> front_check_line(const ResultTable& pareto) {
  const FrontCounts counts = counts_of(pareto);
  if (counts.looked_at == 0) return std::nullopt;
  const std::string line = joined({"checked, ", kHalfStep, ", ", std::to_string(counts.looked_at),
                                   counts.looked_at == 1 ? " point" : " points",
                                   " of the front whose impact the step does not resolve: "});
  std::string moves;
  for (const ResultColumn& column : pareto.columns) {
    if (!column.name.starts_with("objective_")) continue;
    const double move = largest_move(pareto, column.name);
    if (!std::isnan(move)) add_part(moves, ", ", joined({column.long_name, " moves by at most ", percent(move)}));
  }
  add_part(moves, ", ",
           counts.broken == 0 ? std::string("every constraint kept")
                              : joined({std::to_string(counts.broken),
                                        counts.broken == 1 ? " BREAKS a constraint" : " BREAK a constraint"}));
  return line + moves;
}

std::optional<std::string> front_check_warning(const ResultTable& pareto) {
  const FrontCounts counts = counts_of(pareto);
  if (counts.broken == 0) return std::nullopt;
  return joined({std::to_string(counts.broken),
                 counts.broken == 1 ? " point of the front breaks" : " points of the front break",
                 " a constraint at ", kHalfStep,
                 " (half_step_violation > 0 in /pareto); do not use what breaks as it is"});
}

}  // namespace unbruised::studies
