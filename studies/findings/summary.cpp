#include "studies/findings/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "studies/findings/found_lines.hpp"
#include "studies/findings/grip_window.hpp"
#include "studies/results/digest.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kCombinationLinesOfSweep = 12;
constexpr std::size_t kCombinationLinesOfSearch = 200;

std::string input_text(const InputValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? short_number(*number) : std::get<std::string>(value);
}

/// "a, b and c" of the keys' last parts.
std::string leaves_text(const std::vector<ColumnInfo>& columns) {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) text += i + 1 == columns.size() ? " and " : ", ";
    text += key_leaf(columns[i].key);
  }
  return text;
}

/// "(1.05, 1.12]": the force is above the first and at most the second.
std::string hold_bracket_text(const WindowRow& row) {
  if (std::isnan(row.hold_bracket_low_N)) return joined({"at or below ", short_number(row.hold_bracket_high_N)});
  return joined({"in (", short_number(row.hold_bracket_low_N), ", ", short_number(row.hold_bracket_high_N), "]"});
}

std::string damage_bracket_text(const WindowRow& row) {
  if (std::isnan(row.damage_bracket_high_N))
    return joined({"at or above ", short_number(row.damage_bracket_low_N)});
  return joined(
      {"in [", short_number(row.damage_bracket_low_N), ", ", short_number(row.damage_bracket_high_N), ")"});
}

std::string ends_text(double hold_N, bool hold_is_bound, double damage_N, bool damage_is_bound) {
  return joined({hold_is_bound ? "[<= " : "[", short_number(hold_N), ", ", damage_is_bound ? ">= " : "",
                 short_number(damage_N), "] N"});
}

std::string percent_text(double ratio) { return joined({short_number(100.0 * ratio), " %"}); }

/// "[1.12, 2.31] N, margin 106 % (F_hold in ..., F_damage in ...)", or the note that says why there is none.
std::string window_text(const WindowRow& row) {
  if (!row.exists) return row.note;
  std::string text = ends_text(row.hold_bracket_high_N, std::isnan(row.hold_bracket_low_N),
                               row.damage_bracket_low_N, std::isnan(row.damage_bracket_high_N));
  if (!std::isnan(row.margin)) text += joined({", margin ", percent_text(row.margin)});
  text += joined({" (F_hold ", hold_bracket_text(row), ", F_damage ", damage_bracket_text(row), ")"});
  if (!row.note.empty()) text += joined({"; ", row.note});
  return text;
}

std::string at_text(const WindowTable& window, const WindowRow& row) {
  const std::string inputs = inputs_text(window.inputs, row.inputs);
  return inputs.empty() ? inputs : joined({" at ", inputs});
}

std::string combination_line(const WindowTable& window, const WindowRow& row) {
  if (row.exists) return joined({"grip window", at_text(window, row), ": ", window_text(row)});
  // The note begins with the words "no window" itself.
  constexpr std::string_view kBegin = "no window: ";
  const std::string_view note = row.note;
  return joined(
      {"no window", at_text(window, row), ": ", note.starts_with(kBegin) ? note.substr(kBegin.size()) : note});
}

std::string common_text(const WindowTable& window, const CommonWindow& common) {
  std::string text =
      ends_text(common.hold_force_N, common.hold_is_bound, common.damage_force_N, common.damage_is_bound);
  text +=
      joined({" (brackets: F_hold ", hold_bracket_text(*common.hold_row), at_text(window, *common.hold_row),
              "; F_damage ", damage_bracket_text(*common.damage_row), at_text(window, *common.damage_row), ")"});
  return text;
}

std::string disjoint_text(const WindowTable& window, const CommonWindow& common) {
  return joined({"holding needs ", short_number(common.hold_force_N), " N", at_text(window, *common.hold_row),
                 ", but damage begins above ", short_number(common.damage_force_N), " N",
                 at_text(window, *common.damage_row)});
}

/// One line over all combinations, and where some have no window one over those that have one.
std::vector<std::string> common_lines(const WindowTable& window) {
  const std::string keys = leaves_text(window.inputs);
  const CommonWindow common = common_window(window.rows);
  if (common.exists) return {joined({"grip window over all ", keys, ": ", common_text(window, common)})};
  std::vector<WindowRow> with_window;
  std::copy_if(window.rows.begin(), window.rows.end(), std::back_inserter(with_window),
               [](const WindowRow& row) { return row.exists; });
  const std::size_t without = window.rows.size() - with_window.size();
  if (without == 0) return {joined({"no window common to all ", keys, ": ", disjoint_text(window, common)})};
  std::vector<std::string> lines = {
      joined({"no window common to all ", keys, ": ", std::to_string(without), " of ",
              std::to_string(window.rows.size()), " combinations have none"})};
  if (!with_window.empty()) {
    const CommonWindow rest = common_window(with_window);
    lines.push_back(rest.exists ? joined({"grip window over the other ", std::to_string(with_window.size()), ": ",
                                          common_text(window, rest)})
                                : joined({"no window common to the other ", std::to_string(with_window.size()),
                                          ": ", disjoint_text(window, rest)}));
  }
  return lines;
}

bool is_better(const ScenarioRow& a, const ScenarioRow& b) {
  const double time_a = a.result.metrics[Metric::cycle_time_s];
  const double time_b = b.result.metrics[Metric::cycle_time_s];
  if (time_a != time_b) return time_a < time_b;
  const double margin_a = a.result.metrics[Metric::friction_margin_min];
  const double margin_b = b.result.metrics[Metric::friction_margin_min];
  if (margin_a != margin_b && !std::isnan(margin_b)) return margin_a > margin_b;
  if (std::isnan(margin_b) && !std::isnan(margin_a)) return true;
  return a.id < b.id;
}

/// Order in which rows that are not held are shown.
int seriousness(Outcome outcome) {
  switch (outcome) {
    case Outcome::diverged:
      return 0;
    case Outcome::out_of_range:
      return 1;
    case Outcome::dropped:
      return 2;
    case Outcome::not_grasped:
      return 3;
    case Outcome::damaged:
      return 4;
    case Outcome::slipped:
      return 5;
    default:
      return 6;
  }
}

}  // namespace

std::string key_leaf(const std::string& key) {
  // `use` says nothing without its table.
  if (key.ends_with(".use")) return key;
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

std::string inputs_text(const std::vector<ColumnInfo>& columns, const std::vector<InputValue>& inputs) {
  std::string text;
  for (std::size_t i = 0; i < columns.size() && i < inputs.size(); ++i) {
    if (i > 0) text += ", ";
    text += joined({key_leaf(columns[i].key), " = ", input_text(inputs[i])});
  }
  return text;
}

std::string outcome_line(const std::vector<ScenarioRow>& rows) {
  std::array<std::size_t, kOutcomeWords.size()> counts{};
  std::size_t not_run = 0;
  for (const ScenarioRow& row : rows) {
    if (row.result.outcome == Outcome::not_run) {
      ++not_run;
    } else {
      ++counts[static_cast<std::size_t>(row.result.outcome)];
    }
  }
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    text += joined({text.empty() ? "" : ", ", kOutcomeWords[i], " ", with_thousands(counts[i])});
  }
  if (not_run > 0) text += joined({text.empty() ? "" : ", ", "not run ", with_thousands(not_run)});
  return joined({"outcomes: ", text.empty() ? "none" : text});
}

std::string balance_line(const std::vector<ScenarioRow>& rows) {
  const ScenarioRow* impulse = nullptr;
  const ScenarioRow* energy = nullptr;
  const auto impulse_of = [](const ScenarioRow& row) {
    return std::abs(row.result.metrics[Metric::impulse_balance_error]);
  };
  const auto energy_of = [](const ScenarioRow& row) { return row.result.metrics[Metric::energy_balance_error]; };
  for (const ScenarioRow& row : rows) {
    if (!std::isnan(impulse_of(row)) && (impulse == nullptr || impulse_of(row) > impulse_of(*impulse)))
      impulse = &row;
    if (!std::isnan(energy_of(row)) && (energy == nullptr || energy_of(row) > energy_of(*energy))) energy = &row;
  }
  std::string text;
  if (impulse != nullptr) {
    text += joined({"|impulse_balance_error| <= ", short_number(impulse_of(*impulse)), " (scenario ",
                    std::to_string(impulse->id), ")"});
  }
  if (energy != nullptr) {
    text += joined({text.empty() ? "" : ", ", "energy_balance_error <= ", short_number(energy_of(*energy)),
                    " (scenario ", std::to_string(energy->id), ")"});
  }
  return text.empty() ? text : joined({"worst balances: ", text});
}

std::vector<std::string> window_lines(const WindowTable& window, std::size_t most_lines) {
  std::vector<const WindowRow*> order;
  for (const WindowRow& row : window.rows) order.push_back(&row);
  const bool all = order.size() <= most_lines;
  if (!all) std::stable_partition(order.begin(), order.end(), [](const WindowRow* row) { return !row->exists; });
  order.resize(std::min(order.size(), most_lines));
  std::vector<std::string> lines;
  for (const WindowRow* row : order) lines.push_back(combination_line(window, *row));
  if (!all) {
    lines.push_back(joined({"... and ", std::to_string(window.rows.size() - order.size()), " more in /window"}));
  }
  if (window.rows.size() > 1) {
    for (std::string& line : common_lines(window)) lines.push_back(std::move(line));
  }
  return lines;
}

const ScenarioRow* best_row(const std::vector<ScenarioRow>& rows) {
  const ScenarioRow* best = nullptr;
  for (const ScenarioRow& row : rows) {
    if (row.result.outcome != Outcome::held || std::isnan(row.result.metrics[Metric::cycle_time_s])) continue;
    if (best == nullptr || is_better(row, *best)) best = &row;
  }
  return best;
}

std::string best_line(const StudyTables& tables) {
  const ScenarioRow* best = best_row(tables.rows);
  if (best == nullptr) return "best: none; no scenario was held without damage";
  const Metrics& metrics = best->result.metrics;
  const std::string inputs = inputs_text(tables.inputs, best->inputs);
  std::string text = joined({"best: scenario ", std::to_string(best->id),
                             ", cycle_time_s = ", short_number(metrics[Metric::cycle_time_s])});
  if (!std::isnan(metrics[Metric::friction_margin_min])) {
    text += joined({", friction_margin_min = ", short_number(metrics[Metric::friction_margin_min])});
  }
  if (!inputs.empty()) text += joined({" with ", inputs});
  return text;
}

std::vector<std::string> summary_lines(const StudyTables& tables, std::string_view study_kind) {
  const std::size_t most = study_kind == "sweep" ? kCombinationLinesOfSweep : kCombinationLinesOfSearch;
  std::vector<std::string> lines = {outcome_line(tables.rows)};
  if (std::string balances = balance_line(tables.rows); !balances.empty()) lines.push_back(std::move(balances));
  if (tables.window) {
    for (std::string& line : window_lines(*tables.window, most)) lines.push_back(std::move(line));
  }
  const bool has_cycles = std::any_of(tables.rows.begin(), tables.rows.end(), [](const ScenarioRow& row) {
    return !std::isnan(row.result.metrics[Metric::cycle_time_s]);
  });
  for (std::string& line : found_lines(tables.found)) lines.push_back(std::move(line));
  if (!tables.found.empty()) return lines;
  if (study_kind == "simulate" || study_kind == "sweep" || study_kind == "window") {
    if (has_cycles) lines.push_back(best_line(tables));
  } else {
    // The fastest of the scenarios so far is no answer to what these kinds ask.
    lines.push_back(joined({"answer: none yet; a study of kind ", study_kind, " has it at its end"}));
  }
  return lines;
}

std::vector<std::string> replay_lines(const StudyTables& tables, const std::string& replay_command) {
  std::vector<const ScenarioRow*> not_held;
  for (const ScenarioRow& row : tables.rows) {
    if (row.result.outcome != Outcome::held && row.result.outcome != Outcome::not_run) not_held.push_back(&row);
  }
  std::stable_sort(not_held.begin(), not_held.end(), [](const ScenarioRow* a, const ScenarioRow* b) {
    return seriousness(a->result.outcome) < seriousness(b->result.outcome);
  });
  std::vector<std::string> lines;
  if (not_held.empty()) return lines;
  lines.push_back(joined({"not held: ", with_thousands(not_held.size()), "; to look into one of them:"}));
  Outcome last_shown = Outcome::not_run;
  for (const ScenarioRow* each : not_held) {
    const ScenarioRow& row = *each;
    if (row.result.outcome == std::exchange(last_shown, row.result.outcome)) continue;
    lines.push_back(
        joined({"  ", replay_command, " ", std::to_string(row.id), "   # ", outcome_word(row.result.outcome),
                row.result.cause.empty() ? "" : ": ", row.result.cause}));
  }
  return lines;
}

std::string rows_digest(const std::vector<ScenarioRow>& rows) {
  std::vector<std::uint64_t> digests;
  digests.reserve(rows.size());
  for (const ScenarioRow& row : rows) digests.push_back(result_digest(row.result));
  return digest_text(digest_of_digests(digests));
}

}  // namespace unbruised::studies
