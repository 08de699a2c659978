#include "studies/cli/recorded.hpp"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>
#include <variant>

#include "studies/cli/commands.hpp"
#include "studies/cli/locations.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/journal.hpp"
#include "studies/results/results_file.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/text.hpp"
#include "studies/runner/scenario_set.hpp"
#include "studies/runner/study_runner.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

RecordedStudy from_summary(ResultsSummary summary, const fs::path& source) {
  return {.meta = std::move(summary.meta),
          .tables = {.inputs = std::move(summary.inputs),
                     .rows = std::move(summary.rows),
                     .window = std::move(summary.window),
                     .found = std::move(summary.tables)},
          .has_trace = summary.has_trace,
          .source = source,
          .from_journal = false,
          .wanted = std::nullopt};
}

/// The rows of all journals, by id; the first of each id counts.
Expected<std::vector<ScenarioRow>> journal_rows(const fs::path& directory, const std::string& config_sha256) {
  std::map<std::uint64_t, ScenarioRow> rows;
  for (const fs::path& file : journal_files(directory)) {
    auto scan = scan_journal(file, config_hash_prefix(config_sha256));
    if (!scan) return scan.error();
    for (const JournalRecord& record : scan->records) {
      if (record.kind != RecordKind::scenario) continue;
      if (auto row = decode_scenario_row(record.id, record.payload)) rows.try_emplace(record.id, std::move(*row));
    }
  }
  std::vector<ScenarioRow> sorted;
  for (auto& [id, row] : rows) sorted.push_back(std::move(row));
  return sorted;
}

Expected<RecordedStudy> from_journals(const fs::path& directory) {
  const auto config = read_text_file(directory / "config.toml");
  if (!config) return config.error();
  const StudyOrError read = read_study_text(*config, (directory / "config.toml").string(), {}, directory, {});
  if (const auto* error = std::get_if<ConfigError>(&read)) {
    return ResultsError{
        ResultsErrorKind::damaged,
        error->messages.empty() ? "the config of the run directory is damaged" : error->messages.front(),
        {}};
  }
  const Study& study = std::get<Study>(read);
  auto rows = journal_rows(directory, sha256_hex(*config));
  if (!rows) return rows.error();
  RecordedStudy recorded;
  recorded.meta = results_meta(study, false);
  recorded.meta.created_utc.clear();
  recorded.meta.unbruised_version.clear();
  recorded.tables.inputs = input_columns(study);
  recorded.tables.rows = std::move(*rows);
  if (is_search(study.kind())) number_search_rows(recorded.tables.rows);
  recorded.source = directory;
  recorded.from_journal = true;
  if (has_fixed_scenarios(study.kind())) recorded.wanted = scenario_set(study).count;
  return recorded;
}

Expected<RecordedStudy> from_directory(const fs::path& directory) {
  if (is_there(directory / "results.h5")) {
    auto summary = read_results_summary(directory / "results.h5");
    if (!summary) return summary.error();
    // Where results.h5 is not complete, the journal may know more.
    if (summary->meta.complete || !is_there(directory / "config.toml")) {
      return from_summary(std::move(*summary), directory / "results.h5");
    }
  }
  if (is_there(directory / "config.toml")) return from_journals(directory);
  return ResultsError{
      ResultsErrorKind::foreign,
      joined({directory.string(), " is no run directory: it holds neither results.h5 nor config.toml"}),
      {}};
}

}  // namespace

Expected<RecordedStudy> read_recorded(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return from_directory(path);
  if (!is_there(path))
    return ResultsError{ResultsErrorKind::foreign, joined({path.string(), " does not exist"}), {}};
  auto summary = read_results_summary(path);
  if (!summary) return summary.error();
  return from_summary(std::move(*summary), path);
}

fs::path directory_of(const RecordedStudy& recorded) {
  const fs::path directory = recorded.from_journal ? recorded.source : recorded.source.parent_path();
  return directory.empty() ? fs::path(".") : directory;
}

std::string replay_command(const RecordedStudy& recorded, const std::string& program) {
  const fs::path directory = directory_of(recorded);
  const fs::path config = directory / "config.toml";
  if (!is_there(config)) return {};
  return joined({shell_word(program), " run ", shell_word(config.string()), " --output ",
                 shell_word(directory.string()), " --scenario"});
}

std::optional<ScenarioRow> recorded_row(const fs::path& directory, const Study& study, std::uint64_t id) {
  if (!is_there(directory)) return std::nullopt;
  const auto recorded = read_recorded(directory);
  if (!recorded || recorded->meta.config_toml != study.resolved_toml()) return std::nullopt;
  const std::vector<ScenarioRow>& rows = recorded->tables.rows;
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const ScenarioRow& row) { return row.id == id; });
  if (found == rows.end() || found->result.outcome == Outcome::not_run) return std::nullopt;
  return *found;
}

}  // namespace unbruised::studies
