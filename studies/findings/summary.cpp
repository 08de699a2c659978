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
#include "studies/results/outcome_counts.hpp"
#include "studies/results/row_summary.hpp"
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
  const std::optional<ScenarioRow>& best = tables.rows.seen().best;
  if (!best) return joined({"best: none; no scenario was ", held_words(tables.damage_note)});
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

std::string outcome_line(const StudyRows& rows) {
  const std::string text = counts_text(rows.seen().outcomes);
  return joined({"outcomes: ", text.empty() ? "none" : text});
}

std::optional<ScenarioRow> best_row(const StudyRows& rows) { return rows.seen().best; }

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
  for (std::string& line : found_lines(tables.found, held_words(tables.damage_note)))
    lines.push_back(std::move(line));
  for (std::string& line : sizing_lines(tables.found)) lines.push_back(std::move(line));
  for (std::string& line : contact_lines(tables.found)) lines.push_back(std::move(line));
  const bool has_answer = std::any_of(tables.found.begin(), tables.found.end(),
                                      [](const ResultTable& table) { return table.name != kContactTable; });
  if (has_answer) return lines;
  if (kind && leaves_trace(*kind)) {
    if (tables.rows.seen().has_cycles) lines.push_back(best_line(tables));
  } else {
    // The fastest of the scenarios so far is no answer to what these kinds ask.
    lines.push_back(joined({"answer: none yet; a study of kind ", study_kind, " has it at its end"}));
  }
  return lines;
}

std::string answer_line(const StudyTables& tables, std::string_view study_kind) {
  if (tables.rows.size() == 1 && !tables.window) {
    const ScenarioResult only = tables.rows.front().result;
    return joined({outcome_word(only.outcome), only.cause.empty() ? "" : ": ", only.cause});
  }
  const std::string counts = outcome_line(tables.rows), balances = balance_line(tables.rows);
  std::vector<std::string> lines = summary_lines(tables, study_kind);
  for (const std::string_view first : {"best: ", "set-point"}) {
    for (std::string& line : lines) {
      if (line.starts_with(first)) return std::move(line);
    }
  }
  for (std::string& line : lines) {
    if (line != counts && line != balances && line != tables.damage_note) return std::move(line);
  }
  return counts;
}

std::vector<std::string> replay_lines(const StudyTables& tables, const std::string& replay_command) {
  const RowSummary& seen = tables.rows.seen();
  std::vector<const ScenarioRow*> firsts;
  for (const auto& [outcome, row] : seen.first_of) firsts.push_back(&row);
  std::ranges::sort(firsts, {}, [](const ScenarioRow* row) { return seriousness(row->result.outcome); });
  std::vector<std::string> lines;
  if (firsts.empty()) return lines;
  const std::size_t held = seen.outcomes.of[static_cast<std::size_t>(Outcome::held)];
  const std::size_t not_held = tables.rows.size() - held - seen.outcomes.not_run;
  lines.push_back(joined({"not held: ", with_thousands(not_held), "; to look into one of them:"}));
  for (const ScenarioRow* row : firsts) {
    lines.push_back(
        joined({"  ", replay_command, " ", std::to_string(row->id), "   # ", outcome_word(row->result.outcome),
                row->result.cause.empty() ? "" : ": ", row->result.cause}));
  }
  return lines;
}

std::string rows_digest(const StudyRows& rows) { return rows.seen().digest; }

}  // namespace unbruised::studies
