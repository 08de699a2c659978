#pragma once

/// @file
/// What a study found, in lines for people: the same from `run` (rows in hand) and from `info` (a results file).

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// A study's tables, as far as it got.
struct StudyTables {
  std::vector<ColumnInfo> inputs;
  StudyRows rows;  ///< by id; those not run yet may be there as not_run
  std::optional<WindowTable> window;
  std::vector<ResultTable> found;  ///< what the study kind found beside (docs/results.md)
  std::string damage_note{};       ///< why nothing may be said about damage (claims.hpp); empty: it is judged
};

/// The last part of a dotted key: "grip_force_N".
std::string key_leaf(const std::string& key);
/// "approach_speed_m_s = 0.25" and so on, one per input.
std::vector<std::string> input_texts(const std::vector<ColumnInfo>& columns,
                                     const std::vector<InputValue>& inputs);
/// "approach_speed_m_s = 0.25, friction = 0.5"; empty without inputs.
std::string inputs_text(const std::vector<ColumnInfo>& columns, const std::vector<InputValue>& inputs);

/// "outcomes: held 512, slipped 300"
std::string outcome_line(const StudyRows& rows);
/// The held row with the shortest cycle, then the least id (the largest margin against slip is the hardest grip,
/// next to damage: no reason to choose it); nothing: none.
std::optional<ScenarioRow> best_row(const StudyRows& rows);

/// All of the above in order. @param study_kind the word of a kind: one that searches forces shows all
/// combinations it can, a grid few.
std::vector<std::string> summary_lines(const StudyTables& tables, std::string_view study_kind);
/// What it found, in one of these lines: without counts, remarks and balances.
std::string answer_line(const StudyTables& tables, std::string_view study_kind);
/// The first row of each outcome that is not held, most serious first, with its cause and the command that replays
/// it.
/// @param replay_command without the id, e.g. "unbruised run study.toml --scenario".
std::vector<std::string> replay_lines(const StudyTables& tables, const std::string& replay_command);

/// The digest of digests of the rows in id order, 16 hex digits.
std::string rows_digest(const StudyRows& rows);

}  // namespace unbruised::studies
