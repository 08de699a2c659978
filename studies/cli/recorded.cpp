#include "studies/cli/recorded.hpp"

#include <system_error>
#include <utility>
#include <variant>

#include "studies/cli/commands.hpp"
#include "studies/config/locations.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/findings/claims.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/kinds/study_results.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/journal_index.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

RecordedStudy from_summary(ResultsSummary summary, const fs::path& source) {
  const std::string damage_note = damage_sentence(summary.meta);
  return {.meta = std::move(summary.meta),
          .tables = {.inputs = std::move(summary.inputs),
                     .rows = std::move(summary.rows),
                     .window = std::move(summary.window),
                     .found = std::move(summary.tables),
                     .damage_note = damage_note},
          .has_trace = summary.has_trace,
          .source = source,
          .from_journal = false,
          .notes = {},
          .damage = {},
          .wanted = std::nullopt};
}

/// What the journals of a run directory hold.
struct JournalContents {
  JournalIndex index;
  std::vector<std::string> notes;
  std::vector<std::string> damage;
};

void look_at(const JournalFindings& findings, JournalContents& contents) {
  const std::string file = findings.path.string();
  if (findings.state.torn_tail_bytes > 0) {
    contents.notes.push_back(joined(
        {file, " ends in ", std::to_string(findings.state.torn_tail_bytes), " bytes of an unfinished record"}));
  }
  for (const JournalDamage& damage : findings.state.damage) {
    contents.damage.push_back(joined({file, ": ", std::to_string(damage.bytes), " bytes at offset ",
                                      std::to_string(damage.offset), " fail their checksum"}));
  }
  if (findings.state.other_config_records > 0) {
    contents.damage.push_back(joined({file, ": ", std::to_string(findings.state.other_config_records),
                                      " records belong to another config than config.toml"}));
  }
  for (const std::string& row : findings.misshapen) contents.damage.push_back(joined({file, ": ", row}));
}

Expected<JournalContents> journal_contents(const fs::path& directory, const std::string& config_sha256) {
  JournalContents contents;
  for (const fs::path& file : journal_files(directory)) {
    const auto findings = contents.index.add(file, config_hash_prefix(config_sha256));
    if (!findings) return findings.error();
    look_at(*findings, contents);
  }
  if (const auto twice = contents.index.settle(); !twice) return twice.error();
  return contents;
}

Expected<Study> study_of(const fs::path& directory, const std::string& config) {
  StudyOrError read = read_study_text(config, (directory / "config.toml").string(), {}, directory, {});
  if (read) return *std::move(read);
  const std::vector<std::string>& messages = read.error().messages;
  return ResultsError{ResultsErrorKind::damaged,
                      joined({"the config of the run directory is damaged: ",
                              messages.empty() ? directory.string() : messages.front()}),
                      {}};
}

/// Brings results.h5 up to date where nobody else does. Nothing is lost when that fails: the journals are the
/// truth.
void compact(const fs::path& directory, const Study& study, RecordedStudy& recorded) {
  auto run = RunDirectory::open_for_compaction(directory);
  if (!run) return;
  if (auto error = (*run)->finish(unfinished_content(study, **run, recorded.meta.warnings))) {
    recorded.notes.push_back(joined({"results.h5 stays as it is: ", error->message}));
    return;
  }
  recorded.notes.push_back(joined({"brought ", (*run)->results_path().string(), " up to date from the journal"}));
}

/// @param known rows that results.h5 holds
Expected<RecordedStudy> from_journals(const fs::path& directory, std::size_t known) {
  const auto config = read_text_file(directory / "config.toml");
  if (!config) return config.error();
  const auto study = study_of(directory, *config);
  if (!study) return study.error();
  auto contents = journal_contents(directory, sha256_hex(*config));
  if (!contents) return contents.error();
  RecordedStudy recorded;
  recorded.meta = results_meta(*study, study_warnings(*study), ResultsState::unfinished);
  recorded.meta.created_utc.clear();
  recorded.meta.unbruised_version.clear();
  recorded.tables.damage_note = damage_sentence(recorded.meta);
  recorded.tables.inputs = input_columns(*study);
  recorded.tables.rows = contents->index.rows(row_places(study->kind()));
  recorded.notes = std::move(contents->notes);
  recorded.damage = std::move(contents->damage);
  recorded.source = directory;
  recorded.from_journal = true;
  if (has_fixed_scenarios(study->kind())) recorded.wanted = scenario_set(*study).count;
  const std::size_t rows = recorded.tables.rows.size();
  if (rows > known && rows <= kRowsCompactedMost && recorded.damage.empty()) compact(directory, *study, recorded);
  return recorded;
}

/// Says of a damaged results.h5 what the journals still have.
ResultsError with_what_is_left(ResultsError error, const fs::path& directory) {
  const auto config = read_text_file(directory / "config.toml");
  if (!config) return error;
  const auto contents = journal_contents(directory, sha256_hex(*config));
  if (!contents || contents->index.size() == 0) return error;
  error.message += joined({"; the journal holds ", std::to_string(contents->index.size()),
                           " whole scenarios; the `run` command of this study writes results.h5 anew from it"});
  return error;
}

Expected<RecordedStudy> from_directory(const fs::path& directory) {
  std::size_t known = 0;
  if (is_there(directory / "results.h5")) {
    auto summary = read_hashed_summary(directory / "results.h5");
    if (!summary) return with_what_is_left(summary.error(), directory);
    // Where results.h5 is not complete, the journal may know more.
    if (summary->meta.complete || !is_there(directory / "config.toml")) {
      return from_summary(std::move(*summary), directory / "results.h5");
    }
    known = summary->rows_run;
  }
  if (is_there(directory / "config.toml")) return from_journals(directory, known);
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
  auto summary = read_hashed_summary(path);
  if (!summary) return summary.error();
  return from_summary(std::move(*summary), path);
}

int print_journal_state(const RecordedStudy& recorded) {
  for (const std::string& note : recorded.notes) print_note(note);
  if (recorded.damage.empty()) return kExitDone;
  for (const std::string& damage : recorded.damage) print_error(joined({"damage: ", damage}));
  print_note("damaged records are left out; the `run` command of this study runs their scenarios again");
  return exit_status(ResultsErrorKind::damaged);
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

std::optional<ScenarioRow> recorded_row(const RecordedStudy& recorded, std::uint64_t id) {
  const StudyRows& rows = recorded.tables.rows;
  // Where none is left out an id is a place.
  if (id < rows.size()) {
    if (ScenarioRow row = rows.at(id); row.id == id) return row;
  }
  for (const ScenarioRow& row : rows) {
    if (row.id == id) return row;
  }
  return std::nullopt;
}

std::optional<ScenarioRow> recorded_row(const fs::path& directory, const Study& study, std::uint64_t id) {
  if (!is_there(directory)) return std::nullopt;
  const auto recorded = read_recorded(directory);
  if (!recorded || recorded->meta.config_toml != study.resolved_toml()) return std::nullopt;
  const std::optional<ScenarioRow> row = recorded_row(*recorded, id);
  return row && row->result.outcome != Outcome::not_run ? row : std::nullopt;
}

}  // namespace unbruised::studies
