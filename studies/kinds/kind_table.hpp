#pragma once

/// @file
/// How each study kind runs: one row each, in the order of config/study_kind.hpp. What a kind finds is described
/// by its tables (findings), which report and lines know by name.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/config/study.hpp"
#include "studies/execution/executor.hpp"
#include "studies/findings/strategy_file.hpp"
#include "studies/kinds/run_journal.hpp"
#include "studies/kinds/study_template.hpp"
#include "studies/results/rows.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {

/// What a kind runs with.
struct KindInput {
  const Study& study;
  const Executor& executor;
  RunJournal& journal;
  const std::atomic<bool>* stop = nullptr;  ///< may be null
  /// > 0; searches that run at the same time
  std::size_t concurrent_searches = 256;
};

/// What it leaves beside the rows in the journal.
struct KindAnswer {
  std::vector<ResultTable> found;
  std::optional<WindowTable> window;
  std::optional<AnsweredStrategy> strategy;  ///< for the robot, where the study has one
  std::optional<std::string> product;        ///< a product file that a calibration has made
  std::optional<Trace> trace;
  std::vector<std::string> warnings;  ///< what the answer may be wrong by
  bool interrupted = false;
  LaneUse lane_use;             ///< of a search: while it searched
  std::size_t from_memory = 0;  ///< questions of a search that had been asked before
  double search_seconds = 0.0;  ///< of a search, until its answer was there and before it was checked
};

/// What is known of the number of scenarios before they run.
enum class ScenarioCount { exact, about, at_most };

/// How many scenarios a study runs, and how many of them wait for the answers of others.
struct Evaluations {
  double each = 1.0;    ///< per known scenario
  double rounds = 1.0;  ///< that follow one another
};

/// A study in parts: each takes some of what `ScenarioFamily::known` numbers, whole.
struct StudyParts {
  const char* unit;  ///< what one of them is
  /// Runs what is left of these. Throws JournalFailure. @return false: interrupted
  bool (*run)(const KindInput& input, const std::vector<std::uint64_t>& units);
  /// Those of which the journal does not have all, ascending. Throws JournalFailure.
  std::vector<std::uint64_t> (*missing)(const Study& study, const RunJournal& journal);
};

/// The scenarios of kinds that get them in the same way.
struct ScenarioFamily {
  ScenarioCount count = ScenarioCount::exact;
  /// The input columns of the rows.
  std::vector<ColumnInfo> (*columns)(const Study& study);
  /// The scenario a row was made from; nothing when its inputs are none of the study's.
  std::optional<Scenario> (*scenario_of_row)(const Study& study, const ScenarioRow& row);
  /// Scenarios that are known before anything runs: all, one per combination, or some that are like the others.
  ScenarioSet (*known)(const Study& study);
  /// @param group_of the factor group of each known scenario
  Evaluations (*evaluations)(const Study& study, const std::vector<std::size_t>& group_of);
  RowPlaces places = RowPlaces::none;  ///< what the ids of its rows are in the journal
  const StudyParts* parts = nullptr;   ///< null: it has none
};

struct KindRow {
  StudyKind kind;
  /// Runs what is left of the study. Throws JournalFailure.
  KindAnswer (*run)(const KindInput& input);
  const ScenarioFamily* scenarios;
  /// What `unbruised new` writes behind product, gripper, cell and strategy.
  std::string (*template_part)(const TemplateNumbers& numbers);
};

std::span<const KindRow> kind_table();
const KindRow& runner_of(StudyKind kind);

/// Are all scenarios of the kind numbered beforehand?
bool has_fixed_scenarios(StudyKind kind);
/// What the ids of the kind's rows are in the journal.
RowPlaces row_places(StudyKind kind);
/// How the kind is run in parts; null: it is not.
const StudyParts* parts_of(StudyKind kind);
/// The input columns of a study's rows: varied keys, of a window study the grip force, of others what is searched
/// and drawn.
std::vector<ColumnInfo> input_columns(const Study& study);
/// The scenario a row of this study was made from; nothing when its inputs are none of the study's.
std::optional<Scenario> scenario_of_row(const Study& study, const ScenarioRow& row);

}  // namespace unbruised::studies
