#include "studies/cli/shelf.hpp"

#include <algorithm>
#include <system_error>

#include "studies/cli/commands.hpp"
#include "studies/config/study.hpp"
#include "studies/findings/claims.hpp"
#include "studies/findings/summary.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// Folders that deep below the one asked for are looked at.
constexpr int kDeepest = 3;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

ShelfRun with_results(ShelfRun run) {
  auto summary = read_hashed_summary(run.directory / "results.h5");
  if (!summary) {
    run.state = "damaged";
    run.answer = summary.error().message;
    return run;
  }
  run.study = summary->meta.study_name;
  run.kind = summary->meta.study_kind;
  run.created_utc = summary->meta.created_utc;
  run.state = summary->meta.complete ? "complete" : "unfinished";
  const StudyTables tables{.inputs = std::move(summary->inputs),
                           .rows = std::move(summary->rows),
                           .window = std::move(summary->window),
                           .found = std::move(summary->tables),
                           .damage_note = damage_sentence(summary->meta)};
  run.answer = answer_line(tables, run.kind);
  return run;
}

/// A run that has no results yet is known by its config.
ShelfRun with_config(ShelfRun run) {
  run.state = "unfinished";
  run.answer = "no results yet";
  const auto config = read_text_file(run.directory / "config.toml");
  if (!config) return run;
  const StudyOrError study = read_study_text(*config, "config.toml", {}, run.directory, {});
  if (!study) return run;
  run.study = study->name();
  run.kind = study_kind_word(study->kind());
  return run;
}

void look_below(const fs::path& folder, int deepest, std::vector<ShelfRun>& runs) {
  const bool results = is_there(folder / "results.h5");
  if (results || is_there(folder / "config.toml")) {
    ShelfRun run;
    run.directory = folder;
    run.has_report = is_there(folder / kReportName);
    runs.push_back(results ? with_results(std::move(run)) : with_config(std::move(run)));
    return;
  }
  std::error_code error;
  if (deepest == 0) return;
  for (fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && at != end; at.increment(error)) {
    std::error_code unknown;
    if (at->is_directory(unknown) && !at->is_symlink(unknown)) look_below(at->path(), deepest - 1, runs);
  }
}

/// Says that a folder cannot be looked at; nothing where it can.
std::optional<int> refuse(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return std::nullopt;
  print_error(joined({folder.string(), is_there(folder) ? " is no folder" : " does not exist"}));
  return kExitInput;
}

}  // namespace

std::vector<ShelfRun> runs_below(const fs::path& folder) {
  std::vector<ShelfRun> runs;
  look_below(folder, kDeepest, runs);
  std::sort(runs.begin(), runs.end(),
            [](const ShelfRun& a, const ShelfRun& b) { return a.directory < b.directory; });
  return runs;
}

int shelf_command(const fs::path& folder) {
  if (const auto status = refuse(folder)) return *status;
  const std::vector<ShelfRun> runs = runs_below(folder);
  if (runs.empty()) print_line(joined({"no runs below ", folder.string()}));
  for (const ShelfRun& run : runs) {
    print_line(joined({run.directory.string(), ": ", run.study, run.kind.empty() ? "" : ", ", run.kind, ", ",
                       run.state, run.created_utc.empty() ? "" : ", ", run.created_utc}));
    print_line(joined({"  ", run.answer}));
    if (run.has_report) print_line(joined({"  ", (run.directory / kReportName).string()}));
  }
  return kExitDone;
}

int index_command(const fs::path& folder, const std::optional<fs::path>& output) {
  if (const auto status = refuse(folder)) return *status;
  const std::vector<ShelfRun> runs = runs_below(folder);
  const fs::path page = output ? *output : folder / "index.html";
  const fs::path base = page.parent_path().empty() ? fs::path(".") : page.parent_path();
  if (const auto error = write_shelf_page(page, runs, base)) return report_error(*error);
  print_line(joined(
      {"index: ", page.string(), " (", std::to_string(runs.size()), runs.size() == 1 ? " run)" : " runs)"}));
  return kExitDone;
}

}  // namespace unbruised::studies
