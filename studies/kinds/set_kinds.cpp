#include "studies/kinds/set_kinds.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "studies/execution/batch_runner.hpp"
#include "studies/findings/contact_table.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/grid_answer.hpp"
#include "studies/kinds/set_half_step.hpp"
#include "studies/kinds/study_answer.hpp"
#include "studies/kinds/window_findings.hpp"

namespace unbruised::studies {
namespace {

/// Runs scenarios of the set, and records them.
BatchReport run_of_set(const KindInput& input, const ScenarioSet& set, std::vector<std::uint64_t> ids) {
  const Batch batch{.ids = std::move(ids), .scenario = set.scenario, .stop = input.stop};
  return run_batch(input.executor, batch, [&](std::uint64_t id, const ScenarioResult& result) {
    input.journal.record({.id = id, .result = result, .inputs = set.inputs(id)});
  });
}

/// Every scenario that is not done yet.
KindAnswer run_set(const KindInput& input) {
  const ScenarioSet set = scenario_set(input.study);
  std::vector<std::uint64_t> left = missing_scenarios(input.study, input.journal);
  input.journal.expect(set.count, set.count - left.size());
  const BatchReport done = run_of_set(input, set, std::move(left));
  KindAnswer answer;
  answer.lane_use = done.lane_use;
  answer.interrupted = done.stopped;
  return answer;
}

/// The set, then its tables.
template <class LookAt>
KindAnswer run_set_and(const KindInput& input, LookAt look_at) {
  KindAnswer answer = run_set(input);
  if (!answer.interrupted) look_at(answer, input.journal.rows());
  return answer;
}

}  // namespace

bool run_scenarios(const KindInput& input, const std::vector<std::uint64_t>& ids) {
  std::vector<std::uint64_t> left;
  std::ranges::copy_if(ids, std::back_inserter(left),
                       [&](std::uint64_t id) { return !input.journal.is_done(id); });
  input.journal.expect(ids.size(), ids.size() - left.size());
  return !run_of_set(input, scenario_set(input.study), std::move(left)).stopped;
}

std::vector<std::uint64_t> missing_scenarios(const Study& study, const RunJournal& journal) {
  std::vector<std::uint64_t> missing;
  const std::uint64_t count = scenario_set(study).count;
  for (std::uint64_t id = 0; id < count; ++id) {
    if (!journal.is_done(id)) missing.push_back(id);
  }
  return missing;
}

KindAnswer run_simulate(const KindInput& input) {
  const bool is_done = input.journal.is_done(0);
  input.journal.expect(1, is_done ? 1 : 0);
  KindAnswer answer;
  Trace trace;
  const auto result = input.executor.run_traced(input.study.scenario(0), trace, input.stop);
  answer.interrupted = !result;
  if (!result) return answer;
  if (!is_done) input.journal.record({.id = 0, .result = *result, .inputs = grid_inputs(input.study, 0)});
  if (auto contacts = contact_table(trace)) answer.found.push_back(*std::move(contacts));
  answer.trace = std::move(trace);
  return answer;
}

KindAnswer run_sweep(const KindInput& input) {
  const Study& study = input.study;
  return run_set_and(input, [&](KindAnswer& answer, const StudyRows& rows) {
    const std::vector<ColumnInfo> columns = input_columns(study);
    if (std::optional<StudyWindow> window = window_of_sweep(study, rows)) {
      const auto found = sweep_window_answer(input, columns, rows, *window, answer.warnings);
      answer.interrupted = !found;
      if (!found) return;
      answer.found = {set_points_table(*found), sizing_of(study, *window, *found)};
      answer.strategy = window_strategy(study, *window, *found);
      answer.window = std::move(window->table);
      return;
    }
    const GridAnswer found = grid_answer(columns, rows);
    answer.strategy = grid_strategy(study, found);
    answer.found = {found.table};
    answer.interrupted = !check_grid_winner(input, found, rows, answer);
  });
}

KindAnswer run_sample(const KindInput& input) {
  return run_set_and(
      input, [&](KindAnswer& answer, const StudyRows& rows) { answer.found = sample_tables(input.study, rows); });
}

KindAnswer run_compare(const KindInput& input) {
  return run_set_and(input, [&](KindAnswer& answer, const StudyRows& rows) {
    answer.found = compare_tables(input.study, rows);
    answer.strategy = compare_strategy(input.study, answer.found);
    answer.interrupted = !check_compare_winner(input, rows, answer);
  });
}

KindAnswer run_sensitivity(const KindInput& input) {
  return run_set_and(input, [&](KindAnswer& answer, const StudyRows& rows) {
    answer.found = sensitivity_tables(input.study, rows);
  });
}

}  // namespace unbruised::studies
