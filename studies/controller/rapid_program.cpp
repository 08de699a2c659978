#include "studies/controller/program_text.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr double kStep_s = 0.04;  // closer targets are more than such a controller plans ahead

constexpr std::string_view kGripper =
    "  ! What your gripper is told: fill these in. Speeds are of each finger in m/s, forces of each finger in N.\n"
    "  PROC grip_close(num speed, num force)\n  ENDPROC\n"
    "  PROC grip_wait_for_contact()\n    ! returns when a finger touches\n  ENDPROC\n"
    "  PROC grip_force(num force, num ramp)\n    ! rises to it in ramp s; returns at once\n  ENDPROC\n"
    "  PROC grip_lock()\n    ! holds the fingers where they are\n  ENDPROC\n"
    "  PROC grip_open(num speed)\n  ENDPROC\n";

/// RAPID puts no brackets around what a procedure is called with.
std::string call(const GripCommand& command) {
  std::string text = grip_call(command);
  text[text.find('(')] = ' ';
  text.pop_back();
  if (text.back() == ' ') text.pop_back();
  return text + ";";
}

std::string pose_text(const Pose& pose) {
  return joined({"[[", number_list(pose.place_m, 6, kMillimetres), "], [", fixed_digits(pose.attitude.w, 9), ", ",
                 number_list(pose.attitude.axis, 9), "]]"});
}

std::string target(const HandlingProgram& program, const ProgramPoint& point) {
  const std::string pose = pose_text(program.palm_from_base(point.palm));
  return joined({"[", pose.substr(1, pose.size() - 2), ", [0, 0, 0, 0], [9E9, 9E9, 9E9, 9E9, 9E9, 9E9]]"});
}

std::string data(const HandlingProgram& program) {
  const RobotParameters& robot = program.scenario().robot;
  std::string text;
  if (!has_robot(program.scenario())) {
    text +=
        "  ! To be taught: cell, the support's plane under the product's middle at the start, x along the grip "
        "axis.\n"
        "  ! To be measured: gripper, the middle between the pads from the flange, x along the grip axis, z up.\n";
  }
  text +=
      "  TASK PERS wobjdata cell := [FALSE, TRUE, \"\", [[0, 0, 0], [1, 0, 0, 0]], [[0, 0, 0], [1, 0, 0, 0]]];\n";
  if (!(robot.gripper_mass_kg > 0.0))
    text += "  ! The gripper's mass is not known: the 1 kg below is assumed. Set it.\n";
  text += joined({"  TASK PERS tooldata gripper := [TRUE, ",
                  pose_text(pose_of(robot.tool_place_m, robot.tool_rotation_rad)), ", [",
                  fixed_digits(tool_mass_kg(robot), 6), ", [",
                  number_list(robot.gripper_center_of_mass_m, 6, kMillimetres), "], [1, 0, 0, 0], 0, 0, 0]];\n"});
  return text;
}

std::string start_text(const HandlingProgram& program) {
  const ProgramPoint start = program.start();
  std::string text =
      "    ! The palm stands around the product when it begins; how it comes there is yours to say.\n";
  if (start.arm.angle_rad.size() == 6) {
    text += joined({"    MoveAbsJ [[", number_list(start.arm.angle_rad, 8, kDegrees),
                    "], [9E9, 9E9, 9E9, 9E9, 9E9, 9E9]], v100, fine, gripper\\WObj:=cell;\n"});
  } else {
    text += joined({"    MoveL ", target(program, start), ", v100, fine, gripper\\WObj:=cell;\n"});
  }
  return text;
}

/// Commands within a move are procedures of their own, which a move calls where it ends.
class Body {
 public:
  explicit Body(const HandlingProgram& program) : program_(program) {}

  void add_move(const ProgramMove& move) {
    const std::vector<ProgramPoint> points = program_.points(program_.times(move.start_s, move.end_s, kStep_s));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool last = i + 1 == points.size();
      std::string called;
      for (const GripCommand* command : commands_within(program_, move)) {
        if (command->time_s == points[i].time_s) called += joined({"    ", call(*command), "\n"});
      }
      text += joined({"    ", called.empty() ? "MoveL " : "MoveLSync ", target(program_, points[i]),
                      ", v1000\\T:=", time_text(points[i].time_s - points[i - 1].time_s), ", ",
                      last ? "fine" : "z0", ", gripper\\WObj:=cell"});
      if (!called.empty()) {
        const std::string name = joined({"grip_at_", std::to_string(++count_)});
        text += joined({", \"", name, "\""});
        procedures +=
            joined({"  PROC ", name, "()  ! ", fixed_digits(points[i].time_s, 6), " s\n", called, "  ENDPROC\n"});
      }
      text += ";\n";
    }
  }

  void add_rest(double rest_s, bool waits_for_contact) {
    if (waits_for_contact) {
      text += joined({"    grip_wait_for_contact;  ! ", time_text(rest_s), " s as simulated\n"});
    } else if (rest_s > kLeastRest_s) {
      text += joined({"    WaitTime ", time_text(rest_s), ";\n"});
    }
  }

  std::string text, procedures;

 private:
  const HandlingProgram& program_;
  int count_ = 0;
};

}  // namespace

ProgramFile rapid_program(const HandlingProgram& program, const ProgramHead& head) {
  Body body(program);
  double now_s = 0.0;
  for (const ProgramStep& step : steps_of(program)) {
    body.add_rest(step.move.start_s - now_s, step.command != nullptr && step.command->waits_for_contact);
    now_s = step.move.end_s;
    if (step.command == nullptr) {
      body.add_move(step.move);
    } else {
      body.text += joined({"    ", call(*step.command), "  ! ", fixed_digits(step.command->time_s, 6), " s\n"});
    }
  }
  body.add_rest(program.end_s() - now_s, false);
  return {".mod", joined({comment_lines(head.lines, "!"), "MODULE ", head.name, "\n", data(program), kGripper,
                          body.procedures, "  PROC ", head.name, "_main()\n    ConfL\\Off;\n", start_text(program),
                          body.text, "    ConfL\\On;\n  ENDPROC\nENDMODULE\n"})};
}

}  // namespace unbruised::studies
