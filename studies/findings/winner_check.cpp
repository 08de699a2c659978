#include "studies/findings/winner_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/findings/check_warnings.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/results/outcome_counts.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// What decides about a winner.
struct WinnerNumbers {
  double objective = kAbsent;
  double probability = kAbsent, low = kAbsent, high = kAbsent;
  double peak_finger_force_N = kAbsent;  ///< the largest
  std::string outcomes{};
  double violation = 0.0;  ///< > 0: it is no winner
  std::string standing{};  ///< in words
};

/// Counts the rows that are the winner's own. @return how they ended
template <class IsOwn>
OutcomeCounts add_rows(const StudyRows& rows, IsOwn is_own, WinnerNumbers& numbers) {
  OutcomeCounts counts;
  for (const ScenarioRow& row : rows) {
    if (!is_own(row)) continue;
    counts.add(row.result.outcome);
    numbers.peak_finger_force_N =
        std::fmax(numbers.peak_finger_force_N, row.result.metrics[Metric::peak_finger_force_N]);
  }
  numbers.outcomes = counts_text(counts);
  return counts;
}

std::string moved_text(const std::string& name, double found, double again) {
  if (std::isnan(found) && std::isnan(again)) return {};
  return joined({name, " ", short_number(again), " (", short_number(found), " as found)"});
}

/// "b stays the winner; cycle_time_s 2.13 (2.1 as found), ...; 12 runs repeated, whose impact ..."
std::string says(const std::string& objective, const WinnerNumbers& found, const WinnerNumbers& again,
                 std::size_t repeated) {
  std::string moves;
  add_part(moves, ", ", moved_text(objective, found.objective, again.objective));
  add_part(moves, ", ", moved_text("P(held)", found.probability, again.probability));
  add_part(moves, ", ",
           moved_text("largest peak_finger_force_N", found.peak_finger_force_N, again.peak_finger_force_N));
  return joined({again.standing, moves.empty() ? "" : "; ", moves, "; ", with_thousands(repeated),
                 repeated == 1 ? " run" : " runs", " repeated, whose impact the step does not resolve"});
}

ResultTable check_table(const Study& study, const std::string& objective, const WinnerNumbers& found,
                        const WinnerNumbers& again, std::size_t repeated) {
  const double step_s = 0.5 * study.scenario(0).simulation.time_step_s;
  const auto pair = [&](double WinnerNumbers::*value) { return std::vector<double>{found.*value, again.*value}; };
  const double change = found.objective == 0.0 ? kAbsent : again.objective / found.objective - 1.0;
  const double stands = again.violation > 0.0 ? 0.0 : 1.0;
  return {
      .name = "verification",
      .row = "check_number",
      .columns = {{"check", "", "what was looked at again", std::vector<std::string>{"as found", kHalfStep}},
                  {"change", "", "what differs",
                   std::vector<std::string>{"", joined({kTimeStepKey, " = ", short_number(step_s)})}},
                  {"objective", "", objective, pair(&WinnerNumbers::objective)},
                  {"objective_change", "1", "relative to as found; NaN where that is zero",
                   std::vector<double>{0.0, change}},
                  {"probability", "1", "estimated P(held)", pair(&WinnerNumbers::probability)},
                  {"probability_low", "1", "lower end of its interval", pair(&WinnerNumbers::low)},
                  {"probability_high", "1", "upper end of its interval", pair(&WinnerNumbers::high)},
                  {"peak_finger_force_N", "N", "the largest", pair(&WinnerNumbers::peak_finger_force_N)},
                  {"violation", "1", "> 0: it is no winner", pair(&WinnerNumbers::violation)},
                  {"feasible", "1", "1: it is still the winner", std::vector<double>{1.0, stands}},
                  {"outcomes", "", "how its runs end", std::vector<std::string>{found.outcomes, again.outcomes}},
                  {"says", "", "the check in words",
                   std::vector<std::string>{"", says(objective, found, again, repeated)}}},
      .attributes = {{"repeated", static_cast<double>(repeated)}}};
}

// -- sweep. ------------------------------------------------------------------------------------------------------

WinnerNumbers grid_numbers(const GridAnswer& found, const StudyRows& rows) {
  WinnerNumbers numbers;
  double count = 0.0;
  const auto is_own = [&](const ScenarioRow& row) {
    if (!std::binary_search(found.best_rows.begin(), found.best_rows.end(), row.id)) return false;
    count += 1.0;
    if (row.result.outcome == Outcome::held) {
      numbers.objective = std::fmax(numbers.objective, row.result.metrics[Metric::cycle_time_s]);
    }
    return true;
  };
  const OutcomeCounts counts = add_rows(rows, is_own, numbers);
  const auto held = static_cast<double>(counts.of[static_cast<std::size_t>(Outcome::held)]);
  numbers.violation = 1.0 - held / count;
  numbers.standing = held == count ? "the best strategy stays held"
                                   : joined({"the best strategy is held in ", short_number(held), " of ",
                                             short_number(count), " runs only (", numbers.outcomes, ")"});
  return numbers;
}

// -- compare. ----------------------------------------------------------------------------------------------------

WinnerNumbers compare_numbers(const Study& study, std::size_t winner, const std::vector<ResultTable>& tables,
                              const StudyRows& rows) {
  const ResultTable& candidates = *find_table(tables, "candidates");
  const ResultTable& comparison = *find_table(tables, "comparison");
  const std::string metric(info_of(study.compare().metric).name);
  WinnerNumbers numbers{.objective = number_in(candidates, joined({"mean_", metric}), winner),
                        .probability = number_in(candidates, "probability", winner),
                        .low = number_in(candidates, "probability_low", winner),
                        .high = number_in(candidates, "probability_high", winner)};
  add_rows(
      rows, [&](const ScenarioRow& row) { return compare_index(study, row.id).candidate == winner; }, numbers);
  const std::string& name = study.candidates()[winner].name;
  const std::string now = text_attribute(comparison, "winner");
  numbers.violation = now == name ? 0.0 : 1.0;
  numbers.standing =
      now == name ? joined({name, " stays the winner"})
                  : joined({name, " is not the winner any more (", text_attribute(comparison, "headline"), ")"});
  return numbers;
}

}  // namespace

ResultTable grid_check(const Study& study, const GridAnswer& found, const RowsTwice& rows) {
  return check_table(study, std::string(info_of(Metric::cycle_time_s).name), grid_numbers(found, rows.found),
                     grid_numbers(found, rows.again), rows.repeated);
}

ResultTable compare_check(const Study& study, const std::vector<ResultTable>& tables, const RowsTwice& rows) {
  const std::string name = text_attribute(*find_table(tables, "comparison"), "winner");
  const std::vector<StrategyCandidate>& all = study.candidates();
  const auto winner = static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [&](const StrategyCandidate& c) { return c.name == name; }) -
      all.begin());
  return check_table(study, joined({"mean ", info_of(study.compare().metric).name}),
                     compare_numbers(study, winner, tables, rows.found),
                     compare_numbers(study, winner, compare_tables(study, rows.again), rows.again), rows.repeated);
}

}  // namespace unbruised::studies
