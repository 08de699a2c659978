#include <cmath>

#include "studies/controller/program_text.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr double kStep_s = 0.04;

constexpr std::string_view kGripper =
    "; What your gripper is told: fill these in. Speeds are of each finger in m/s, forces of each finger in N.\n"
    "DEF grip_close(speed:IN, force:IN)\n  DECL REAL speed, force\nEND\n"
    "; returns when a finger touches\n"
    "DEF grip_wait_for_contact()\nEND\n"
    "; rises to it in ramp s; returns at once\n"
    "DEF grip_force(force:IN, ramp:IN)\n  DECL REAL force, ramp\nEND\n"
    "; holds the fingers where they are\n"
    "DEF grip_lock()\nEND\n"
    "DEF grip_open(speed:IN)\n  DECL REAL speed\nEND\n";

/// Turned about z by A, then about the new y by B, then about the new x by C.
std::array<double, 3> angles_deg(const Attitude& q) {
  const std::array<double, 3> x = turned(q, {1.0, 0.0, 0.0}), y = turned(q, {0.0, 1.0, 0.0}),
                              z = turned(q, {0.0, 0.0, 1.0});
  const double level = std::hypot(x[0], x[1]);
  constexpr double kStraightUp = 1e-9;
  const double B = std::atan2(-x[2], level);
  if (level < kStraightUp) return {std::atan2(-y[0], y[1]) * kDegrees, B * kDegrees, 0.0};
  return {std::atan2(x[1], x[0]) * kDegrees, B * kDegrees, std::atan2(y[2], z[2]) * kDegrees};
}

std::string frame_text(const Pose& pose) {
  const auto mm = [&](std::size_t d) { return fixed_digits(pose.place_m[d] * kMillimetres, 6); };
  const std::array<double, 3> angles = angles_deg(pose.attitude);
  const auto deg = [&](std::size_t d) { return fixed_digits(angles[d], 8); };
  return joined({"{X ", mm(0), ", Y ", mm(1), ", Z ", mm(2), ", A ", deg(0), ", B ", deg(1), ", C ", deg(2), "}"});
}

class Module {
 public:
  explicit Module(const HandlingProgram& program) : program_(program) {}

  void add_start() {
    const ProgramPoint start = program_.start();
    source += "  ; The palm stands around the product when it begins; how it comes there is yours to say.\n";
    if (start.arm.angle_rad.size() == 6) {
      points += "DECL E6AXIS XSTART={";
      for (std::size_t j = 0; j < 6; ++j) {
        points += joined({j == 0 ? "A" : ", A", std::to_string(j + 1), " ",
                          fixed_digits(start.arm.angle_rad[j] * kDegrees, 8)});
      }
      points += "}\n";
      source += "  SPTP XSTART WITH $VEL_AXIS[1] = SVEL_JOINT(10.0)\n";
    } else {
      source += joined({"  SLIN ", name_of(start), "\n"});
    }
  }

  /// A spline from the point before it; each part of it takes its share of the time.
  void add_move(const ProgramMove& move) {
    const std::vector<ProgramPoint> way = program_.points(program_.times(move.start_s, move.end_s, kStep_s));
    const double whole_s = move.end_s - move.start_s;
    source += "  SPLINE\n    TIME_BLOCK START\n";
    for (std::size_t i = 1; i < way.size(); ++i) {
      for (const GripCommand* command : commands_within(program_, move)) {
        if (command->time_s != way[i].time_s) continue;
        source += joined({"    TRIGGER WHEN PATH = 0 DELAY = 0 DO ", grip_call(*command), " PRIO = -1  ; ",
                          fixed_digits(command->time_s, 6), " s\n"});
      }
      const double share = 100.0 * (way[i].time_s - way[i - 1].time_s) / whole_s;
      source += joined({"    SPL ", name_of(way[i]), "\n    TIME_BLOCK PART = ", fixed_digits(share, 9), "\n"});
    }
    source += joined({"    TIME_BLOCK END = ", time_text(whole_s), "\n  ENDSPLINE\n"});
  }

  void add_rest(double rest_s, bool waits_for_contact) {
    if (waits_for_contact) {
      source += joined({"  grip_wait_for_contact()  ; ", time_text(rest_s), " s as simulated\n"});
    } else if (rest_s > kLeastRest_s) {
      source += joined({"  WAIT SEC ", time_text(rest_s), "\n"});
    }
  }

  std::string source, points;

 private:
  std::string name_of(const ProgramPoint& point) {
    const std::string name = joined({"X", std::to_string(++count_)});
    points += joined({"DECL FRAME ", name, "=", frame_text(program_.palm_from_base(point.palm)), "\n"});
    return name;
  }

  const HandlingProgram& program_;
  int count_ = 0;
};

std::string frames(const HandlingProgram& program) {
  const RobotParameters& robot = program.scenario().robot;
  std::string text;
  if (!has_robot(program.scenario())) {
    text +=
        "  ; To be taught: $BASE, the support's plane under the product's middle at the start, x along the grip "
        "axis.\n"
        "  ; To be measured: $TOOL, the middle between the pads from the flange, x along the grip axis, z up.\n";
  }
  return text + joined({"  BAS(#INITMOV, 0)\n  $BASE = {X 0.0, Y 0.0, Z 0.0, A 0.0, B 0.0, C 0.0}\n  $TOOL = ",
                        frame_text(pose_of(robot.tool_place_m, robot.tool_rotation_rad)), "\n"});
}

}  // namespace

std::vector<ProgramFile> krl_program(const HandlingProgram& program, const ProgramHead& head) {
  Module module(program);
  module.add_start();
  double now_s = 0.0;
  for (const ProgramStep& step : steps_of(program)) {
    module.add_rest(step.move.start_s - now_s, step.command != nullptr && step.command->waits_for_contact);
    now_s = step.move.end_s;
    if (step.command == nullptr) {
      module.add_move(step.move);
    } else {
      module.source +=
          joined({"  ", grip_call(*step.command), "  ; ", fixed_digits(step.command->time_s, 6), " s\n"});
    }
  }
  module.add_rest(program.end_s() - now_s, false);
  const std::string comment = comment_lines(head.lines, ";");
  return {{".src", joined({"&ACCESS RVP\n", comment, "DEF ", head.name, "()\n", frames(program), module.source,
                           "END\n\n", kGripper})},
          {".dat", joined({"&ACCESS RVP\n", comment, "DEFDAT ", head.name, "\n", module.points, "ENDDAT\n"})}};
}

}  // namespace unbruised::studies
