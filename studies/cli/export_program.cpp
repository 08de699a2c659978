#include "studies/cli/export_program.hpp"

#include <algorithm>
#include <cmath>

#include "studies/cli/recorded.hpp"
#include "studies/cli/replays.hpp"
#include "studies/controller/program_text.hpp"
#include "studies/execution/arm_run.hpp"
#include "studies/findings/replay_choice.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/report/page_rows.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// The scenario of the answer: of a search its best, else the first that the report shows.
std::optional<std::uint64_t> answered_scenario(const RecordedStudy& recorded) {
  if (const ResultTable* best = find_table(recorded.tables.found, "best")) {
    const double id = number_in(*best, "scenario", 0);
    if (id >= 0.0) return static_cast<std::uint64_t>(id);
  }
  const auto chosen = chosen_replays(recorded.tables.inputs, page_rows(recorded.tables.rows, {}), {});
  return chosen.empty() ? std::nullopt : std::optional(chosen.front().id);
}

int refuse(const std::string& sentence) {
  print_error(sentence);
  return kExitInput;
}

/// "joint_0", "joint_1", ... where none are given.
std::vector<std::string> names_of_joints(const ExportArguments& arguments, const Scenario& scenario) {
  if (!arguments.joint_names.empty()) return arguments.joint_names;
  std::vector<std::string> names;
  for (std::size_t j = 0; j < scenario.robot.joint.size(); ++j)
    names.push_back(joined({"joint_", std::to_string(j)}));
  return names;
}

/// What of the arm stands against the format; empty: nothing.
std::string arm_problem(const ExportArguments& arguments, const Scenario& scenario) {
  if (arguments.format != kJointTrajectory) {
    return arguments.joint_names.empty() ? std::string()
                                         : joined({"--joint-names goes with --format ", kJointTrajectory});
  }
  if (!has_robot(scenario)) {
    return joined(
        {"--format ", kJointTrajectory,
         " is of an arm's joints, and the study has no [robot]; csv, urscript, rapid and krl say where the "
         "palm goes"});
  }
  const std::size_t joints = scenario.robot.joint.size(), names = arguments.joint_names.size();
  if (names == 0 || names == joints) return {};
  return joined({"--joint-names: there are ", std::to_string(names), ", and the arm has ", std::to_string(joints),
                 " joints"});
}

std::vector<ProgramFile> files_of(const ExportArguments& arguments, const HandlingProgram& program,
                                  const ProgramHead& head) {
  if (arguments.format == kJointTrajectory) {
    return {joint_trajectory(program, head, names_of_joints(arguments, program.scenario()))};
  }
  if (arguments.format == "urscript") return {urscript_program(program, head)};
  if (arguments.format == "rapid") return {rapid_program(program, head)};
  if (arguments.format == "krl") return krl_program(program, head);
  return {path_csv(program, head)};
}

/// Beside the results, or where it was asked for; several files have one name and endings of their own.
int write(const ExportArguments& arguments, const fs::path& beside, const std::vector<ProgramFile>& files) {
  if (arguments.output == "-") {
    if (files.size() > 1)
      return refuse(joined({"--format ", arguments.format, " is two files: name one with -o"}));
    print_text(files.front().text);
    return kExitDone;
  }
  for (const ProgramFile& file : files) {
    const bool named = arguments.output && files.size() == 1;
    fs::path path = arguments.output.value_or(beside);
    if (!named) path.replace_extension(file.ending);
    if (const auto error = write_text_file(path, file.text)) return report_error(*error);
    print_line(joined({"path: ", path.string()}));
  }
  return kExitDone;
}

/// @return nothing where a sentence has said why there is none
std::optional<HandlingProgram> program_of(const Scenario& scenario, const ScenarioRow& row) {
  const auto says = [&](std::string_view why) {
    print_error(joined({"--scenario ", std::to_string(row.id), ": ", why}));
    return std::nullopt;
  };
  const double lift_time_s = row.result.metrics[Metric::lift_time_s];
  if (!has_gripper(scenario) || std::isnan(lift_time_s)) {
    return says(joined({"nothing was lifted (", outcome_word(row.result.outcome),
                        "), so there is no path to take to a "
                        "controller"}));
  }
  if (!has_robot(scenario)) return HandlingProgram(scenario, lift_time_s);
  const TimedScenario timed = timed_for_arm(scenario);
  if (timed.ride.breach) return says(words_of(*timed.ride.breach) + ", so no controller could follow");
  return HandlingProgram(timed.scenario, lift_time_s);
}

}  // namespace

bool is_program_format(std::string_view format) {
  const auto& formats = kProgramFormats;
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

int export_program(const ExportArguments& arguments) {
  const auto recorded = read_recorded(arguments.path);
  if (!recorded) return report_error(recorded.error());
  const std::optional<std::uint64_t> id = arguments.scenario ? arguments.scenario : answered_scenario(*recorded);
  const std::optional<ScenarioRow> row = id ? recorded_row(*recorded, *id) : std::nullopt;
  const std::optional<Scenario> scenario = row ? recorded_scenario(*recorded, row->id) : std::nullopt;
  if (!scenario) {
    return refuse(joined({"--scenario ", id ? std::to_string(*id) : "", ": ", arguments.path.string(),
                          " holds no scenario of this number that can be run again"}));
  }
  if (const std::string problem = arm_problem(arguments, *scenario); !problem.empty()) return refuse(problem);
  const auto program = program_of(*scenario, *row);
  if (!program) return kExitInput;
  if (row->result.outcome != Outcome::held) {
    print_note(
        joined({"warning: scenario ", std::to_string(row->id), " was ", outcome_word(row->result.outcome)}));
  }
  // A controller may want a program and its file to have one name.
  const bool is_named = arguments.output && *arguments.output != "-";
  const std::string name = is_named ? program_name(arguments.output->stem().string())
                                    : program_name(recorded->meta.study_name, row->id);
  const ProgramHead head = head_of({.name = name,
                                    .study = recorded->meta.study_name,
                                    .scenario_id = row->id,
                                    .outcome = std::string(outcome_word(row->result.outcome)),
                                    .inputs = inputs_text(recorded->tables.inputs, row->inputs),
                                    .config_sha256 = sha256_hex(recorded->meta.config_toml),
                                    .digest = rows_digest(recorded->tables.rows)},
                                   program->scenario());
  const fs::path beside = directory_of(*recorded) / joined({name, ".csv"});
  return write(arguments, beside, files_of(arguments, *program, head));
}

}  // namespace unbruised::studies
