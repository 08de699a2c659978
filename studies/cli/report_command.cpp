#include <system_error>

#include "studies/cli/commands.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/report/report_page.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

ReportContext context_of(const RecordedStudy& recorded, const std::string& program) {
  return {.replay_command = replay_command(recorded, program),
          .wanted = recorded.wanted,
          .source = recorded.source.string(),
          .digest = rows_digest(recorded.tables.rows),
          .summary = summary_lines(recorded.tables, recorded.meta.study_kind)};
}

/// Reads what is recorded and writes its page.
MaybeError write_report_of(const RecordedStudy& recorded, const fs::path& page, const std::string& program) {
  Trace trace;
  if (recorded.has_trace) {
    auto read = read_suspect_trace(recorded.source);
    if (!read) return read.error();
    trace = std::move(*read);
  }
  const ResultsContent content{.meta = recorded.meta,
                               .inputs = recorded.tables.inputs,
                               .rows = recorded.tables.rows,
                               .rows_of_search = false,
                               .tables = recorded.tables.found,
                               .window = recorded.tables.window ? &*recorded.tables.window : nullptr,
                               .trace = recorded.has_trace ? &trace : nullptr};
  return write_report(page, content, context_of(recorded, program));
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

int report_command(const fs::path& path, const std::optional<fs::path>& output, const std::string& program) {
  const auto recorded = read_recorded(path);
  if (!recorded) return report_error(recorded.error());
  const fs::path page = output ? *output : page_of(*recorded);
  if (const auto error = write_report_of(*recorded, page, program)) return report_error(*error);
  std::error_code unknown;
  print_line(joined(
      {"report: ", page.string(), " (", bytes_text(static_cast<double>(fs::file_size(page, unknown))), ")"}));
  return print_journal_state(*recorded);
}

std::optional<fs::path> write_report_of_run(const fs::path& directory, const std::string& program) {
  const fs::path page = directory / kReportName;
  const auto recorded = read_recorded(directory);
  const MaybeError error = recorded ? write_report_of(*recorded, page, program) : MaybeError(recorded.error());
  if (!error) return page;
  print_note(
      joined({"no report was written: ", error->message, "; `unbruised report ", shell_word(directory.string()),
              error->kind == ResultsErrorKind::not_built ? "` writes it then" : "` tries again"}));
  return std::nullopt;
}

}  // namespace unbruised::studies
