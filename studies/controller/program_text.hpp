#pragma once

/// @file
/// A handling in the words of controllers. Positions are written to 1e-9 m and 1e-9 rad or better, times to 1 ns.

#include <string>
#include <vector>

#include "studies/controller/handling_program.hpp"

namespace unbruised::studies {

struct ProgramFile {
  std::string ending;  ///< ".src"
  std::string text;
};

/// A row every 4 ms: time, phase, place, attitude and velocity of the palm, joints, what the gripper is told.
ProgramFile path_csv(const HandlingProgram& program, const ProgramHead& head);
/// YAML with the fields of ROS's trajectory_msgs/JointTrajectory and control_msgs/GripperCommand.
/// @param joint_names one for each joint
ProgramFile joint_trajectory(const HandlingProgram& program, const ProgramHead& head,
                             const std::vector<std::string>& joint_names);
/// Servo steps for Universal Robots: of joints where the arm has six, else of poses.
ProgramFile urscript_program(const HandlingProgram& program, const ProgramHead& head);
/// Timed straight moves for ABB.
ProgramFile rapid_program(const HandlingProgram& program, const ProgramHead& head);
/// Timed splines for KUKA: .src and .dat.
std::vector<ProgramFile> krl_program(const HandlingProgram& program, const ProgramHead& head);

// Parts of these texts.

/// With so many digits behind the point; never "-0.000".
std::string fixed_digits(double value, int digits);
/// To 1 ns: many add up.
inline std::string time_text(double time_s) { return fixed_digits(time_s, 9); }
std::string comment_lines(const std::vector<std::string>& lines, std::string_view sign);
/// Numbers one after the other with ", " between them.
template <class Numbers>
std::string number_list(const Numbers& numbers, int digits, double unit = 1.0) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ", ";
    text += fixed_digits(number * unit, digits);
  }
  return text;
}
/// What the gripper is told as a call: grip_close(0.1, 0.3), grip_force(3, 0.1), grip_lock(), grip_open(0.1).
std::string grip_call(const GripCommand& command);

/// What follows one another: moves, and commands that are given at rest.
struct ProgramStep {
  const GripCommand* command = nullptr;  ///< none: a move
  ProgramMove move;                      ///< of a command its time, twice
};
std::vector<ProgramStep> steps_of(const HandlingProgram& program);
/// Those that are given while it moves.
std::vector<const GripCommand*> commands_within(const HandlingProgram& program, const ProgramMove& move);

/// Rests that are shorter are not written.
inline constexpr double kLeastRest_s = 5e-7;
inline constexpr double kDegrees = 57.295779513082323;
inline constexpr double kMillimetres = 1e3;

}  // namespace unbruised::studies
