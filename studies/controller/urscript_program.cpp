#include <algorithm>
#include <cmath>

#include "studies/controller/program_text.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr double kCycle_s = 2e-3;  // of an e-Series controller
constexpr int kStepCycles = 4;     // of a servo step

constexpr std::string_view kGripper =
    "  # What your gripper is told: fill these in. Speeds are of each finger in m/s, forces of each finger in N.\n"
    "  def grip_close(speed, force):\n    textmsg(\"grip_close\")\n  end\n"
    "  def grip_wait_for_contact():  # returns when a finger touches\n    textmsg(\"grip_wait_for_contact\")\n  "
    "end\n"
    "  def grip_force(force, ramp):  # rises to it in `ramp` s; returns at once\n    textmsg(\"grip_force\")\n  "
    "end\n"
    "  def grip_lock():  # holds the fingers where they are\n    textmsg(\"grip_lock\")\n  end\n"
    "  def grip_open(speed):\n    textmsg(\"grip_open\")\n  end\n";

std::string call_line(const GripCommand& command) {
  return joined({"  ", grip_call(command), "  # ", fixed_digits(command.time_s, 6), " s\n"});
}

int cycle_of(const GripCommand& command, const ProgramMove& move) {
  return static_cast<int>(std::lround((command.time_s - move.start_s) / kCycle_s));
}

bool has_six_joints(const HandlingProgram& program) { return program.scenario().robot.joint.size() == 6; }

std::string pose_text(const Pose& pose) {
  return joined({"p[", number_list(pose.place_m, 9), ", ", number_list(rotation_to(pose.attitude), 9), "]"});
}

std::string target(const HandlingProgram& program, const ProgramPoint& point) {
  if (has_six_joints(program)) return joined({"[", number_list(point.arm.angle_rad, 9), "]"});
  return joined({"get_inverse_kin(pose_trans(cell, ", pose_text(program.palm_from_base(point.palm)), "))"});
}

std::string frames(const HandlingProgram& program) {
  const RobotParameters& robot = program.scenario().robot;
  std::string text;
  if (!has_robot(program.scenario())) {
    text +=
        "  # To be taught: the support's plane under the product's middle at the start, x along the grip axis.\n";
    text += "  cell = p[0, 0, 0, 0, 0, 0]\n";
    text += "  # To be measured: the middle between the pads from the flange, x along the grip axis, z up.\n";
  } else if (!has_six_joints(program)) {
    text += "  cell = p[0, 0, 0, 0, 0, 0]\n";
  }
  return text + joined({"  set_tcp(", pose_text(pose_of(robot.tool_place_m, robot.tool_rotation_rad)), ")\n"});
}

/// Whole cycles of the controller after the start of a move: of its servo steps, of commands within it, of its
/// end.
std::vector<int> cycles_of(const HandlingProgram& program, const ProgramMove& move) {
  const int end = static_cast<int>(std::ceil((move.end_s - move.start_s) / kCycle_s - 1e-6));
  std::vector<int> cycles;
  for (int i = kStepCycles; i < end; i += kStepCycles) cycles.push_back(i);
  for (const GripCommand* command : commands_within(program, move)) {
    cycles.push_back(std::max(1, cycle_of(*command, move)));
  }
  cycles.push_back(end);
  std::ranges::sort(cycles);
  cycles.erase(std::unique(cycles.begin(), cycles.end()), cycles.end());
  return cycles;
}

/// @return when it ends
double add_move(const HandlingProgram& program, const ProgramMove& move, std::string& text) {
  std::vector<double> times;
  const std::vector<int> cycles = cycles_of(program, move);
  for (const int cycle : cycles) times.push_back(move.start_s + kCycle_s * cycle);
  const std::vector<ProgramPoint> points = program.points(times);
  int before = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    text +=
        joined({"  servoj(", target(program, points[i]), ", t=", fixed_digits(kCycle_s * (cycles[i] - before), 3),
                ", lookahead_time=0.03, gain=300)\n"});
    before = cycles[i];
    for (const GripCommand* command : commands_within(program, move)) {
      if (std::max(1, cycle_of(*command, move)) == cycles[i]) text += call_line(*command);
    }
  }
  text += "  stopj(10.0)\n";
  return times.back();
}

}  // namespace

ProgramFile urscript_program(const HandlingProgram& program, const ProgramHead& head) {
  std::string text = comment_lines(head.lines, "#");
  text += joined(
      {"def ", head.name, "():\n", kGripper, frames(program),
       "  # The palm stands around the product when it begins; how it comes there is yours to say.\n  movej(",
       target(program, program.start()), ", a=0.5, v=0.2)\n"});
  double now_s = 0.0;
  for (const ProgramStep& step : steps_of(program)) {
    const double rest_s = step.move.start_s - now_s;
    const bool waits = step.command != nullptr && step.command->waits_for_contact;
    if (waits) {
      text += joined({"  grip_wait_for_contact()  # ", time_text(rest_s), " s as simulated\n"});
    } else if (rest_s > kLeastRest_s) {
      text += joined({"  sleep(", time_text(rest_s), ")\n"});
    }
    now_s = std::max(now_s, step.move.start_s);
    if (step.command == nullptr) {
      now_s = add_move(program, step.move, text);
    } else {
      text += call_line(*step.command);
    }
  }
  if (program.end_s() - now_s > kLeastRest_s)
    text += joined({"  sleep(", time_text(program.end_s() - now_s), ")\n"});
  return {".script", text + joined({"end\n", head.name, "()\n"})};
}

}  // namespace unbruised::studies
