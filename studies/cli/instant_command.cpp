#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/motion/handling_cycle.hpp"
#include "studies/cli/commands.hpp"
#include "studies/cli/json_output.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/findings/trace_curves.hpp"
#include "studies/results/suspect_results.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

/// The command that records the trace of a scenario of a run directory.
std::string recording_command(const RecordedStudy& recorded, const InstantArguments& arguments) {
  const std::string replay = replay_command(recorded, arguments.program);
  return joined({replay.empty() ? joined({shell_word(arguments.program), " run STUDY.toml --scenario"}) : replay,
                 " ", arguments.scenario ? std::to_string(*arguments.scenario) : "ID"});
}

/// The file with the trace that is asked about; says which command makes it where there is none.
std::optional<fs::path> trace_file(const InstantArguments& arguments, int& status) {
  const fs::path& path = arguments.path;
  std::error_code unknown;
  const bool is_directory = fs::is_directory(path, unknown);
  if (arguments.scenario) {
    const fs::path file = path / joined({"scenario_", std::to_string(*arguments.scenario), ".h5"});
    if (is_directory && is_there(file)) return file;
  }
  const auto recorded = read_recorded(path);
  if (!recorded) {
    status = report_error(recorded.error());
    return std::nullopt;
  }
  const bool is_meant = !arguments.scenario || (recorded->tables.rows.size() == 1 &&
                                                recorded->tables.rows.front().id == *arguments.scenario);
  if (recorded->has_trace && is_meant) return recorded->source;
  status = kExitInput;
  if (!is_directory) {
    print_error(joined({path.string(), recorded->has_trace ? " holds the trace of another scenario"
                                                           : " holds no trace; a scenario_ID.h5 does"}));
  } else if (arguments.scenario) {
    print_error(joined({path.string(), " holds no trace of scenario ", std::to_string(*arguments.scenario),
                        " yet; this makes it: ", recording_command(*recorded, arguments)}));
  } else {
    print_error(
        joined({path.string(), " holds no trace of its own; --scenario ID picks one that was recorded by: ",
                recording_command(*recorded, arguments)}));
  }
  return std::nullopt;
}

/// "1.234 N"; a phase by its word.
std::string value_text(const TraceSignal& signal, double value) {
  if (std::isnan(value)) return "none";
  if (signal.name == "phase") {
    const auto code = static_cast<std::size_t>(std::max(0.0, value));
    if (code < kCyclePhaseWords.size()) return std::string(kCyclePhaseWords[code]);
  }
  return joined({short_number(value), signal.units == "1" ? "" : " ", signal.units == "1" ? "" : signal.units});
}

void print_instant(const TraceInstant& instant, const fs::path& source) {
  const auto seconds = [](double value) { return joined({nine_digits(value), " s"}); };
  print_line(joined({source.string(), " at ", seconds(instant.time_s),
                     instant.before_s == instant.after_s
                         ? std::string(", which is a row of the trace")
                         : joined({": straight lines between the rows at ", seconds(instant.before_s), " and ",
                                   seconds(instant.after_s), "; phase and counts are those of the first"})}));
  for (const TraceSignal& signal : instant.signals) {
    for (std::size_t entry = 0; entry < signal.values.size(); ++entry) {
      const std::string curve = curve_name(signal, entry);
      print_line(joined({"  ", signal.name, curve.empty() ? "" : joined({" [", curve, "]"}), " = ",
                         value_text(signal, signal.values[entry])}));
    }
  }
}

}  // namespace

int instant_command(const InstantArguments& arguments, AnswerForm form) {
  int status = kExitDone;
  const std::optional<fs::path> source = trace_file(arguments, status);
  if (!source) return status;
  const auto trace = read_suspect_trace(*source);
  if (!trace) return report_error(trace.error());
  const std::optional<TraceInstant> instant = trace_at(*trace, arguments.time_s);
  if (!instant) {
    if (trace->time_s.empty()) {
      print_error(joined({source->string(), ": its trace has no rows"}));
    } else {
      print_error(joined({"--at ", nine_digits(arguments.time_s), ": must be ", nine_digits(trace->time_s.front()),
                          " to ", nine_digits(trace->time_s.back()), " s, from the start to the end of the run"}));
    }
    return kExitInput;
  }
  if (form == AnswerForm::json) {
    print_line(instant_json(*instant, source->string()));
  } else {
    print_instant(*instant, *source);
  }
  return kExitDone;
}

}  // namespace unbruised::studies
