#include "studies/findings/summary.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "studies/config/study_kind.hpp"
#include "studies/findings/balances.hpp"
#include "studies/findings/claims.hpp"
#include "studies/findings/contact_table.hpp"
#include "studies/findings/found_lines.hpp"
#include "studies/findings/sizing.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/findings/window_lines.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/outcome_counts.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kCombinationLinesOfGrid = 12;
constexpr std::size_t kCombinationLinesOfSearch = 200;

std::string input_text(const InputValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? short_number(*number) : std::get<std::string>(value);
}

bool is_better(const ScenarioRow& a, const ScenarioRow& b) {
  const double time_a = a.result.metrics[Metric::cycle_time_s];
  const double time_b = b.result.metrics[Metric::cycle_time_s];
  if (time_a != time_b) return time_a < time_b;
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
    case Outcome::misplaced:
      return 6;
    default:
      return 7;
  }
}

std::string best_line(const StudyTables& tables) {
  const ScenarioRow* best = best_row(tables.rows);
  if (best == nullptr) return joined({"best: none; no scenario was ", held_words(tables.damage_note)});
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

}  // namespace

std::string key_leaf(const std::string& key) {
  // `use` says nothing without its table.
  if (key.ends_with(".use")) return key;
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

std::vector<std::string> input_texts(const std::vector<ColumnInfo>& columns,
                                     const std::vector<InputValue>& inputs) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < columns.size() && i < inputs.size(); ++i) {
    texts.push_back(joined({key_leaf(columns[i].key), " = ", input_text(inputs[i])}));
  }
  return texts;
}

std::string inputs_text(const std::vector<ColumnInfo>& columns, const std::vector<InputValue>& inputs) {
  return comma_list(input_texts(columns, inputs));
}

std::string outcome_line(const std::vector<ScenarioRow>& rows) {
  const std::string text = counts_text(outcome_counts(rows));
  return joined({"outcomes: ", text.empty() ? "none" : text});
}

const ScenarioRow* best_row(const std::vector<ScenarioRow>& rows) {
  const ScenarioRow* best = nullptr;
  for (const ScenarioRow& row : rows) {
    if (row.result.outcome != Outcome::held || std::isnan(row.result.metrics[Metric::cycle_time_s])) continue;
    if (best == nullptr || is_better(row, *best)) best = &row;
  }
  return best;
}

std::vector<std::string> summary_lines(const StudyTables& tables, std::string_view study_kind) {
  const std::optional<StudyKind> kind = study_kind_named(study_kind);
  const bool has_searched_ends = kind && searches_force(*kind);
  const std::size_t most = has_searched_ends ? kCombinationLinesOfSearch : kCombinationLinesOfGrid;
  std::vector<std::string> lines = {outcome_line(tables.rows)};
  if (!tables.damage_note.empty()) lines.push_back(tables.damage_note);
  if (std::string balances = balance_line(tables.rows); !balances.empty()) lines.push_back(std::move(balances));
  if (tables.window) {
    const ResultTable* set_points = find_table(tables.found, "set_points");
    for (std::string& line : window_lines(*tables.window, set_points, most)) lines.push_back(std::move(line));
  }
  const bool has_cycles = std::any_of(tables.rows.begin(), tables.rows.end(), [](const ScenarioRow& row) {
    return !std::isnan(row.result.metrics[Metric::cycle_time_s]);
  });
  for (std::string& line : found_lines(tables.found, held_words(tables.damage_note)))
    lines.push_back(std::move(line));
  for (std::string& line : sizing_lines(tables.found)) lines.push_back(std::move(line));
  for (std::string& line : contact_lines(tables.found)) lines.push_back(std::move(line));
  const bool has_answer = std::any_of(tables.found.begin(), tables.found.end(),
                                      [](const ResultTable& table) { return table.name != kContactTable; });
  if (has_answer) return lines;
  if (kind && leaves_trace(*kind)) {
    if (has_cycles) lines.push_back(best_line(tables));
  } else {
    // The fastest of the scenarios so far is no answer to what these kinds ask.
    lines.push_back(joined({"answer: none yet; a study of kind ", study_kind, " has it at its end"}));
  }
  return lines;
}

std::string answer_line(const StudyTables& tables, std::string_view study_kind) {
  const std::string counts = outcome_line(tables.rows), balances = balance_line(tables.rows);
  for (std::string& line : summary_lines(tables, study_kind)) {
    if (line != counts && line != balances && line != tables.damage_note) return std::move(line);
  }
  return counts;
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
