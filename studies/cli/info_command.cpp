#include "studies/cli/commands.hpp"
#include "studies/cli/json_output.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/findings/rests_on.hpp"
#include "studies/results/row_summary.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

std::size_t rows_run(const StudyTables& tables) {
  return tables.rows.size() - tables.rows.seen().outcomes.not_run;
}

std::string state_line(const RecordedStudy& recorded) {
  const std::string done = with_thousands(rows_run(recorded.tables));
  std::string text = joined({recorded.meta.study_name, ": ", recorded.meta.study_kind, ", "});
  if (recorded.meta.complete) return text + joined({"complete, ", done, done == "1" ? " scenario" : " scenarios"});
  text += joined({"not complete, ", done});
  if (recorded.wanted) text += joined({" of ", with_thousands(*recorded.wanted)});
  return text + " scenarios so far";
}

void print_origin(const RecordedStudy& recorded) {
  if (!recorded.meta.unbruised_version.empty()) {
    print_line(joined({"written by unbruised ", recorded.meta.unbruised_version, " (", recorded.meta.compiler,
                       ", ", recorded.meta.instruction_set, ") ", recorded.meta.created_utc}));
  }
  const std::string keys = comma_list(recorded.tables.inputs, [](const ColumnInfo& column) { return column.key; });
  if (!keys.empty()) print_line(joined({"varied: ", keys}));
  if (recorded.has_trace) print_line("with the trace of its scenario (/trace)");
}

/// A run directory replays from its own resolved config.
void print_replay(const RecordedStudy& recorded, const std::string& program) {
  const std::string command = replay_command(recorded, program);
  if (command.empty()) return;
  for (const std::string& line : replay_lines(recorded.tables, command)) print_line(line);
}

}  // namespace

int info_command(const std::filesystem::path& path, const std::string& program, AnswerForm form) {
  const auto recorded = read_recorded(path);
  if (!recorded) return report_error(recorded.error());
  if (form == AnswerForm::json) {
    print_line(info_json(*recorded, program));
    return print_journal_state(*recorded);
  }
  print_line(state_line(*recorded));
  print_origin(*recorded);
  for (const std::string& warning : recorded->meta.warnings) print_line(joined({"warning: ", warning}));
  for (const std::string& line : summary_lines(recorded->tables, recorded->meta.study_kind)) print_line(line);
  if (std::string line = rests_on_line(value_counts(recorded->meta.config_toml)); !line.empty()) print_line(line);
  print_replay(*recorded, program);
  print_line(
      joined({recorded->from_journal ? "read from the journal of " : "results: ", recorded->source.string()}));
  print_line(joined({"digest ", rows_digest(recorded->tables.rows)}));
  return print_journal_state(*recorded);
}

}  // namespace unbruised::studies
