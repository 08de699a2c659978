#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "studies/cli/commands.hpp"
#include "studies/cli/interrupt.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/estimate/memory_need.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/execution/batch_runner.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/progress.hpp"
#include "studies/findings/claims.hpp"
#include "studies/kinds/study_runner.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// The command that continues, or with other words repeats, this run.
std::string command_of(const RunArguments& arguments) {
  std::string command =
      joined({shell_word(arguments.program), " run ", shell_word(arguments.study.study.string())});
  if (arguments.output) command += joined({" --output ", shell_word(arguments.output->string())});
  if (arguments.threads) command += joined({" --threads ", std::to_string(*arguments.threads)});
  for (const std::string& set : arguments.study.sets) command += joined({" --set ", shell_word(set)});
  return command;
}

void write_to_stderr(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Ten minutes, or what tests ask for.
std::chrono::milliseconds compaction_interval() {
  const char* text = std::getenv("UNBRUISED_COMPACTION_MS");
  const long wanted = text == nullptr ? 0 : std::strtol(text, nullptr, 10);
  return wanted > 0 ? std::chrono::milliseconds(wanted) : StudyRunOptions{}.compaction_interval;
}

/// A failing disk ends a study; what is safe, and what to do.
int report_failed(const RunArguments& arguments, const RunDirectory& run, const ResultsError& error) {
  const int status = report_error(error);
  if (error.kind != ResultsErrorKind::io) return status;
  print_note(joined({with_thousands(run.acknowledged()), " scenarios are safe in ", run.directory().string(),
                     "; once it can be written to again, continue with"}));
  std::cerr << joined({"  ", command_of(arguments), "\n"});
  return status;
}

int report_interrupted(const RunArguments& arguments, RunDirectory& run, const StudyReport& report) {
  print_note(joined({"interrupted: ", with_thousands(report.tables.rows.size()), " scenarios are safe in ",
                     run.directory().string(), "; continue with"}));
  std::cerr << joined({"  ", command_of(arguments), "\n"});
  const int status = interrupt_exit_status();
  return status == 0 ? kExitInternal : status;
}

/// "lanes: 93 % busy; 12 of the questions had been asked before"
std::string lanes_line(const Study& study, const StudyReport& report) {
  std::string line = joined({"lanes: ", short_number(100.0 * report.lane_use.occupancy()), " % busy"});
  if (is_search(study.kind())) line += " while searching";
  if (report.seconds > 0.0 && report.run_now > 0) {
    line += joined(
        {", ", short_number(static_cast<double>(report.run_now) / report.seconds), " scenarios per second"});
  }
  if (report.from_memory > 0) line += joined({"; ", with_thousands(report.from_memory), " answered from memory"});
  return line;
}

int report_finished(const RunArguments& arguments, const Study& study, const RunDirectory& run,
                    const StudyReport& report, int threads, const std::optional<fs::path>& page) {
  const std::size_t count = report.tables.rows.size();
  print_line(joined({study.name(), ": ", study_kind_word(study.kind()), ", ", with_thousands(count),
                     count == 1 ? " scenario, " : " scenarios, ", with_thousands(report.run_now), " run now in ",
                     duration_text(report.seconds), " on ", std::to_string(threads),
                     threads == 1 ? " thread" : " threads"}));
  for (const std::string& line : summary_lines(report.tables, study_kind_word(study.kind()))) print_line(line);
  if (report.lane_use.lane_steps > 0) print_line(lanes_line(study, report));
  RunArguments replay = arguments;
  replay.threads.reset();
  for (const std::string& line : replay_lines(report.tables, joined({command_of(replay), " --scenario"}))) {
    print_line(line);
  }
  print_line(joined({"results: ", run.results_path().string()}));
  if (page) print_line(joined({"report: ", page->string()}));
  print_line(joined({"digest ", rows_digest(report.tables.rows)}));
  std::size_t diverged = 0;
  for (const ScenarioRow& row : report.tables.rows) diverged += row.result.outcome == Outcome::diverged ? 1 : 0;
  if (diverged == 0) return kExitDone;
  print_note(joined({with_thousands(diverged), diverged == 1 ? " scenario" : " scenarios", " diverged"}));
  return kExitDiverged;
}

/// Every metric that exists, by name; with all digits, because bits are what this command is for.
void print_metrics(const ScenarioResult& result) {
  print_line(joined({"outcome: ", outcome_word(result.outcome), result.cause.empty() ? "" : ": ", result.cause}));
  char text[64] = "";
  for (const MetricInfo& info : kMetricTable) {
    const double value = result.metrics[info.metric];
    if (value != value) continue;
    std::snprintf(text, sizeof text, "%.17g", value);
    print_line(joined({"  ", info.name, " = ", text}));
  }
}

void compare_with_recorded(const ScenarioResult& result, const std::optional<ScenarioRow>& recorded) {
  if (!recorded) return;
  const bool same = result_digest(result) == result_digest(recorded->result);
  print_note(same ? "same bits as the recorded row"
                  : "differs from the recorded row, which another build must have written");
}

/// The scenario of an id. Those of a search are known once they have been evaluated.
std::optional<Scenario> scenario_of_id(const Study& study, const fs::path& directory, std::uint64_t id,
                                       const std::optional<ScenarioRow>& recorded) {
  if (has_fixed_scenarios(study.kind())) {
    const ScenarioSet set = scenario_set(study);
    if (id < set.count) return set.scenario(id);
    print_error(joined({"--scenario ", std::to_string(id), ": the study has the scenarios 0 to ",
                        std::to_string(set.count - 1)}));
    return std::nullopt;
  }
  std::optional<Scenario> scenario = recorded ? scenario_of_row(study, *recorded) : std::nullopt;
  if (!scenario) {
    print_error(joined({"--scenario ", std::to_string(id), ": ", directory.string(),
                        " holds no evaluation of this number made with this config; run the study first"}));
  }
  return scenario;
}

}  // namespace

int run_command(const RunArguments& arguments) {
  const std::optional<Study> study = read_or_explain(arguments.study);
  if (!study) return kExitInput;
  const int threads = thread_count_of(arguments.threads);
  if (const auto refusal = too_much_memory(*study, threads)) {
    print_error(*refusal);
    return kExitInput;
  }
  auto opened = RunDirectory::open({.directory = run_directory_of(*study, arguments.output),
                                    .config_toml = study->resolved_toml(),
                                    .build = build_line(),
                                    .fresh = arguments.fresh});
  if (!opened) return report_error(opened.error());
  RunDirectory& run = **opened;
  for (const std::string& note : run.notes()) print_note(note);

  const std::vector<std::string> warnings = study_warnings(*study);
  print_warnings(warnings);
  listen_for_interrupts();
  Progress progress(progress_style(STDERR_FILENO, arguments.quiet), write_to_stderr);
  const auto report = run_study(*study, run, core_simulator(),
                                {.threads = threads,
                                 .stop = &interrupt_requested(),
                                 .progress = &progress,
                                 .compaction_interval = compaction_interval(),
                                 .warnings = warnings});
  progress.close();
  if (!report) return report_failed(arguments, run, report.error());
  print_warnings(report->warnings);
  const std::optional<fs::path> page = write_report_of_run(run.directory(), arguments.program);
  return report->interrupted ? report_interrupted(arguments, run, *report)
                             : report_finished(arguments, *study, run, *report, threads, page);
}

int run_one_command(const RunArguments& arguments) {
  const std::optional<Study> study = read_or_explain(arguments.study);
  if (!study) return kExitInput;
  const fs::path directory = run_directory_of(*study, arguments.output);
  const std::uint64_t id = arguments.scenario.value();
  const std::optional<ScenarioRow> recorded = recorded_row(directory, *study, id);
  const std::optional<Scenario> scenario = scenario_of_id(*study, directory, id, recorded);
  if (!scenario) return kExitInput;

  const std::vector<std::string> warnings = study_warnings(*study);
  print_warnings(warnings);
  listen_for_interrupts();
  Trace trace;
  const std::optional<ScenarioResult> result =
      run_alone(core_simulator(), *scenario, &trace, &interrupt_requested());
  if (!result) return interrupt_exit_status();

  std::error_code failed;
  fs::create_directories(directory, failed);
  if (failed) {
    return report_error(
        {ResultsErrorKind::io, joined({"cannot create ", directory.string(), ": ", failed.message()}), {}});
  }
  ScenarioRow row{
      .id = id,
      .result = *result,
      .inputs = has_fixed_scenarios(study->kind()) ? scenario_set(*study).inputs(id) : recorded->inputs,
      .place = {}};
  const fs::path file = directory / joined({"scenario_", std::to_string(id), ".h5"});
  const ResultsContent content{.meta = results_meta(*study, warnings, ResultsState::complete),
                               .inputs = input_columns(*study),
                               .rows = {row},
                               .rows_of_search = false,
                               .tables = {},
                               .window = nullptr,
                               .trace = trace.time_s.empty() ? nullptr : &trace};
  if (auto error = write_results_file(file, content)) return report_error(*error);

  const std::string inputs = inputs_text(content.inputs, row.inputs);
  print_line(joined({study->name(), ": scenario ", std::to_string(id), inputs.empty() ? "" : " with ", inputs}));
  if (const std::string_view remark = damage_remark(damage_claim(*scenario)); !remark.empty()) {
    print_line(std::string(remark));
  }
  print_metrics(*result);
  compare_with_recorded(*result, recorded);
  print_line(joined({"results: ", file.string()}));
  print_line(joined({"digest ", digest_text(result_digest(*result))}));
  return result->outcome == Outcome::diverged ? kExitDiverged : kExitDone;
}

}  // namespace unbruised::studies
