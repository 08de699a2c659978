#pragma once

/// @file
/// The tables a study leaves behind, as plain data: scenario rows, the window table, what the root of
/// results.h5 says. Both sides of the file (writer and reader) speak these types.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/outcome/trace.hpp"

namespace unbruised::studies {

inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// The value of a varied key: a number, or a text such as a product file.
using InputValue = std::variant<double, std::string>;

/// A varied key. Its column holds texts as soon as one of its values is a text.
struct ColumnInfo {
  std::string key;        ///< dotted, e.g. "strategy.grip_force_N"
  std::string units;      ///< UDUNITS spelling; may stay empty
  std::string long_name;  ///< may stay empty
};

/// Which question of a search a scenario answered; of a window study which force of which round at which
/// combination. Its numbers depend on the study alone, never on when it was asked.
struct SearchPlace {
  std::uint64_t search = 0;      ///< < 2^23; of a window study the round
  std::uint64_t generation = 0;  ///< < 2^24; questions asked together belong to one; the combination
  std::uint64_t index = 0;       ///< < 2^16; inside the generation; of the force in its round and combination
  friend bool operator==(const SearchPlace&, const SearchPlace&) = default;
};
inline constexpr std::uint64_t kGenerationsMost = 1ULL << 24U;
inline constexpr std::uint64_t kIndicesMost = 1ULL << 16U;

/// The place as one number that sorts as (search, generation, index): the id of its row in the journal.
constexpr std::uint64_t journal_id(const SearchPlace& place) {
  return (place.search << 40U) | (place.generation << 16U) | place.index;
}
constexpr SearchPlace search_place(std::uint64_t journal_id) {
  return {journal_id >> 40U, (journal_id >> 16U) & (kGenerationsMost - 1), journal_id & (kIndicesMost - 1)};
}

/// One scenario of a study.
struct ScenarioRow {
  std::uint64_t id = 0;  ///< in the study's order; of rows with a place in the journal: journal_id of the place
  ScenarioResult result;
  std::vector<InputValue> inputs;      ///< as long as, and in the order of, the study's input columns
  std::optional<SearchPlace> place{};  ///< of what was asked for, once the rows are numbered
};

/// What the ids of rows in the journal are.
enum class RowPlaces {
  none,       ///< those of the study
  questions,  ///< places of a search's questions
  forces,     ///< places of a window study's forces
};

/// Numbers rows with places, sorted by their journal ids, 0, 1, 2 ...; their places stay known.
void number_placed_rows(std::vector<ScenarioRow>& rows);
/// The row's id in the journal.
std::uint64_t journal_id(const ScenarioRow& row);

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

/// Everything that goes into one results.h5 (or scenario_<id>.h5). Rows are sorted by id when written.
struct ResultsContent {
  ResultsMeta meta;
  std::vector<ColumnInfo> inputs;
  std::vector<ScenarioRow> rows;
  RowPlaces places = RowPlaces::none;   ///< rows with places are numbered when written
  std::vector<ResultTable> tables;      ///< one group each
  const WindowTable* window = nullptr;  ///< no /window group when null
  const Trace* trace = nullptr;         ///< no /trace and /contact_events when null
};

}  // namespace unbruised::studies
