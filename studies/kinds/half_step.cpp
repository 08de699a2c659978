#include "studies/kinds/half_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "studies/findings/half_step_text.hpp"
#include "studies/findings/summary.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Adds the end of a row, where it was not looked at yet.
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

/// The ends of the rows that set the common window of the best strategies (where none has a set-point: of the
/// first with a window).
void add_deciding_ends(const WindowTable& window, const WindowAnswer& answer, std::vector<KnownEnd>& ends) {
  const auto& all = answer.strategies;
  const bool any_best = std::any_of(all.begin(), all.end(), [](const StrategyWindow& s) { return s.is_best; });
  for (const StrategyWindow& strategy : all) {
    if (any_best ? !strategy.is_best : !strategy.exists) continue;
    add_end(window, strategy.hold_row, WindowEnd::hold, ends);
    add_end(window, strategy.damage_row, WindowEnd::damage, ends);
    if (!any_best) break;
  }
}

void add_ends_on_impacts(const WindowTable& window, std::vector<KnownEnd>& ends) {
  for (std::size_t i = 0; i < window.rows.size(); ++i) {
    const WindowRow& row = window.rows[i];
    if (row.exists && row.hold_on_impact) add_end(window, i, WindowEnd::hold, ends);
    if (row.exists && row.damage_on_impact) add_end(window, i, WindowEnd::damage, ends);
  }
}

std::vector<KnownEnd> ends_to_look_at(LookAt which, const WindowTable& window, const WindowAnswer& answer) {
  std::vector<KnownEnd> ends;
  if (which == LookAt::deciding_ends) add_deciding_ends(window, answer, ends);
  add_ends_on_impacts(window, ends);
  return ends;
}

/// Does a run lie on the safe side of an end?
bool is_safe(const GripSample& sample, WindowEnd end) {
  return (end == WindowEnd::hold ? sample.holds : sample.undamaged) == Verdict::yes;
}

/// One round.
std::optional<std::vector<bool>> safe_sides(const HalfStepLook& look, const StudyWindow& window,
                                            const std::vector<KnownEnd>& ends,
                                            const std::vector<EndRequest>& asked, std::uint64_t round) {
  std::vector<ForceRequest> requests;
  std::map<std::size_t, std::uint64_t> asked_at;
  for (const EndRequest& each : asked) {
    const std::size_t point = window.points[ends[each.end].row];
    requests.push_back({{round, point, asked_at[point]++}, each.grip_force_N, StepSize::half});
  }
  const auto rows = look.run(requests);
  if (!rows) return std::nullopt;
  const std::vector<GripSample> samples = samples_of(look.study, requests, *rows);
  std::vector<bool> safe;
  for (std::size_t i = 0; i < asked.size(); ++i) safe.push_back(is_safe(samples[i], ends[asked[i].end].end));
  return safe;
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

std::string step_sentence(double time_step_s) {
  return joined({"the time step of ", short_number(1e3 * time_step_s),
                 " ms is too long for this end; write simulation.time_step_s = ", short_number(0.5 * time_step_s),
                 " or less"});
}

}  // namespace

std::vector<GripSample> samples_of(const Study& study, const std::vector<ForceRequest>& requests,
                                   const std::vector<ScenarioRow>& rows) {
  std::vector<GripSample> samples;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const Scenario scenario = study.scenario(requests[i].combination());
    samples.push_back(grip_sample(rows[i].result, scenario, requests[i].grip_force_N));
  }
  return samples;
}

std::optional<WindowAnswer> look_at_half_step(const HalfStepLook& look, StudyWindow& window) {
  WindowAnswer answer = look.answer();
  if (varies_time_step(look.study)) return answer;
  std::uint64_t round = kWindowRoundsMost;
  for (auto ends = ends_to_look_at(look.ends, window.table, answer); !ends.empty();
       ends = ends_to_look_at(look.ends, window.table, answer)) {
    const EndSearchResult result = search_ends(ends, look.range, [&](const std::vector<EndRequest>& asked) {
      return safe_sides(look, window, ends, asked, round++);
    });
    if (result.interrupted) return std::nullopt;
    keep_half_step(window.table, ends, result.safe_N);
    answer = look.answer();
  }
  return answer;
}

std::vector<std::string> half_step_warnings(const Study& study, const StudyWindow& window, double tolerance) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < window.table.rows.size(); ++i) {
    for (const EndMove& move : half_step_moves(window.table.rows[i])) {
      if (!(std::abs(move.relative) > tolerance)) continue;
      const std::string at = inputs_text(window.table.inputs, window.table.rows[i].inputs);
      const double time_step_s = study.scenario(window.points[i]).simulation.time_step_s;
      warnings.push_back(
          joined({move_text(move), " at half the time step", at.empty() ? "" : " (", at, at.empty() ? "" : ")",
                  ": ", step_sentence(time_step_s), ". The set-point allows for it"}));
    }
  }
  return warnings;
}

}  // namespace unbruised::studies
