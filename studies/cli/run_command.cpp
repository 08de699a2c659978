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
#include "studies/estimate/study_cost.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/counted_simulator.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/execution/progress.hpp"
#include "studies/findings/rests_on.hpp"
#include "studies/kinds/study_runner.hpp"
#include "studies/ranks/join_ranks.hpp"
#include "studies/ranks/rank_executor.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/row_summary.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

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
  return ask_to_continue(arguments);
}

/// "lanes: 93 % busy; 12 of the questions had been asked before"
std::string lanes_line(const Study& study, const StudyReport& report) {
  std::string line = joined({"lanes: ", percent(report.lane_use.occupancy()), " busy"});
  if (is_search(study.kind())) line += " while searching";
  if (report.seconds > 0.0 && report.run_now > 0) {
    line += joined(
        {", ", three_digits(static_cast<double>(report.run_now) / report.seconds), " scenarios per second"});
  }
  if (report.from_memory > 0) line += joined({"; ", with_thousands(report.from_memory), " answered from memory"});
  return line;
}

std::optional<fs::path> page_of_run(const RunArguments& arguments, const RunDirectory& run,
                                    const StudyReport& report) {
  if (report.tables.rows.size() <= kRowsCompactedMost) {
    return write_report_of_run(run.directory(), arguments.program, arguments.moving && !report.interrupted);
  }
  print_note(joined({"so many scenarios are on no page yet; `", shell_word(arguments.program), " report ",
                     shell_word(run.directory().string()), "` writes one of a choice of them"}));
  return std::nullopt;
}

int report_finished(const RunArguments& arguments, const Study& study, const RunDirectory& run,
                    const StudyReport& report, int threads, const std::optional<fs::path>& page) {
  const std::size_t count = report.tables.rows.size();
  print_line(joined({study.name(), ": ", study_kind_word(study.kind()), ", ", with_thousands(count),
                     count == 1 ? " scenario, " : " scenarios, ", with_thousands(report.run_now), " run now in ",
                     duration_text(report.seconds), " on ", std::to_string(threads),
                     threads == 1 ? " thread" : " threads"}));
  for (const std::string& line : summary_lines(report.tables, study_kind_word(study.kind()))) print_line(line);
  if (std::string line = rests_on_line(value_counts(study.resolved_toml())); !line.empty()) print_line(line);
  if (report.lane_use.lane_steps > 0) print_line(lanes_line(study, report));
  RunArguments replay = arguments;
  replay.threads.reset();
  for (const std::string& line : replay_lines(report.tables, joined({command_of(replay), " --scenario"}))) {
    print_line(line);
  }
  print_line(joined({"results: ", run.results_path().string()}));
  if (page) print_line(joined({"report: ", page->string()}));
  print_line(joined({"digest ", rows_digest(report.tables.rows)}));
  const std::size_t diverged = report.tables.rows.seen().outcomes.of[static_cast<std::size_t>(Outcome::diverged)];
  if (diverged == 0) return kExitDone;
  print_note(joined({with_thousands(diverged), diverged == 1 ? " scenario" : " scenarios", " diverged"}));
  return kExitDiverged;
}

}  // namespace

std::string command_of(const RunArguments& arguments) {
  std::string command =
      joined({shell_word(arguments.program), " run ", shell_word(arguments.study.study.string())});
  if (arguments.output) command += joined({" --output ", shell_word(arguments.output->string())});
  if (arguments.threads) command += joined({" --threads ", std::to_string(*arguments.threads)});
  if (arguments.shard) {
    command += joined(
        {" --shard ", std::to_string(arguments.shard->number), "/", std::to_string(arguments.shard->count)});
  }
  for (const std::string& set : arguments.study.sets) command += joined({" --set ", shell_word(set)});
  return command;
}

void write_to_stderr(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

bool may_run(const Study& study, const StudyCost& cost, int threads) {
  auto refusal = too_much_memory(study, threads);
  if (!refusal) refusal = too_many_may_touch(study.name(), cost.most);
  if (refusal) print_error(*refusal);
  return !refusal;
}

int ask_to_continue(const RunArguments& arguments) {
  std::cerr << joined({"  ", command_of(arguments), "\n"});
  const int status = interrupt_exit_status();
  return status == 0 ? kExitInternal : status;
}

/// Where its scenarios are run: on the threads of this process, or where mpirun has started several, on theirs.
struct Places {
  std::unique_ptr<Executor> executor;
  std::optional<std::string> refusal;
};

Places places_of_run(FirstRank* first, const Simulator& simulator, int threads, Progress& progress) {
  if (first == nullptr) return {std::make_unique<LaneExecutor>(simulator, threads), std::nullopt};
  auto ranks = std::make_unique<RankExecutor>(*first, simulator, threads,
                                              [&progress](std::size_t steps) { progress.count_steps(steps); });
  const std::optional<std::string> refusal = ranks->refusal();
  return {std::move(ranks), refusal};
}

/// @param first of several ranks; nullptr: this process is the only one
int run_here(const RunArguments& arguments, FirstRank* first) {
  const std::optional<Study> study = read_or_explain(arguments.study);
  if (!study) return kExitInput;
  const int threads = thread_count_of(arguments.threads);
  const StudyCost cost = study_cost(*study, threads);
  if (!may_run(*study, cost, threads)) return kExitInput;
  auto opened = RunDirectory::open({.directory = run_directory_of(*study, arguments.output),
                                    .config_toml = study->resolved_toml(),
                                    .build = build_line(),
                                    .fresh = arguments.fresh});
  if (!opened) return report_error(opened.error());
  RunDirectory& run = **opened;
  for (const std::string& note : run.notes()) print_note(note);
  if (arguments.only_whole) {
    if (const auto status = say_what_is_missing(arguments, *study, run)) return *status;
  }

  const std::vector<std::string> warnings = study_warnings(*study);
  print_warnings(warnings);
  listen_for_interrupts();
  Progress progress(progress_style(STDERR_FILENO, arguments.quiet ? Verbosity::quiet : Verbosity::usual),
                    write_to_stderr);
  progress.plan(progress_plan(*study, cost));
  const CountedSimulator simulator(core_simulator(), progress);
  const Places places = places_of_run(first, simulator, threads, progress);
  if (places.refusal) {
    print_error(*places.refusal);
    return kExitInput;
  }
  if (first != nullptr) print_note(joined({std::to_string(first->link().size()), " ranks"}));
  const auto report = run_study(*study, run, *places.executor,
                                {.stop = &interrupt_requested(),
                                 .progress = &progress,
                                 .compaction_interval = compaction_interval(),
                                 .warnings = warnings});
  progress.close();
  if (!report) return report_failed(arguments, run, report.error());
  print_warnings(report->warnings);
  const std::optional<fs::path> page = page_of_run(arguments, run, *report);
  return report->interrupted ? report_interrupted(arguments, run, *report)
                             : report_finished(arguments, *study, run, *report, threads, page);
}

int run_command(const RunArguments& arguments) {
  if (rank_count() == 1) return run_here(arguments, nullptr);
  auto link = join_ranks();
  if (!link) {
    print_error(link.error());
    return kExitInput;
  }
  if ((*link)->rank() > 0) {
    serve_first_rank(**link, core_simulator(), thread_count_of(arguments.threads));
    return kExitDone;
  }
  FirstRank first(**link);
  return run_here(arguments, &first);
}

}  // namespace unbruised::studies
