#include <algorithm>

#include "studies/cli/commands.hpp"
#include "studies/cli/export_program.hpp"
#include "studies/cli/interrupt.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/cli/replays.hpp"
#include "studies/findings/flat_table.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/findings/trace_curves.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/results/paged_file.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/results/vtkhdf_file.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// Says which tables there are.
int unknown_table(const ExportArguments& arguments, const std::vector<std::string>& names) {
  print_error(joined(
      {"--table ", arguments.table, ": ", arguments.path.string(), " holds the tables ", comma_list(names)}));
  return kExitInput;
}

/// The file a scenario's trace stands in: a results file itself, or scenario_ID.h5 of a run directory.
fs::path trace_file(const ExportArguments& arguments) {
  std::error_code unknown;
  if (!fs::is_directory(arguments.path, unknown)) return arguments.path;
  return arguments.path / joined({"scenario_", std::to_string(arguments.scenario.value()), ".h5"});
}

int write_table(const ExportArguments& arguments, const ResultTable& table, const fs::path& beside) {
  const fs::path file = arguments.output ? *arguments.output : beside;
  if (file == "-") {
    print_text(csv_text(table));
    return kExitDone;
  }
  if (const auto error = write_text_file(file, csv_text(table))) return report_error(*error);
  print_line(joined({"table: ", file.string(), " (", table.name, ": ", with_thousands(row_count(table)), " rows, ",
                     std::to_string(table.columns.size()), " columns)"}));
  return kExitDone;
}

/// A table of a study, a part of it in memory at a time.
int write_rows(const ExportArguments& arguments, const RecordedStudy& recorded) {
  const std::string& name = arguments.table;
  const StudyTables& tables = recorded.tables;
  const fs::path file = arguments.output ? *arguments.output : directory_of(recorded) / joined({name, ".csv"});
  if (file == "-") {
    csv_in_pieces(tables, name, [](std::string_view piece) { print_text(std::string(piece)); });
    return kExitDone;
  }
  PagedFile pages(file);
  const std::size_t columns =
      csv_in_pieces(tables, name, [&pages](std::string_view piece) { pages.append(piece); });
  MaybeError error = pages.finish();
  if (!error) error = pages.publish();
  if (error) return report_error(*error);
  const std::size_t rows = name == "scenarios" ? tables.rows.size() : row_count(table_called(tables, name));
  print_line(joined({"table: ", file.string(), " (", name, ": ", with_thousands(rows), " rows, ",
                     std::to_string(columns), " columns)"}));
  return kExitDone;
}

int export_trace(const ExportArguments& arguments) {
  const fs::path source = trace_file(arguments);
  std::error_code unknown;
  if (!fs::exists(source, unknown)) {
    print_error(joined({source.string(), " is not there: `unbruised run STUDY.toml --scenario ",
                        std::to_string(arguments.scenario.value()), "` records the trace first"}));
    return kExitInput;
  }
  const auto trace = read_suspect_trace(source);
  if (!trace) return report_error(trace.error());
  return write_table(arguments, trace_as_table(*trace), fs::path(source).replace_extension(".csv"));
}

/// The scenario asked for, or the only one there is, run again for ParaView.
int export_motion(const ExportArguments& arguments) {
  const auto recorded = read_recorded(arguments.path);
  if (!recorded) return report_error(recorded.error());
  const bool is_single = recorded->tables.rows.size() == 1;
  if (!arguments.scenario && !is_single) {
    print_error("--format vtkhdf shows one scenario in motion: name it with --scenario ID");
    return kExitInput;
  }
  const std::uint64_t id = arguments.scenario.value_or(is_single ? recorded->tables.rows.front().id : 0);
  const fs::path file = arguments.output
                            ? *arguments.output
                            : directory_of(*recorded) / joined({"scenario_", std::to_string(id), ".vtkhdf"});
  if (file == "-") {
    print_error("--format vtkhdf is no text: name a file with -o");
    return kExitInput;
  }
  listen_for_interrupts();
  const auto seen = replay_of(*recorded, id);
  if (!seen) {
    if (const int status = interrupt_exit_status(); status != 0) return status;
    print_error(joined({"--scenario ", std::to_string(id), ": ", arguments.path.string(),
                        " holds no scenario of this number that can be run again"}));
    return kExitInput;
  }
  if (const auto error = write_vtkhdf(file, seen->replay)) return report_error(*error);
  print_line(joined({"motion: ", file.string(), " (scenario ", std::to_string(id), ", ",
                     std::to_string(seen->replay.frame_count()), " steps, ",
                     with_thousands(seen->replay.vertex_m.size()), " places on the product)"}));
  return kExitDone;
}

}  // namespace

int export_command(const ExportArguments& arguments) {
  if (arguments.format == "vtkhdf") return export_motion(arguments);
  if (is_program_format(arguments.format)) return export_program(arguments);
  if (arguments.format != "csv") {
    print_error(joined({"--format ", arguments.format,
                        ": this build writes csv, vtkhdf, joint_trajectory, urscript, rapid and krl. Parquet "
                        "needs Apache Arrow, which Debian 12 does not "
                        "have; pandas makes "
                        "it from the csv: pandas.read_csv(FILE).to_parquet(...)"}));
    return kExitInput;
  }
  if (arguments.table == kPathTable) return export_program(arguments);
  if (arguments.scenario) return export_trace(arguments);
  const auto recorded = read_recorded(arguments.path);
  if (!recorded) return report_error(recorded.error());
  const std::vector<std::string> names = table_names_of(recorded->tables);
  if (std::find(names.begin(), names.end(), arguments.table) == names.end())
    return unknown_table(arguments, names);
  const int status = write_rows(arguments, *recorded);
  return status == kExitDone ? print_journal_state(*recorded) : status;
}

}  // namespace unbruised::studies
