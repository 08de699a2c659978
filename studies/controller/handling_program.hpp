#pragma once

/// @file
/// One handling as a controller is told it: where the palm is and which posture an arm has over time, and what the
/// gripper is to do when.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/motion_plan.hpp"
#include "core/robot/arm_ride.hpp"

namespace unbruised::studies {

struct ProgramPoint {
  double time_s = 0.0;
  CyclePhase phase = CyclePhase::approach;
  Pose palm;       ///< in the cell
  Twist velocity;  ///< of the palm
  ArmMotion arm;   ///< empty without one
};

struct GripCommand {
  enum class Kind {
    close,  ///< at a speed, with a force at most
    grip,   ///< with a force that rises to this one in ramp_s
    lock,   ///< hold the fingers where they are
    open,   ///< at a speed
  };
  Kind kind = Kind::close;
  double time_s = 0.0;
  double speed_m_s = 0.0;  ///< of each finger; close, open
  double force_N = 0.0;    ///< of each finger; close, grip
  double ramp_s = 0.0;
  bool waits_for_contact =
      false;  ///< what comes before it lasts until a finger touches; time_s is the simulated one
};
std::string_view word_of(GripCommand::Kind kind);

/// A time in which the palm moves.
struct ProgramMove {
  double start_s = 0.0, end_s = 0.0;
};

class HandlingProgram {
 public:
  /// @param scenario as it was run, slowed down where the arm asks for it
  /// @param lift_time_s when its lift began
  HandlingProgram(const Scenario& scenario, double lift_time_s);

  [[nodiscard]] const Scenario& scenario() const { return scenario_; }
  [[nodiscard]] const std::vector<GripCommand>& commands() const { return commands_; }
  /// In their order; rests of less than 10 ms belong to them.
  [[nodiscard]] const std::vector<ProgramMove>& moves() const { return moves_; }
  /// When the fingers are open again.
  [[nodiscard]] double end_s() const { return end_s_; }
  /// Distance of the pads' faces when they are open.
  [[nodiscard]] double opening_m() const;

  /// Both ends, times of commands between them, and equal steps of the length said or a little less.
  [[nodiscard]] std::vector<double> times(double start_s, double end_s, double step_s) const;
  /// At times that ascend. Postures are followed from the start of the plan on.
  [[nodiscard]] std::vector<ProgramPoint> points(const std::vector<double>& time_s) const;
  /// Of the palm in the frame of the arm's base; without an arm in the cell.
  [[nodiscard]] Pose palm_from_base(const Pose& palm) const;
  /// Where the program begins.
  [[nodiscard]] ProgramPoint start() const { return points({0.0}).front(); }

 private:
  void add_commands();
  void find_moves();
  [[nodiscard]] bool rests(double time_s) const;

  Scenario scenario_;
  MotionPlan plan_;
  double grip_s_;  ///< when the force begins to rise
  std::vector<GripCommand> commands_;
  std::vector<ProgramMove> moves_;
  double end_s_ = 0.0;
};

/// What stands at the head of each file, and what it is called.
struct ProgramHead {
  std::string name;                ///< a word of letters, digits and _
  std::vector<std::string> lines;  ///< without the signs of a comment
};

/// Where a scenario comes from.
struct ProgramSource {
  std::string name;  ///< of the program: program_name
  std::string study;
  std::uint64_t scenario_id = 0;
  std::string outcome;
  std::string inputs;         ///< "approach_speed_m_s = 0.1, ..."; may be empty
  std::string config_sha256;  ///< 64 hex digits
  std::string digest;         ///< of the results
};
/// A word for a program, and for its file: letters, digits and _, 24 at most.
std::string program_name(const std::string& text);
/// The same with a number behind it, which stays whole.
std::string program_name(const std::string& text, std::uint64_t number);
/// Of the gripper, as a tool's data have to have it: 1 kg where it is not known.
inline double tool_mass_kg(const RobotParameters& robot) {
  return robot.gripper_mass_kg > 0.0 ? robot.gripper_mass_kg : 1.0;
}
ProgramHead head_of(const ProgramSource& source, const Scenario& scenario);

}  // namespace unbruised::studies
