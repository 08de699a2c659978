#pragma once

/// @file
/// Runs a study on its run directory: only what the journal does not hold yet, every row into the journal as it
/// comes, results.h5 at the end.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/execution/executor.hpp"
#include "studies/execution/progress.hpp"
#include "studies/findings/summary.hpp"
#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"
#include "studies/results/run_directory.hpp"

namespace unbruised::studies {

struct StudyRunOptions {
  const std::atomic<bool>* stop = nullptr;  ///< may be null
  Progress* progress = nullptr;             ///< may be null
  /// > 0; searches that run at the same time (one: one after the other, for benchmarks; the same results)
  std::size_t concurrent_searches = 256;
  /// > 0; how often results.h5 is brought up to date while the study runs
  std::chrono::milliseconds compaction_interval = std::chrono::minutes(10);
  /// What was said before the run; goes into the log and results.h5.
  std::vector<std::string> warnings = {};
};

struct StudyReport {
  StudyTables tables;
  /// What the run found that its answer may be wrong by; in the log and in results.h5, behind those of the
  /// options.
  std::vector<std::string> warnings;
  bool interrupted = false;
  double seconds = 0.0;
  std::size_t run_now = 0;      ///< scenarios that were not in the journal
  LaneUse lane_use;             ///< how full the lanes were; of a search: while it searched
  std::size_t from_memory = 0;  ///< questions of a search that had been asked before
  double search_seconds = 0.0;  ///< of a search, until its answer was there and before it was checked
};

/// Runs what is left of a study and writes results.h5, also when interrupted (complete = 0).
/// Errors: those of the run directory; damaged when a recorded evaluation of a search does not belong to it.
Expected<StudyReport> run_study(const Study& study, RunDirectory& run, const Executor& executor,
                                const StudyRunOptions& options);

}  // namespace unbruised::studies
