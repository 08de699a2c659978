#include "studies/kinds/window_kind.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "studies/execution/batch_runner.hpp"
#include "studies/kinds/study_answer.hpp"
#include "studies/kinds/window_run.hpp"

namespace unbruised::studies {
namespace {

/// What the journal holds of a window study.
class RecordedForces {
 public:
  RecordedForces(const Study& study, const RunJournal& journal) : study_(study), journal_(journal) {
    const StudyRows recorded = journal.rows();
    for (const ScenarioRow& row : recorded) rows_.emplace(row.id, row);
  }

  /// Null: it is not there. Throws JournalFailure when another force is in its place.
  [[nodiscard]] const ScenarioRow* find(const ForceRequest& request) const {
    const auto found = rows_.find(journal_id(request.place));
    if (found == rows_.end()) return nullptr;
    if (found->second.inputs != window_inputs(study_, request)) throw journal_.foreign_record(found->first);
    return &found->second;
  }

  /// Nothing where one is not there.
  [[nodiscard]] std::optional<std::vector<ScenarioRow>> find(const std::vector<ForceRequest>& requests) const {
    std::vector<ScenarioRow> found;
    for (const ForceRequest& request : requests) {
      const ScenarioRow* row = find(request);
      if (row == nullptr) return std::nullopt;
      found.push_back(*row);
    }
    return found;
  }

  void add(ScenarioRow row) { rows_.insert_or_assign(row.id, std::move(row)); }

 private:
  const Study& study_;
  const RunJournal& journal_;
  std::unordered_map<std::uint64_t, ScenarioRow> rows_;
};

/// Answers rounds of forces from the journal and from the executor.
class ForceRounds {
 public:
  explicit ForceRounds(const KindInput& input) : input_(input), recorded_(input.study, input.journal) {}

  std::optional<std::vector<ScenarioRow>> answer(const std::vector<ForceRequest>& requests) {
    const Study& study = input_.study;
    const auto scenario_of = [&](std::uint64_t at) {
      const ForceRequest& asked = requests[at];
      return window_scenario(study, asked.combination(), asked.grip_force_N, asked.step);
    };
    Batch batch{.ids = {}, .scenario = scenario_of, .stop = input_.stop};
    for (std::uint64_t at = 0; at < requests.size(); ++at) {
      if (recorded_.find(requests[at]) == nullptr) batch.ids.push_back(at);
    }
    input_.journal.expect(requests.size(), requests.size() - batch.ids.size());
    const BatchReport done =
        run_batch(input_.executor, batch, [&](std::uint64_t at, const ScenarioResult& result) {
          ScenarioRow row{.id = journal_id(requests[at].place),
                          .result = result,
                          .inputs = window_inputs(study, requests[at])};
          input_.journal.record(row);
          recorded_.add(std::move(row));
        });
    return done.stopped ? std::nullopt : recorded_.find(requests);
  }

 private:
  const KindInput& input_;
  RecordedForces recorded_;
};

}  // namespace

KindAnswer run_window(const KindInput& input) {
  input.journal.total_may_grow();
  ForceRounds rounds(input);
  std::optional<WindowRun> found =
      run_window_study(input.study, input_columns(input.study),
                       [&rounds](const std::vector<ForceRequest>& requests) { return rounds.answer(requests); });
  KindAnswer answer;
  answer.interrupted = !found;
  if (!found) return answer;
  answer.warnings = std::move(found->warnings);
  answer.found = {set_points_table(found->answer), sizing_of(input.study, found->window, found->answer)};
  answer.strategy = window_strategy(input.study, found->window, found->answer);
  answer.window = std::move(found->window.table);
  return answer;
}

bool run_combinations(const KindInput& input, const std::vector<std::uint64_t>& numbers) {
  input.journal.total_may_grow();
  std::vector<SearchedCombination> combinations = combinations_of(input.study);
  std::erase_if(combinations, [&](const SearchedCombination& each) {
    return !std::ranges::binary_search(numbers, each.number);
  });
  ForceRounds rounds(input);
  const auto ends = search_study_windows(
      input.study, std::move(combinations),
      [&rounds](const std::vector<ForceRequest>& requests) { return rounds.answer(requests); });
  return ends.has_value();
}

std::vector<std::uint64_t> missing_combinations(const Study& study, const RunJournal& journal) {
  const RecordedForces recorded(study, journal);
  std::vector<std::uint64_t> missing;
  for (const SearchedCombination& each : combinations_of(study)) {
    const auto ends = search_study_windows(
        study, {each}, [&](const std::vector<ForceRequest>& requests) { return recorded.find(requests); });
    if (!ends) missing.push_back(each.number);
  }
  return missing;
}

}  // namespace unbruised::studies
