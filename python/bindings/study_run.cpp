#include "python/bindings/study_run.hpp"

#include <memory>
#include <optional>

#include <pybind11/stl.h>

#include "python/bindings/interruptible.hpp"
#include "python/bindings/raised.hpp"
#include "studies/estimate/memory_need.hpp"
#include "studies/estimate/study_cost.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/counted_simulator.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/findings/shown_probability.hpp"
#include "studies/findings/summary.hpp"
#include "studies/kinds/study_runner.hpp"
#include "studies/results/run_directory.hpp"

namespace unbruised::python {
namespace {

namespace py = pybind11;

std::optional<std::string> refusal(const studies::Study& study, const studies::StudyCost& cost, int threads) {
  auto sentence = studies::too_much_memory(study, threads);
  if (!sentence) sentence = studies::too_many_may_touch(study.name(), cost.most);
  return sentence;
}

std::unique_ptr<studies::RunDirectory> open_directory(const studies::Study& study, const RunSettings& settings) {
  auto opened = studies::RunDirectory::open({.directory = settings.directory,
                                             .config_toml = study.resolved_toml(),
                                             .build = studies::build_line(),
                                             .fresh = settings.fresh});
  if (!opened) raise(opened.error());
  return *std::move(opened);
}

}  // namespace

py::dict check(const Source& source, const std::vector<std::string>& sets, int threads) {
  const studies::Study study = source.study(sets);
  const studies::StudyCost cost = studies::study_cost(study, threads);
  py::dict said;
  said["name"] = study.name();
  said["kind"] = std::string(studies::study_kind_word(study.kind()));
  said["scenarios"] = cost.scenarios;
  said["factor_groups"] = cost.groups;
  said["particles"] = py::make_tuple(cost.least.particle_count, cost.most.particle_count);
  said["freedoms"] = py::make_tuple(cost.least.freedom_count, cost.most.freedom_count);
  said["memory_bytes"] = cost.memory_bytes;
  said["disk_bytes"] = cost.disk_bytes;
  said["seconds"] = cost.seconds;
  said["threads"] = cost.threads;
  said["time_step_s"] = study.scenario(0).simulation.time_step_s;
  said["warnings"] = studies::study_warnings(study);
  said["notes"] = studies::probability_notes(study);
  said["refusal"] = refusal(study, cost, threads);
  return said;
}

py::dict run(const Source& source, const std::vector<std::string>& sets, const RunSettings& settings,
             const py::object& progress) {
  const studies::Study study = source.study(sets);
  const studies::StudyCost cost = studies::study_cost(study, settings.threads);
  if (const auto sentence = refusal(study, cost, settings.threads)) raise_refusal(*sentence);
  const std::unique_ptr<studies::RunDirectory> directory = open_directory(study, settings);
  const std::vector<std::string> warnings = studies::study_warnings(study);
  studies::Progress counted(studies::ProgressStyle::none, [](std::string_view) {});
  counted.plan(studies::progress_plan(study, cost));
  const studies::CountedSimulator simulator(studies::core_simulator(), counted);
  std::optional<studies::Expected<studies::StudyReport>> report;
  run_interruptibly(
      [&](const std::atomic<bool>& stop) {
        report = studies::run_study(study, *directory, studies::LaneExecutor(simulator, settings.threads),
                                    {.stop = &stop, .progress = &counted, .warnings = warnings});
      },
      [&] {
        if (progress.is_none()) return;
        const studies::ProgressState now = counted.state();
        progress(now.done, now.total, studies::progress_text(now));
      });
  if (!*report) raise(report->error());
  py::dict answer;
  answer["digest"] = studies::rows_digest((*report)->tables.rows);
  answer["lines"] = studies::summary_lines((*report)->tables, std::string(studies::study_kind_word(study.kind())));
  std::vector<std::string> all = warnings;
  all.insert(all.end(), (*report)->warnings.begin(), (*report)->warnings.end());
  answer["warnings"] = all;
  answer["notes"] = directory->notes();
  answer["run_now"] = (*report)->run_now;
  answer["seconds"] = (*report)->seconds;
  return answer;
}

}  // namespace unbruised::python
