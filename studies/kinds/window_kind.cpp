#include "studies/kinds/window_kind.hpp"

#include <cstdint>
#include <unordered_map>
#include <utility>

#include "studies/execution/batch_runner.hpp"
#include "studies/kinds/study_answer.hpp"
#include "studies/kinds/window_run.hpp"

namespace unbruised::studies {
namespace {

/// Answers rounds of forces from the journal and from the executor.
class ForceRounds {
 public:
  explicit ForceRounds(const KindInput& input) : input_(input) {
    for (const ScenarioRow& row : input.journal.rows()) recorded_.emplace(row.id, row);
  }

  std::optional<std::vector<ScenarioRow>> answer(const std::vector<ForceRequest>& requests) {
    const Study& study = input_.study;
    const std::uint64_t first_id = requests.front().id;
    const auto request_of = [&](std::uint64_t id) -> const ForceRequest& { return requests[id - first_id]; };
    const auto scenario_of = [&](std::uint64_t id) {
      const ForceRequest& asked = request_of(id);
      return window_scenario(study, asked.combination, asked.grip_force_N, asked.step);
    };
    Batch batch{.ids = {}, .scenario = scenario_of, .stop = input_.stop};
    for (const ForceRequest& request : requests) {
      if (!is_recorded(request)) batch.ids.push_back(request.id);
    }
    input_.journal.expect(requests.size(), requests.size() - batch.ids.size());
    const BatchReport done =
        run_batch(input_.executor, batch, [&](std::uint64_t id, const ScenarioResult& result) {
          ScenarioRow row{.id = id, .result = result, .inputs = window_inputs(study, request_of(id))};
          input_.journal.record(row);
          recorded_.insert_or_assign(id, std::move(row));
        });
    if (done.stopped) return std::nullopt;
    std::vector<ScenarioRow> answers;
    for (const ForceRequest& request : requests) answers.push_back(recorded_.at(request.id));
    return answers;
  }

 private:
  bool is_recorded(const ForceRequest& request) const {
    const auto found = recorded_.find(request.id);
    if (found == recorded_.end()) return false;
    if (found->second.inputs != window_inputs(input_.study, request)) {
      throw input_.journal.foreign_record(request.id);
    }
    return true;
  }

  const KindInput& input_;
  std::unordered_map<std::uint64_t, ScenarioRow> recorded_;
};

/// Combinations whose forces are cheapest asked for together.
std::vector<std::size_t> factor_groups(const KindInput& input) {
  std::vector<std::size_t> group_of;
  std::unordered_map<std::string, std::size_t> index_of;
  for (std::size_t point = 0; point < input.study.scenario_count(); ++point) {
    const std::string key = input.executor.group_key(input.study.scenario(point));
    group_of.push_back(index_of.try_emplace(key, index_of.size()).first->second);
  }
  return group_of;
}

}  // namespace

KindAnswer run_window(const KindInput& input) {
  input.journal.total_may_grow();
  ForceRounds rounds(input);
  std::optional<WindowRun> found =
      run_window_study(input.study, factor_groups(input), input_columns(input.study),
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

}  // namespace unbruised::studies
