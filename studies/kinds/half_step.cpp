#include "studies/kinds/half_step.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "studies/findings/half_step_text.hpp"
#include "studies/findings/summary.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

void add_end(const WindowTable& window, std::optional<std::size_t> place, WindowEnd end,
             std::vector<KnownEnd>& ends) {
  if (!place) return;
  const WindowRow& row = window.rows[*place];
  const bool hold = end == WindowEnd::hold;
  if (!std::isnan(hold ? row.hold_force_half_step_N : row.damage_force_half_step_N)) return;
  const KnownEnd known{.row = *place,
                       .end = end,
                       .safe_N = hold ? row.hold_bracket_high_N : row.damage_bracket_low_N,
                       .unsafe_N = hold ? row.hold_bracket_low_N : row.damage_bracket_high_N};
  const bool is_known = std::any_of(ends.begin(), ends.end(), [&](const KnownEnd& other) {
    return other.row == known.row && other.end == known.end;
  });
  if (!is_known && !std::isnan(known.safe_N)) ends.push_back(known);
}

std::string step_sentence(double time_step_s) {
  return joined({"the time step of ", short_number(1e3 * time_step_s),
                 " ms is too long for this end; write simulation.time_step_s = ", short_number(0.5 * time_step_s),
                 " or less"});
}

}  // namespace

std::vector<KnownEnd> deciding_ends(const WindowTable& window, const WindowAnswer& answer) {
  const auto& all = answer.strategies;
  const bool any_best = std::any_of(all.begin(), all.end(), [](const StrategyWindow& s) { return s.is_best; });
  std::vector<KnownEnd> ends;
  for (const StrategyWindow& strategy : all) {
    if (any_best ? !strategy.is_best : !strategy.exists) continue;
    add_end(window, strategy.hold_row, WindowEnd::hold, ends);
    add_end(window, strategy.damage_row, WindowEnd::damage, ends);
    if (!any_best) break;
  }
  return ends;
}

bool is_safe(const GripSample& sample, WindowEnd end) {
  return (end == WindowEnd::hold ? sample.holds : sample.undamaged) == Verdict::yes;
}

void keep_half_step(WindowTable& window, const std::vector<KnownEnd>& ends, const std::vector<double>& safe_N) {
  for (std::size_t i = 0; i < ends.size(); ++i) {
    WindowRow& row = window.rows[ends[i].row];
    const bool hold = ends[i].end == WindowEnd::hold;
    const double outside = hold ? INFINITY : 0.0;
    (hold ? row.hold_force_half_step_N : row.damage_force_half_step_N) =
        std::isnan(safe_N[i]) ? outside : safe_N[i];
  }
}

std::vector<std::string> half_step_warnings(const WindowTable& window, double tolerance,
                                            const std::vector<double>& time_step_s) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < window.rows.size(); ++i) {
    for (const EndMove& move : half_step_moves(window.rows[i])) {
      if (!(std::abs(move.relative) > tolerance)) continue;
      const std::string at = inputs_text(window.inputs, window.rows[i].inputs);
      warnings.push_back(
          joined({move_text(move), " at half the time step", at.empty() ? "" : " (", at, at.empty() ? "" : ")",
                  ": ", step_sentence(time_step_s[i]), ". The set-point allows for it"}));
    }
  }
  return warnings;
}

}  // namespace unbruised::studies
