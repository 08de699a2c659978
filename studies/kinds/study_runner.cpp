#include "studies/kinds/study_runner.hpp"

#include <chrono>
#include <exception>
#include <utility>

#include "studies/execution/periodic_task.hpp"
#include "studies/findings/balances.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/kinds/study_results.hpp"
#include "studies/results/digest.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

class StudyRun {
 public:
  StudyRun(const Study& study, RunDirectory& run, const Executor& executor, const StudyRunOptions& options)
      : study_(study), run_(run), executor_(executor), options_(options), journal_(run, options.progress) {}

  Expected<StudyReport> execute() {
    const auto start = std::chrono::steady_clock::now();
    log_warnings(options_.warnings);
    try {
      const PeriodicTask compaction(options_.compaction_interval, [this] { compact(); });
      run_kind();
    } catch (const JournalFailure& failure) {
      return failure.error;
    }
    try {
      if (auto error = write_results()) return *error;
      report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      log_end();
    } catch (const RowsFailure& failure) {
      return failure.error;
    }
    return std::move(report_);
  }

 private:
  void run_kind() {
    answer_ = runner_of(study_.kind())
                  .run({.study = study_,
                        .executor = executor_,
                        .journal = journal_,
                        .stop = options_.stop,
                        .concurrent_searches = options_.concurrent_searches});
    report_.interrupted = answer_.interrupted;
    report_.run_now = journal_.recorded_now();
    report_.lane_use = answer_.lane_use;
    report_.from_memory = answer_.from_memory;
    report_.search_seconds = answer_.search_seconds;
    report_.warnings = std::move(answer_.warnings);
    report_.tables.found = std::move(answer_.found);
    report_.tables.window = std::move(answer_.window);
  }

  // results.h5 as far as the study is. A failure is no reason to stop: the journal is what counts.
  void compact() {
    try {
      if (auto error = run_.finish(unfinished_content(study_, run_, options_.warnings))) run_.log(error->message);
    } catch (const std::exception& failure) {  // no memory for another copy of the rows
      run_.log(failure.what());
    }
  }

  /// The answer as a strategy file; without one, that of an earlier run goes.
  MaybeError write_strategy() {
    if (!answer_.strategy) return run_.remove_strategy();
    const std::string toml = strategy_toml(study_, *answer_.strategy, rows_digest(report_.tables.rows));
    add_strategy(report_.tables.found, *answer_.strategy, toml);
    return run_.write_strategy(toml);
  }

  /// The product file of a calibration.
  MaybeError write_product() {
    if (!answer_.product || answer_.product->empty()) return run_.remove_product();
    return run_.write_product(*answer_.product);
  }

  /// What the rows say against the answer.
  void doubt_rows() {
    const StudyRows& rows = report_.tables.rows;
    for (std::string doubt : {balance_doubt(rows), impact_doubt(rows)}) {
      if (!doubt.empty()) report_.warnings.push_back(std::move(doubt));
    }
  }

  MaybeError write_results() {
    const StudyRows rows = run_.rows(row_places(study_.kind()));
    report_.tables.rows = rows.size() <= kRowsAtATime ? StudyRows(rows.held()) : rows;
    doubt_rows();
    if (auto error = write_strategy()) return error;
    if (auto error = write_product()) return error;
    ResultsContent content = unfinished_content(study_, run_, all_warnings());
    content.meta.complete = !report_.interrupted;
    const std::string damage_note = content.meta.damage_note;
    content.tables = report_.tables.found;
    content.window = report_.tables.window ? &*report_.tables.window : nullptr;
    content.trace = answer_.trace ? &*answer_.trace : nullptr;
    if (auto error = run_.finish(std::move(content))) return error;
    report_.tables.inputs = input_columns(study_);
    report_.tables.damage_note = damage_note;
    return {};
  }

  /// Those from before the run, then those of the run.
  [[nodiscard]] std::vector<std::string> all_warnings() const {
    std::vector<std::string> all = options_.warnings;
    all.insert(all.end(), report_.warnings.begin(), report_.warnings.end());
    return all;
  }

  void log_warnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) run_.log(joined({"warning: ", warning}));
  }

  void log_end() {
    log_warnings(report_.warnings);
    run_.log(
        joined({report_.interrupted ? "interrupted" : "finished", " after ", duration_text(report_.seconds), ": ",
                std::to_string(report_.run_now), " scenarios run, ", outcome_line(report_.tables.rows)}));
  }

  const Study& study_;
  RunDirectory& run_;
  const Executor& executor_;
  const StudyRunOptions& options_;
  RunJournal journal_;
  KindAnswer answer_;
  StudyReport report_;
};

}  // namespace

Expected<StudyReport> run_study(const Study& study, RunDirectory& run, const Executor& executor,
                                const StudyRunOptions& options) {
  return StudyRun(study, run, executor, options).execute();
}

}  // namespace unbruised::studies
