#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "core/simulation/simulation.hpp"
#include "studies/cli/commands.hpp"
#include "studies/cli/interrupt.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/cli/refusals.hpp"
#include "studies/cli/replays.hpp"
#include "studies/estimate/cost_estimate.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/execution/arm_run.hpp"
#include "studies/execution/lone_run.hpp"
#include "studies/findings/claims.hpp"
#include "studies/findings/contact_table.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/kinds/study_results.hpp"
#include "studies/report/report_page.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/results_file.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// So many rows of a trace show every phase on a page.
constexpr double kChartRows = 2000.0;

/// Thins the trace, not the run: its steps and metrics stay as they are.
void thin_for_charts(Scenario& scenario) {
  SimulationParameters& simulation = scenario.simulation;
  if (simulation.trace_interval_s) return;
  const double every = std::ceil(estimated_steps(scenario) / kChartRows);
  if (every > 1.0) simulation.trace_interval_s = every * simulation.time_step_s;
}

/// "recording about 1,502 of 3,004 time steps of 1,099 particles: 119 MB before compression"
void say_size(const Scenario& scenario) {
  const ModelSize size = model_size(scenario);
  const auto whole = [](double count) {
    return with_thousands(static_cast<unsigned long long>(std::llround(count)));
  };
  const double rows = estimated_trace_rows(scenario);
  print_note(joined({"recording about ", whole(rows), " of ", whole(std::max(rows, estimated_steps(scenario))),
                     " time steps of ", whole(static_cast<double>(size.particle_count)), " particles: about ",
                     bytes_text(estimated_trace_bytes(scenario, size)),
                     " before compression (--full-trace keeps every step)"}));
}

/// Every metric that exists, by name, in digits to read; the file has them all.
void print_metrics(const ScenarioResult& result) {
  print_line(joined({"outcome: ", outcome_word(result.outcome), result.cause.empty() ? "" : ": ", result.cause}));
  for (const MetricInfo& info : kMetricTable) {
    const double value = result.metrics[info.metric];
    if (!std::isnan(value)) print_line(joined({"  ", info.name, " = ", short_number(value)}));
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

/// What there is to see of one run; nothing where it made no frame.
std::vector<ScenarioReplay> seen_once(std::uint64_t id, const Scenario& scenario, const ScenarioResult& result,
                                      const Trace& trace, Replay replay) {
  if (replay.frame_count() == 0) return {};
  ScenarioReplay seen{.id = id,
                      .why = "the scenario",
                      .result = result,
                      .stage = replay_stage(scenario),
                      .replay = std::move(replay),
                      .trace = {},
                      .arm_m = {}};
  seen.arm_m = arm_links_m(scenario, result, seen.replay.time_s);
  seen.trace.time_s = trace.time_s;
  seen.trace.signals = trace.signals;
  seen.trace.events = trace.events;
  return {std::move(seen)};
}

/// The page of the scenario beside its file; says so when it cannot be written, since the file is there.
void write_page(const fs::path& file, const ResultsContent& content, const RunArguments& arguments,
                std::vector<ScenarioReplay> replays) {
  RunArguments replay = arguments;
  replay.threads.reset();
  const StudyTables tables{.inputs = content.inputs, .rows = content.rows, .window = std::nullopt, .found = {}};
  const ReportContext context{.replay_command = joined({command_of(replay), " --scenario"}),
                              .wanted = std::nullopt,
                              .source = file.string(),
                              .digest = rows_digest(content.rows),
                              .summary = {outcome_line(content.rows)},
                              .replays = std::move(replays)};
  const fs::path page = fs::path(file).replace_extension(".html");
  if (const auto error = write_report(page, content, context)) {
    print_note(joined({"no page was written: ", error->message}));
  } else {
    print_line(joined({"report: ", page.string()}));
  }
}

}  // namespace

int run_one_command(const RunArguments& arguments) {
  if (refuse_ranks("--scenario")) return kExitInput;
  const std::optional<Study> study = read_or_explain(arguments.study);
  if (!study) return kExitInput;
  const fs::path directory = run_directory_of(*study, arguments.output);
  const std::uint64_t id = arguments.scenario.value();
  const std::optional<ScenarioRow> recorded = recorded_row(directory, *study, id);
  std::optional<Scenario> scenario = scenario_of_id(*study, directory, id, recorded);
  if (!scenario) return kExitInput;
  if (arguments.trace_rows == TraceRows::chart) thin_for_charts(*scenario);

  const std::vector<std::string> warnings = study_warnings(*study);
  print_warnings(warnings);
  say_size(*scenario);
  listen_for_interrupts();
  Trace trace;
  Replay replay;
  const Recording kept(&trace, arguments.moving ? &replay : nullptr, replay_interval_s(*scenario));
  const std::optional<ScenarioResult> result =
      run_alone(core_simulator(), *scenario, kept, &interrupt_requested());
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
  std::vector<ResultTable> tables;
  if (auto contacts = contact_table(trace)) tables.push_back(*std::move(contacts));
  const fs::path file = directory / joined({"scenario_", std::to_string(id), ".h5"});
  const ResultsContent content{.meta = results_meta(*study, warnings, ResultsState::complete),
                               .inputs = input_columns(*study),
                               .rows = {row},
                               .places = RowPlaces::none,
                               .tables = std::move(tables),
                               .window = nullptr,
                               .trace = trace.time_s.empty() ? nullptr : &trace};
  if (auto error = write_results_file(file, content)) return report_error(*error);

  const std::string inputs = inputs_text(content.inputs, row.inputs);
  print_line(joined({study->name(), ": scenario ", std::to_string(id), inputs.empty() ? "" : " with ", inputs}));
  if (const std::string_view remark = damage_remark(damage_claim(*scenario)); !remark.empty()) {
    print_line(std::string(remark));
  }
  print_metrics(*result);
  for (const std::string& line : contact_lines(content.tables)) print_line(line);
  compare_with_recorded(*result, recorded);
  print_line(joined({"results: ", file.string()}));
  write_page(file, content, arguments, seen_once(id, *scenario, *result, trace, std::move(replay)));
  print_line(joined({"digest ", digest_text(result_digest(*result))}));
  return result->outcome == Outcome::diverged ? kExitDiverged : kExitDone;
}

}  // namespace unbruised::studies
