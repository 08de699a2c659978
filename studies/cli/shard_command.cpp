#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include "studies/cli/commands.hpp"
#include "studies/cli/interrupt.hpp"
#include "studies/cli/refusals.hpp"
#include "studies/estimate/study_cost.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/counted_simulator.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/execution/progress.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/journal.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

std::string merge_line(const RunArguments& arguments, const RunDirectory& run) {
  return joined({"  ", shell_word(arguments.program), " merge ", shell_word(run.directory().string()), "\n"});
}

std::string part_text(const Shard& shard) {
  return joined({"part ", std::to_string(shard.number), " of ", std::to_string(shard.count)});
}

/// What one journal of another directory is to the study that is merged.
struct Import {
  std::size_t rows = 0;
  std::string refusal;  ///< empty: it belongs to the study
};

Import look_at_journal(const fs::path& file, std::uint64_t config_prefix) {
  Import import;
  const auto state = walk_journal(file, config_prefix, [&](const SeenRecord& record) {
    if (record.kind == RecordKind::session && record.payload != build_line()) {
      import.refusal = joined({"was written by another build (", record.payload, ")"});
    }
    import.rows += record.kind == RecordKind::scenario ? 1 : 0;
  });
  if (!state) return {0, state.error().message};
  if (import.rows == 0 && import.refusal.empty()) {
    import.refusal = state->other_config_records > 0 ? "belongs to another study" : "holds no whole record";
  }
  return import;
}

/// Copies a journal beside those of the merged directory, under its own name where that is free or the same file.
MaybeError copy_journal(const fs::path& file, const fs::path& journals) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  fs::path to = journals / file.filename();
  std::error_code error;
  for (int number = 1; fs::exists(to, error); ++number) {
    if (const auto there = read_text_file(to); there && *there == *text) return {};
    to = journals / joined({file.stem().string(), "-", std::to_string(number), ".jrnl"});
  }
  return write_text_file(to, *text);
}

/// Brings the journals of another directory in. What cannot be believed is named and left out.
MaybeError bring_in(const fs::path& from, const fs::path& into, const std::string& config) {
  const auto other = read_text_file(from / "config.toml");
  if (!other || *other != config) {
    const std::vector<std::string> keys = other ? differing_keys(*other, config) : std::vector<std::string>{};
    const std::string why = !other         ? "no run directory"
                            : keys.empty() ? "another config"
                                           : joined({"another study (", comma_list(keys), ")"});
    print_note(joined({from.string(), " holds ", why, "; it is left out"}));
    return {};
  }
  const std::uint64_t prefix = config_hash_prefix(sha256_hex(config));
  for (const fs::path& file : journal_files(from)) {
    const Import import = look_at_journal(file, prefix);
    if (!import.refusal.empty()) {
      print_note(joined({file.string(), " ", import.refusal, "; it is left out"}));
      continue;
    }
    if (auto error = copy_journal(file, into / "journal")) return error;
    print_note(joined({with_thousands(import.rows), " rows of ", file.string()}));
  }
  return {};
}

}  // namespace

std::optional<int> say_what_is_missing(const RunArguments& arguments, const Study& study, RunDirectory& run) {
  const auto missing = missing_ids(study, run);
  if (!missing) return report_error(missing.error());
  if (missing->empty()) return std::nullopt;
  print_note(joined(
      {units_of(study, missing->size()), missing->size() == 1 ? " is" : " are", " missing (", id_ranges(*missing),
       "); run further parts and merge again, or end the study with what runs just the missing ones"}));
  std::cerr << joined({"  ", command_of(arguments), "\n"});
  return kExitMissing;
}

int run_shard_command(const RunArguments& arguments) {
  if (refuse_ranks("--shard")) return kExitInput;
  const std::optional<Study> study = read_or_explain(arguments.study);
  if (!study) return kExitInput;
  if (const auto refusal = has_no_parts(*study)) {
    print_error(*refusal);
    return kExitInput;
  }
  const int threads = thread_count_of(arguments.threads);
  const StudyCost cost = study_cost(*study, threads);
  if (!may_run(*study, cost, threads)) return kExitInput;
  auto opened = RunDirectory::open({.directory = run_directory_of(*study, arguments.output),
                                    .config_toml = study->resolved_toml(),
                                    .build = build_line(),
                                    .part = true});
  if (!opened) return report_error(opened.error());
  RunDirectory& run = **opened;
  for (const std::string& note : run.notes()) print_note(note);
  listen_for_interrupts();
  Progress progress(progress_style(STDERR_FILENO, arguments.quiet ? Verbosity::quiet : Verbosity::usual),
                    write_to_stderr);
  progress.plan(progress_plan(*study, cost));
  const CountedSimulator simulator(core_simulator(), progress);
  const auto report = run_shard(*study, run, LaneExecutor(simulator, threads), *arguments.shard,
                                &interrupt_requested(), &progress);
  progress.close();
  if (!report) return report_error(report.error());
  print_line(joined({study->name(), ": ", part_text(*arguments.shard), ", ", units_of(*study, report->count), ", ",
                     with_thousands(report->run_now), has_fixed_scenarios(study->kind()) ? "" : " scenarios",
                     " run now in ", duration_text(report->seconds)}));
  if (report->interrupted) {
    print_note(joined({"interrupted; what was run is safe in ", run.directory().string(), "; continue with"}));
    return ask_to_continue(arguments);
  }
  print_note("when all parts are there, end the study with");
  std::cerr << merge_line(arguments, run);
  return kExitDone;
}

int merge_command(const MergeArguments& arguments) {
  if (refuse_ranks("merge")) return kExitInput;
  const fs::path& directory = arguments.directories.front();
  const auto config = read_text_file(directory / "config.toml");
  if (!config) return report_error(config.error());
  const StudyArguments recorded{.study = directory / "config.toml", .sets = {}};
  const std::optional<Study> study = read_or_explain(recorded);
  if (!study) return kExitInput;
  if (const auto refusal = has_no_parts(*study)) {
    print_error(*refusal);
    return kExitInput;
  }
  for (std::size_t i = 1; i < arguments.directories.size(); ++i) {
    if (auto error = bring_in(arguments.directories[i], directory, *config)) return report_error(*error);
  }
  RunArguments whole;
  whole.study = recorded;
  whole.output = directory;
  whole.threads = arguments.threads;
  whole.only_whole = true;
  whole.quiet = arguments.quiet;
  whole.program = arguments.program;
  return run_command(whole);
}

}  // namespace unbruised::studies
