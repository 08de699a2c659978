#include "studies/kinds/study_runner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <exception>
#include <unordered_map>
#include <utility>

#include "studies/execution/batch_runner.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/evaluation_broker.hpp"
#include "studies/execution/periodic_task.hpp"
#include "studies/findings/balances.hpp"
#include "studies/findings/check_warnings.hpp"
#include "studies/findings/claims.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/kinds/search_study.hpp"
#include "studies/kinds/study_answer.hpp"
#include "studies/kinds/window_run.hpp"
#include "studies/results/digest.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32] = "";
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text, length};
}

/// Carries a failure of the journal out of the batch runner.
struct JournalFailure {
  ResultsError error;
};

class StudyRun {
 public:
  StudyRun(const Study& study, RunDirectory& run, const Simulator& simulator, const StudyRunOptions& options)
      : study_(study), run_(run), simulator_(simulator), options_(options), set_(scenario_set(study)) {}

  Expected<StudyReport> execute() {
    const auto start = std::chrono::steady_clock::now();
    log_warnings(options_.warnings);
    try {
      const PeriodicTask compaction(options_.compaction_interval, [this] { compact(); });
      run_kind();
    } catch (const JournalFailure& failure) {
      return failure.error;
    }
    if (auto error = write_results()) return *error;
    report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    log_end();
    return std::move(report_);
  }

 private:
  void run_kind() {
    if (study_.kind() == StudyKind::window) return run_window();
    if (is_search(study_.kind())) return run_search();
    if (study_.kind() == StudyKind::simulate && study_.scenario_count() == 1) return run_traced();
    run_set();
  }

  // simulate: one scenario with its trace. The trace is not in the journal, so a resumed run makes it again.
  void run_traced() {
    expect(1, run_.is_done(0) ? 1 : 0);
    std::optional<ScenarioResult> result = run_alone(simulator_, study_.scenario(0), &trace_, options_.stop);
    if (!result) {
      report_.interrupted = true;
    } else if (!run_.is_done(0)) {
      record({.id = 0, .result = std::move(*result), .inputs = grid_inputs(study_, 0)});
    }
    has_trace_ = !report_.interrupted;
  }

  // sweep, sample, compare, sensitivity: every scenario that is not done yet.
  void run_set() {
    Batch batch;
    for (std::uint64_t id = 0; id < set_.count; ++id) {
      if (!run_.is_done(id)) batch.ids.push_back(id);
    }
    batch.scenario = set_.scenario;
    expect(set_.count, set_.count - batch.ids.size());
    const BatchReport done =
        run_batch(simulator_, batch, batch_options(), [this](std::uint64_t id, const ScenarioResult& result) {
          record({.id = id, .result = result, .inputs = set_.inputs(id)});
        });
    report_.lane_use = done.lane_use;
    report_.interrupted = done.stopped;
    if (!report_.interrupted) look_at_set(run_.rows());
  }

  void look_at_set(const std::vector<ScenarioRow>& rows) {
    switch (study_.kind()) {
      case StudyKind::sweep:
        if (std::optional<StudyWindow> window = window_of_sweep(study_, rows)) {
          const WindowAnswer answer = answer_of(study_, *window, input_columns(study_), rows);
          return keep(std::move(*window), answer);
        }
        return keep(grid_answer(input_columns(study_), rows));
      case StudyKind::sample:
        report_.tables.found = sample_tables(study_, rows);
        return;
      case StudyKind::compare:
        report_.tables.found = compare_tables(study_, rows);
        strategy_ = compare_strategy(study_, report_.tables.found);
        return;
      case StudyKind::sensitivity:
        report_.tables.found = sensitivity_tables(study_, rows);
        return;
      default:
        return;
    }
  }

  // optimize, robust, pareto: searches that ask one broker; recorded answers are not computed again.
  void run_search() {
    if (options_.progress != nullptr) options_.progress->total_may_grow();
    const std::vector<ScenarioRow> recorded = run_.rows();
    expect(evaluations_at_most(study_), recorded.size());
    const StrategyJudge judge(study_);
    EvaluationBroker broker(
        simulator_, recorded, [this](const ScenarioRow& row, bool) { record(row); },
        {.threads = options_.threads, .stop = options_.stop, .concurrent_searches = options_.concurrent_searches});
    SearchFindings found;
    try {
      found = run_searches(judge, broker);
    } catch (const EvaluationBroker::ForeignRecord& foreign) {
      throw foreign_record(journal_id(foreign.place));
    }
    report_.interrupted = found.interrupted;
    report_.lane_use = found.searching;
    report_.search_seconds = found.search_seconds;
    report_.from_memory = broker.counts().from_memory;
    std::vector<ScenarioRow> rows = run_.rows();
    number_search_rows(rows);
    report_.tables.found = search_tables(judge, found, rows);
    if (!found.interrupted) strategy_ = search_strategy(study_, found);
    report_.warnings = check_warnings(report_.tables.found);
  }

  // window: rounds of evaluations, each answered from the journal where it can be.
  void run_window() {
    if (options_.progress != nullptr) options_.progress->total_may_grow();
    for (const ScenarioRow& row : run_.rows()) recorded_.emplace(row.id, row);
    std::optional<WindowRun> found =
        run_window_study(study_, factor_groups(), input_columns(study_),
                         [this](const std::vector<ForceRequest>& requests) { return answer(requests); });
    report_.interrupted = !found;
    if (!found) return;
    report_.warnings = std::move(found->warnings);
    keep(std::move(found->window), found->answer);
  }

  void keep(StudyWindow window, const WindowAnswer& answer) {
    report_.tables.found = {set_points_table(answer)};
    strategy_ = window_strategy(study_, window, answer);
    report_.tables.window = std::move(window.table);
  }

  void keep(GridAnswer answer) {
    strategy_ = grid_strategy(study_, answer);
    report_.tables.found = {std::move(answer.table)};
  }

  std::vector<std::size_t> factor_groups() const {
    std::vector<std::size_t> group_of;
    std::unordered_map<std::string, std::size_t> index_of;
    for (std::size_t point = 0; point < study_.scenario_count(); ++point) {
      const std::string key = simulator_.factor_key(study_.scenario(point));
      group_of.push_back(index_of.try_emplace(key, index_of.size()).first->second);
    }
    return group_of;
  }

  std::optional<std::vector<ScenarioRow>> answer(const std::vector<ForceRequest>& requests) {
    const std::uint64_t first_id = requests.front().id;
    const auto request_of = [&](std::uint64_t id) -> const ForceRequest& { return requests[id - first_id]; };
    Batch batch;
    for (const ForceRequest& request : requests) {
      if (!is_recorded(request)) batch.ids.push_back(request.id);
    }
    batch.scenario = [&](std::uint64_t id) {
      return window_scenario(study_, request_of(id).combination, request_of(id).grip_force_N, request_of(id).step);
    };
    expect(requests.size(), requests.size() - batch.ids.size());
    const BatchReport done =
        run_batch(simulator_, batch, batch_options(), [&](std::uint64_t id, const ScenarioResult& result) {
          ScenarioRow row{.id = id, .result = result, .inputs = window_inputs(study_, request_of(id))};
          record(row);
          recorded_.insert_or_assign(id, std::move(row));
        });
    if (done.stopped) return std::nullopt;
    std::vector<ScenarioRow> answers;
    for (const ForceRequest& request : requests) answers.push_back(recorded_.at(request.id));
    return answers;
  }

  bool is_recorded(const ForceRequest& request) const {
    const auto found = recorded_.find(request.id);
    if (found == recorded_.end()) return false;
    if (found->second.inputs != window_inputs(study_, request)) {
      throw foreign_record(request.id);
    }
    return true;
  }

  [[nodiscard]] JournalFailure foreign_record(std::uint64_t id) const {
    return {{ResultsErrorKind::damaged,
             joined({"evaluation ", std::to_string(id), " in the journal of ", run_.directory().string(),
                     " is another one than this search asks for: it was written by another build or "
                     "is damaged. Use --fresh to move it aside and start anew"}),
             {}}};
  }

  StudyWindow window_table(const std::vector<WindowRow>& found) const {
    StudyWindow window;
    window.table.inputs = scenario_set(study_).columns;
    window.table.rows = found;
    for (std::size_t point = 0; point < found.size(); ++point) {
      window.table.rows[point].inputs = grid_inputs(study_, point);
      window.points.push_back(point);
    }
    return window;
  }

  void record(const ScenarioRow& row) {
    if (auto error = run_.append(row)) throw JournalFailure{*error};
    ++report_.run_now;
    if (options_.progress != nullptr)
      options_.progress->count(row.result.outcome, row.result.metrics[Metric::step_count]);
    if (row.result.outcome == Outcome::diverged) {
      run_.log(joined({"scenario ", std::to_string(row.id), " diverged: ", row.result.cause}));
    }
  }

  void expect(std::size_t count, std::size_t already_done) {
    if (options_.progress != nullptr) options_.progress->expect(count, already_done);
  }

  BatchOptions batch_options() const { return {.threads = options_.threads, .stop = options_.stop}; }

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
    if (!strategy_) return run_.remove_strategy();
    const std::string toml = strategy_toml(study_, *strategy_, rows_digest(run_.rows()));
    add_strategy(report_.tables.found, *strategy_, toml);
    return run_.write_strategy(toml);
  }

  /// What the rows say against the answer.
  void doubt_rows() {
    std::vector<ScenarioRow> rows = run_.rows();
    if (is_search(study_.kind())) number_search_rows(rows);
    if (std::string doubt = balance_doubt(rows); !doubt.empty()) report_.warnings.push_back(std::move(doubt));
  }

  MaybeError write_results() {
    doubt_rows();
    if (auto error = write_strategy()) return error;
    ResultsContent content = unfinished_content(study_, run_, all_warnings());
    content.meta.complete = !report_.interrupted;
    const std::string damage_note = content.meta.damage_note;
    content.tables = report_.tables.found;
    content.window = report_.tables.window ? &*report_.tables.window : nullptr;
    content.trace = has_trace_ ? &trace_ : nullptr;
    if (auto error = run_.finish(std::move(content))) return error;
    report_.tables.inputs = input_columns(study_);
    report_.tables.damage_note = damage_note;
    report_.tables.rows = run_.rows();
    if (is_search(study_.kind())) number_search_rows(report_.tables.rows);
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
  const Simulator& simulator_;
  const StudyRunOptions& options_;
  const ScenarioSet set_;
  std::unordered_map<std::uint64_t, ScenarioRow> recorded_;
  Trace trace_;
  bool has_trace_ = false;
  std::optional<AnsweredStrategy> strategy_;
  StudyReport report_;
};

}  // namespace

Expected<StudyReport> run_study(const Study& study, RunDirectory& run, const Simulator& simulator,
                                const StudyRunOptions& options) {
  return StudyRun(study, run, simulator, options).execute();
}

ResultsContent unfinished_content(const Study& study, const RunDirectory& run, std::vector<std::string> warnings) {
  ResultsContent content;
  content.meta = results_meta(study, std::move(warnings), ResultsState::unfinished);
  content.inputs = input_columns(study);
  content.rows_of_search = is_search(study.kind());
  if (!has_fixed_scenarios(study.kind())) return content;
  const ScenarioSet set = scenario_set(study);
  for (std::uint64_t id = 0; id < set.count; ++id) {
    if (!run.is_done(id)) content.rows.push_back({.id = id, .result = {}, .inputs = set.inputs(id)});
  }
  return content;
}

ResultsMeta results_meta(const Study& study, std::vector<std::string> warnings, ResultsState state) {
  ResultsMeta meta;
  meta.unbruised_version = program_version();
  meta.config_toml = study.resolved_toml();
  meta.study_name = study.name();
  meta.study_kind = study_kind_word(study.kind());
  meta.created_utc = utc_now();
  meta.instruction_set = instruction_set();
  meta.compiler = compiler_and_libraries();
  meta.complete = state == ResultsState::complete;
  meta.warnings = std::move(warnings);
  set_damage(meta, study);
  return meta;
}

bool has_fixed_scenarios(StudyKind kind) { return kind != StudyKind::window && !is_search(kind); }

std::vector<ColumnInfo> input_columns(const Study& study) {
  if (is_search(study.kind())) return search_columns(study);
  std::vector<ColumnInfo> columns = scenario_set(study).columns;
  if (study.kind() == StudyKind::window) add_window_columns(study, columns);
  return columns;
}

std::optional<Scenario> scenario_of_row(const Study& study, const ScenarioRow& row) {
  if (has_fixed_scenarios(study.kind())) {
    const ScenarioSet set = scenario_set(study);
    if (row.id >= set.count) return std::nullopt;
    return set.scenario(row.id);
  }
  if (is_search(study.kind())) return scenario_of_search_inputs(study, row.inputs);
  return scenario_of_window_inputs(study, row.inputs);
}

}  // namespace unbruised::studies
