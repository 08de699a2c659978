#include "studies/controller/program_text.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr double kStep_s = 4e-3;

std::string header(std::size_t joints) {
  std::string line = "time_s,phase,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s";
  for (const std::string_view unit : {"_rad", "_speed_rad_s"}) {
    for (std::size_t j = 0; j < joints; ++j) line += joined({",joint_", std::to_string(j), unit});
  }
  return line + ",grip,grip_speed_m_s,grip_force_N,grip_ramp_s,waits_for_contact\n";
}

template <class Numbers>
void add(std::string& line, const Numbers& numbers) {
  for (const double number : numbers) line += joined({",", fixed_digits(number, 9)});
}

std::string row(const ProgramPoint& point, const GripCommand* command) {
  std::string line =
      joined({time_text(point.time_s), ",", kCyclePhaseWords.at(static_cast<std::size_t>(point.phase))});
  add(line, point.palm.place_m);
  add(line, std::array{point.palm.attitude.w});
  add(line, point.palm.attitude.axis);
  add(line, point.velocity.linear);
  add(line, point.velocity.angular);
  add(line, point.arm.angle_rad);
  add(line, point.arm.speed_rad_s);
  if (command == nullptr) return line + ",,,,,\n";
  const bool moves = command->kind == GripCommand::Kind::close || command->kind == GripCommand::Kind::open;
  const bool presses = command->kind == GripCommand::Kind::close || command->kind == GripCommand::Kind::grip;
  const bool ramps = command->kind == GripCommand::Kind::grip;
  return line + joined({",", word_of(command->kind), ",", moves ? fixed_digits(command->speed_m_s, 6) : "", ",",
                        presses ? fixed_digits(command->force_N, 6) : "", ",",
                        ramps ? fixed_digits(command->ramp_s, 6) : "", ",", command->waits_for_contact ? "1" : "0",
                        "\n"});
}

}  // namespace

ProgramFile path_csv(const HandlingProgram& program, const ProgramHead& head) {
  std::vector<std::string> lines = head.lines;
  lines.emplace_back(
      "place and attitude of the palm, the middle between the pads, x along the grip axis, z up, from where the "
      "support's plane lies under the product's middle at the start; grip_force_N is of each finger. A command "
      "has "
      "a row of its own; one that waits for contact comes when a finger touches, at time_s as simulated");
  std::string text = comment_lines(lines, "#") + header(program.scenario().robot.joint.size());
  const std::vector<ProgramPoint> points = program.points(program.times(0.0, program.end_s(), kStep_s));
  for (const ProgramPoint& point : points) {
    bool told = false;
    for (const GripCommand& command : program.commands()) {
      if (command.time_s != point.time_s) continue;
      text += row(point, &command);
      told = true;
    }
    if (!told) text += row(point, nullptr);
  }
  return {".csv", text};
}

}  // namespace unbruised::studies
