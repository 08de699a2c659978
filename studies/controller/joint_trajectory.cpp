#include <cmath>

#include "core/door/require.hpp"
#include "studies/controller/program_text.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Controllers put a polynomial of fifth order through positions, speeds and accelerations of two points.
constexpr double kStep_s = 0.02;

std::string duration(double time_s) {
  const auto nanoseconds = static_cast<long long>(std::llround(time_s * 1e9));
  return joined({"{sec: ", std::to_string(nanoseconds / 1'000'000'000),
                 ", nanosec: ", std::to_string(nanoseconds % 1'000'000'000), "}"});
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string point_text(const ProgramPoint& point) {
  return joined({"    - positions: [", number_list(point.arm.angle_rad, 9), "]\n      velocities: [",
                 number_list(point.arm.speed_rad_s, 9), "]\n      accelerations: [",
                 number_list(point.arm.acceleration_rad_s2, 9),
                 "]\n      effort: []\n      time_from_start: ", duration(point.time_s), "\n"});
}

/// The fields of GripperCommand stand in `command`; a controller of it knows no speed, no ramp and no contact.
std::string command_text(const GripCommand& command, double opening_m) {
  const bool opens = command.kind == GripCommand::Kind::open;
  return joined({"  - time_from_start: ", duration(command.time_s), "\n    word: ", word_of(command.kind),
                 "\n    command: {position: ", fixed_digits(opens ? opening_m : 0.0, 6), ", max_effort: ",
                 fixed_digits(command.force_N, 6), "}\n    speed_m_s: ", fixed_digits(command.speed_m_s, 6),
                 "\n    ramp_s: ", fixed_digits(command.ramp_s, 6),
                 "\n    waits_for_contact: ", command.waits_for_contact ? "true" : "false", "\n"});
}

}  // namespace

ProgramFile joint_trajectory(const HandlingProgram& program, const ProgramHead& head,
                             const std::vector<std::string>& joint_names) {
  require(joint_names.size() == program.scenario().robot.joint.size(), "joint_trajectory: a name for each joint");
  std::vector<std::string> lines = head.lines;
  lines.emplace_back(
      "joint_trajectory: trajectory_msgs/JointTrajectory. gripper_commands: each `command` is a "
      "control_msgs/GripperCommand (position: distance of the pads in m, max_effort: N of each finger), to be "
      "sent "
      "at its time; one that waits for contact when a finger touches, at the time as simulated");
  std::string text = comment_lines(lines, "#");
  text += joined({"joint_trajectory:\n  header: {stamp: {sec: 0, nanosec: 0}, frame_id: \"\"}\n  joint_names: [",
                  comma_list(joint_names, quoted), "]\n  points:\n"});
  for (const ProgramPoint& point : program.points(program.times(0.0, program.end_s(), kStep_s))) {
    text += point_text(point);
  }
  text += "gripper_commands:\n";
  for (const GripCommand& command : program.commands()) text += command_text(command, program.opening_m());
  return {".yaml", text};
}

}  // namespace unbruised::studies
