#include "studies/findings/check_warnings.hpp"

#include <cmath>
#include <optional>

#include "studies/findings/front_check.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// "half the time step (simulation.time_step_s = 0.0005)"
std::string check_name(const ResultTable& checks, std::size_t row) {
  const std::string change = text_in(checks, "change", row);
  const std::string name = text_in(checks, "check", row);
  return change.empty() ? name : joined({name, " (", change, ")"});
}

std::optional<std::string> broken_constraint(const ResultTable& checks, std::size_t row) {
  if (number_in(checks, "feasible", row) == 1.0) return std::nullopt;
  if (const std::string says = text_in(checks, "says", row); !says.empty()) {
    return joined({"the winner does not stand a check: with ", check_name(checks, row), " ", says,
                   "; do not use it as it is"});
  }
  if (!(number_in(checks, "violation", row) > 0.0)) {
    return joined({"the best strategy does not stand a check: with ", check_name(checks, row),
                   " its objective does not exist (", text_in(checks, "outcomes", row),
                   "); do not use it as it is"});
  }
  return joined({"the best strategy does not stand a check: with ", check_name(checks, row), " it breaks ",
                 text_in(checks, "binding", row), " by ", percent(number_in(checks, "violation", row)),
                 "; do not use it as it is"});
}

std::optional<std::string> moved_margin(const ResultTable& checks, std::size_t row) {
  const double found = number_in(checks, "damage_margin", 0);
  const double margin = number_in(checks, "damage_margin", row);
  if (!(std::abs(margin - found) > kDamageMarginTrust)) return std::nullopt;
  return joined({"the margin against damage of the best strategy is ", percent(found), ", but ", percent(margin),
                 " with ", check_name(checks, row), ": it depends on how finely the study computes"});
}

}  // namespace

std::vector<std::string> check_warnings(const std::vector<ResultTable>& tables) {
  std::vector<std::string> warnings;
  if (const ResultTable* pareto = find_table(tables, "pareto"); pareto != nullptr) {
    if (auto broken = front_check_warning(*pareto)) warnings.push_back(std::move(*broken));
  }
  const ResultTable* checks = find_table(tables, "verification");
  if (checks == nullptr) return warnings;
  for (std::size_t row = 1; row < row_count(*checks); ++row) {
    if (auto broken = broken_constraint(*checks, row)) {
      warnings.push_back(std::move(*broken));
    } else if (text_in(*checks, "check", row) != "other products") {
      if (auto moved = moved_margin(*checks, row)) warnings.push_back(std::move(*moved));
    }
  }
  return warnings;
}

}  // namespace unbruised::studies
