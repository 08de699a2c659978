#include "python/bindings/evaluation.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <thread>

#include "core/simulation/simulation.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/interruptible.hpp"
#include "python/bindings/raised.hpp"
#include "studies/execution/batch_runner.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/execution/lone_run.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::python {
namespace {

namespace py = pybind11;

/// The scenarios of all rows, read by several threads, or what is wrong with the first wrong one.
class ReadRows {
 public:
  ReadRows(const Source& source, const std::vector<std::vector<std::string>>& rows)
      : source_(source), rows_(rows), scenarios_(rows.size()), wrong_(rows.size()) {}

  void run(int threads, const std::atomic<bool>& stop) {
    const auto work = [&] {
      for (std::size_t at = next_++; at < rows_.size() && !stop; at = next_++) read(at);
    };
    std::vector<std::jthread> helpers;
    const std::size_t count = std::min(static_cast<std::size_t>(threads), rows_.size());
    for (std::size_t i = 1; i < count; ++i) helpers.emplace_back(work);
    work();
  }
  [[nodiscard]] const Scenario& scenario(std::uint64_t id) const { return *scenarios_[id]; }
  [[nodiscard]] bool has_problem() const {
    return std::any_of(wrong_.begin(), wrong_.end(), [](const auto& error) { return error.has_value(); });
  }
  void raise_first_problem() const {
    for (std::size_t row = 0; row < wrong_.size(); ++row) {
      if (wrong_[row]) raise(*wrong_[row], row);
    }
  }

 private:
  void read(std::size_t at) {
    studies::StudyOrError read_now = source_.read_single(rows_[at]);
    if (read_now) {
      scenarios_[at] = read_now->scenario(0);
    } else {
      wrong_[at] = read_now.error();
    }
  }

  const Source& source_;
  const std::vector<std::vector<std::string>>& rows_;
  std::vector<std::optional<Scenario>> scenarios_;
  std::vector<std::optional<studies::ConfigError>> wrong_;
  std::atomic<std::size_t> next_ = 0;
};

Scenario scenario_of(const Source& source, const std::vector<std::string>& sets, std::optional<std::uint64_t> id) {
  if (!id) {
    studies::StudyOrError read_now = source.read_single(sets);
    if (!read_now) raise(read_now.error());
    return read_now->scenario(0);
  }
  const studies::Study study = source.study(sets);
  if (!studies::has_fixed_scenarios(study.kind())) {
    throw py::value_error("scenario: a study of this kind has no scenarios with numbers before it is run");
  }
  const studies::ScenarioSet set = studies::scenario_set(study);
  if (*id >= set.count) {
    throw py::value_error("scenario: the study has the scenarios 0 to " + std::to_string(set.count - 1));
  }
  return set.scenario(*id);
}

}  // namespace

py::dict evaluate(const Source& source, const std::vector<std::vector<std::string>>& rows, int threads,
                  const py::object& progress) {
  ReadRows read(source, rows);
  std::vector<ScenarioResult> results(rows.size());
  std::atomic<std::size_t> done = 0;
  const auto work = [&](const std::atomic<bool>& stop) {
    read.run(threads, stop);
    if (stop || read.has_problem()) return;
    studies::Batch batch{.ids = std::vector<std::uint64_t>(rows.size()),
                         .scenario = [&](std::uint64_t id) { return read.scenario(id); },
                         .stop = &stop};
    std::iota(batch.ids.begin(), batch.ids.end(), std::uint64_t{0});
    studies::run_batch(studies::LaneExecutor(studies::core_simulator(), threads), batch,
                       [&](std::uint64_t id, const ScenarioResult& result) {
                         results[id] = result;
                         ++done;
                       });
  };
  run_interruptibly(work, [&] {
    if (!progress.is_none()) progress(done.load(), rows.size());
  });
  read.raise_first_problem();
  return columns_of(results);
}

py::dict simulate(const Source& source, const std::vector<std::string>& sets, std::optional<std::uint64_t> id,
                  bool keep_motion) {
  const Scenario scenario = scenario_of(source, sets, id);
  Trace trace;
  trace.keeps_motion = keep_motion;
  std::optional<ScenarioResult> result;
  run_interruptibly(
      [&](const std::atomic<bool>& stop) {
        result = studies::run_alone(studies::core_simulator(), scenario, &trace, &stop);
      },
      {});
  py::dict answer;
  answer["result"] = columns_of({result.value()});
  answer["signals"] = signals_of(std::move(trace));
  return answer;
}

}  // namespace unbruised::python
