#pragma once

/// @file
/// A run directory as the kinds see it: what is recorded already, and where results go as they come.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "studies/execution/progress.hpp"
#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"
#include "studies/results/run_directory.hpp"

namespace unbruised::studies {

/// Carries a failure of the journal out of whatever runs scenarios: to write, and to read rows again.
using JournalFailure = RowsFailure;

class RunJournal {
 public:
  /// @param progress may be null. Both must outlive it.
  RunJournal(RunDirectory& run, Progress* progress) : run_(run), progress_(progress) {}

  [[nodiscard]] bool is_done(std::uint64_t id) const { return run_.is_done(id); }
  [[nodiscard]] StudyRows rows() const { return run_.rows(); }
  [[nodiscard]] std::size_t row_count() const { return run_.row_count(); }
  /// Writes a row down; calls are serialised by the caller. Throws JournalFailure.
  void record(const ScenarioRow& row);
  /// Rows written down by this process.
  [[nodiscard]] std::size_t recorded_now() const { return recorded_now_; }

  /// So many scenarios more belong to the study, `already_done` of them are recorded.
  void expect(std::size_t count, std::size_t already_done);
  /// More may follow.
  void total_may_grow();

  /// What is thrown when a recorded evaluation is another one than the study asks for.
  [[nodiscard]] JournalFailure foreign_record(std::uint64_t id) const;

 private:
  RunDirectory& run_;
  Progress* progress_;
  std::size_t recorded_now_ = 0;
};

}  // namespace unbruised::studies
