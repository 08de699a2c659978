#include <system_error>

#include "studies/cli/commands.hpp"
#include "studies/cli/interrupt.hpp"
#include "studies/cli/measured.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/cli/replays.hpp"
#include "studies/report/page_rows.hpp"
#include "studies/report/report_page.hpp"
#include "studies/report/sound.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

ReportContext context_of(const RecordedStudy& recorded, const ReportArguments& arguments) {
  return {.replay_command = replay_command(recorded, arguments.program),
          .wanted = recorded.wanted,
          .source = recorded.source.string(),
          .digest = rows_digest(recorded.tables.rows),
          .summary = summary_lines(recorded.tables, recorded.meta.study_kind),
          .replays = {}};
}

/// The sound of the scenario that is shown first.
MaybeError write_audio(const std::vector<ScenarioReplay>& replays, const fs::path& file) {
  if (replays.empty()) {
    return ResultsError{
        ResultsErrorKind::foreign, "no scenario can be run again, so there is nothing to hear", {}};
  }
  const ScenarioReplay& first = replays.front();
  if (auto error = write_text_file(file, wav_of(first, sound_map(replays)))) return error;
  print_line(joined({"audio: ", file.string(), " (scenario ", std::to_string(first.id), ", ", first.why, ")"}));
  return std::nullopt;
}

/// Reads what is recorded and writes its page, and its sound where that is asked for.
MaybeError write_report_of(const RecordedStudy& recorded, const fs::path& page, const ReportArguments& arguments) {
  Trace trace;
  if (recorded.has_trace) {
    auto read = read_suspect_trace(recorded.source);
    if (!read) return read.error();
    trace = std::move(*read);
  }
  ReportContext context = context_of(recorded, arguments);
  const StudyRows& rows = recorded.tables.rows;
  RecordedStudy shown = recorded;  // of millions a choice, from which those in motion are chosen too
  shown.tables.rows = page_rows(rows, arguments.scenarios);
  if (arguments.moving) context.replays = replays_of(shown, arguments.scenarios);
  ResultsContent content{.meta = recorded.meta,
                         .inputs = recorded.tables.inputs,
                         .rows = shown.tables.rows.held(),
                         .places = RowPlaces::none,
                         .tables = recorded.tables.found,
                         .window = recorded.tables.window ? &*recorded.tables.window : nullptr,
                         .trace = recorded.has_trace ? &trace : nullptr};
  if (std::string note = page_rows_note(content.rows.size(), rows.size()); !note.empty()) {
    print_note(note);
    content.meta.warnings.push_back(std::move(note));
  }
  if (arguments.measured) {
    auto measured = read_measured_forces(*arguments.measured);
    if (!measured) return measured.error();
    context.measured = std::move(*measured);
    if (content.window == nullptr) {
      print_note("the study has no window, so the measured forces are not on its page");
    }
  }
  if (arguments.audio) {
    if (auto error = write_audio(context.replays, *arguments.audio)) return error;
  }
  return write_report(page, content, context);
}

/// report.html of the run directory; `scenario_17.html` beside scenario_17.h5.
fs::path page_of(const RecordedStudy& recorded) {
  if (recorded.from_journal || recorded.source.filename() == "results.h5") {
    const fs::path directory = recorded.from_journal ? recorded.source : recorded.source.parent_path();
    return directory / kReportName;
  }
  return fs::path(recorded.source).replace_extension(".html");
}

}  // namespace

int report_command(const ReportArguments& arguments) {
  const auto recorded = read_recorded(arguments.path);
  if (!recorded) return report_error(recorded.error());
  listen_for_interrupts();
  const fs::path page = arguments.output ? *arguments.output : page_of(*recorded);
  if (const auto error = write_report_of(*recorded, page, arguments)) return report_error(*error);
  std::error_code unknown;
  print_line(joined(
      {"report: ", page.string(), " (", bytes_text(static_cast<double>(fs::file_size(page, unknown))), ")"}));
  return print_journal_state(*recorded);
}

std::optional<fs::path> write_report_of_run(const fs::path& directory, const std::string& program, bool moving) {
  const fs::path page = directory / kReportName;
  const auto recorded = read_recorded(directory);
  const MaybeError error =
      recorded ? write_report_of(*recorded, page, {.path = directory, .program = program, .moving = moving})
               : MaybeError(recorded.error());
  if (!error) return page;
  print_note(
      joined({"no report was written: ", error->message, "; `unbruised report ", shell_word(directory.string()),
              error->kind == ResultsErrorKind::not_built ? "` writes it then" : "` tries again"}));
  return std::nullopt;
}

}  // namespace unbruised::studies
