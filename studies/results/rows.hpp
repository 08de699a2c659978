#pragma once

/// @file
/// The tables a study leaves behind, as plain data: scenario rows, the window table, what the root of
/// results.h5 says. Both sides of the file (writer and reader) speak these types.

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/results/scenario_row.hpp"
#include "studies/results/study_rows.hpp"

namespace unbruised::studies {

/// One line of the window table: F_hold and F_damage at one combination of the other varied keys.
struct WindowRow {
  std::vector<InputValue> inputs;  ///< in the order of WindowTable::inputs
  double hold_force_N = kAbsent;   ///< NaN where it lies outside the searched range
  double damage_force_N = kAbsent;
  bool exists = false;                        ///< some force holds the product and leaves it unmarked
  double margin = kAbsent;                    ///< damage_force_N / hold_force_N - 1
  double hold_bracket_low_N = kAbsent;        ///< greatest force known not to hold
  double hold_bracket_high_N = kAbsent;       ///< least force known to hold
  double damage_bracket_low_N = kAbsent;      ///< greatest force known not to damage
  double damage_bracket_high_N = kAbsent;     ///< least force known to damage
  std::string note{};                         ///< e.g. "no window at this speed: the impact alone damages"
  std::string intervals{};                    ///< all forces that hold unmarked, "[0.98, 1.09], [1.4, 2]" N
  double hold_force_half_step_N = kAbsent;    ///< at half the time step; NaN where that was not looked at
  double damage_force_half_step_N = kAbsent;  ///< at half the time step; NaN where that was not looked at
  bool hold_on_impact = false;    ///< a run at that end has an impact that the step does not resolve; not kept
  bool damage_on_impact = false;  ///< likewise
  bool set_point_exists = false;
  double set_point_N = kAbsent;            ///< findings/set_point.hpp; NaN where there is none
  double set_point_tolerance_N = kAbsent;  ///< the setting may be off by it either way
  std::string set_point_note{};            ///< "set 2.4 N, may be off ...", or why there is none
};

/// The window of every combination of the varied keys other than the grip force.
struct WindowTable {
  std::vector<ColumnInfo> inputs;
  std::vector<WindowRow> rows;
};

/// One column of a result table: numbers (NaN where there is none) or texts.
struct ResultColumn {
  std::string name;
  std::string units;      ///< UDUNITS spelling; may stay empty
  std::string long_name;  ///< may stay empty
  std::variant<std::vector<double>, std::vector<std::string>> values;
};

/// What a study kind found beside its scenarios, e.g. its best strategy or its Pareto front: `/<name>/<column>`.
struct ResultTable {
  std::string name;                   ///< "best", "searches", "evaluations", "pareto", ... (docs/results.md)
  std::string row;                    ///< what a row is: the name of the dimension, e.g. "search"
  std::vector<ResultColumn> columns;  ///< equally long
  std::vector<std::pair<std::string, std::variant<double, std::string>>> attributes;
};

/// What the root attributes of results.h5 say about the study.
struct ResultsMeta {
  std::string unbruised_version;
  std::string config_toml;    ///< the full resolved config
  std::string config_sha256;  ///< 64 hex digits; `sha256_hex(config_toml)` when left empty
  std::string study_name;
  std::string study_kind;
  std::string created_utc;      ///< ISO 8601, given by the caller
  std::string instruction_set;  ///< numeric build: e.g. "avx512f"
  std::string compiler;         ///< numeric build: e.g. "GNU 12.2.0"
  bool complete = true;         ///< false: interrupted; some rows are not_run
  /// Sentences that belong to the answer: what was not looked at, what it may be wrong by.
  std::vector<std::string> warnings{};
  /// May the answer speak of damage: "judged", "not considered" or "not looked at"; empty: an older file.
  std::string damage{};
  std::string damage_note{};  ///< the same as a sentence; empty where damage is judged in every scenario
};

/// Everything that goes into one results.h5 (or scenario_<id>.h5).
struct ResultsContent {
  ResultsMeta meta;
  std::vector<ColumnInfo> inputs;
  std::vector<ScenarioRow> rows;        ///< in whatever order
  StudyRows stored{};                   ///< instead of `rows`, where they stand elsewhere
  RowPlaces places = RowPlaces::none;   ///< rows with places are numbered when written
  std::vector<ResultTable> tables;      ///< one group each
  const WindowTable* window = nullptr;  ///< no /window group when null
  const Trace* trace = nullptr;         ///< no /trace and /contact_events when null
};

}  // namespace unbruised::studies
