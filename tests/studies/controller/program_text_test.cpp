// What a controller is told, read back: places within 1e-6 m, times within 1 ms, speeds within their limits, the
// gripper's commands where they belong. Files of the same handling in five languages.

#include "studies/controller/program_text.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "core/scenario/vectors.hpp"
#include "tests/core/robot/arms.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised::studies {
namespace {

constexpr double kPlace_m = 1e-6;
constexpr double kTime_s = 1e-3;
constexpr double kTurn_rad = 1e-6;

Scenario grip() {
  Scenario scenario = testing::usual_grip();
  scenario.strategy.tilt_rad = {0.0, 0.4, 0.2};
  scenario.strategy.hold_s = 0.3;
  return scenario;
}

Scenario carried_grip() {
  Scenario scenario = grip();
  scenario.robot = testing::six_joints();
  scenario.robot.base_place_m = {-0.55, 0.1, 0.0};
  scenario.robot.base_rotation_rad = {0.0, 0.0, 0.3};
  return scenario;
}

/// The palm goes with a belt while the fingers close.
Scenario tracked_grip(Scenario scenario) {
  scenario.cell.conveyor.speed_m_s = 0.2;
  scenario.strategy.pick = PickKind::tracking;
  return scenario;
}

HandlingProgram program_of(const Scenario& scenario) {
  return HandlingProgram(scenario, planned_motion(scenario).lift_start_s());
}

ProgramHead head() { return {"kiwi_5", {"study kiwi, scenario 5", "NOT TRIED ON A REAL CONTROLLER"}}; }

std::vector<double> numbers_in(const std::string& text) {
  static const std::regex kNumber(R"([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?)");
  std::vector<double> found;
  for (std::sregex_iterator i(text.begin(), text.end(), kNumber), end; i != end; ++i)
    found.push_back(std::stod(i->str()));
  return found;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// What was read back at a time.
struct Read {
  double time_s = 0.0;
  std::string call;  ///< of the gripper; empty: a place
  Pose pose;
};

void expect_calls(const HandlingProgram& program, const std::vector<Read>& read) {
  std::vector<Read> calls;
  for (const Read& each : read) {
    if (!each.call.empty()) calls.push_back(each);
  }
  ASSERT_EQ(calls.size(), program.commands().size());
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const GripCommand& command = program.commands()[i];
    EXPECT_NEAR(calls[i].time_s, command.time_s, kTime_s) << calls[i].call;
    const std::vector<double> told = numbers_in(calls[i].call);
    const std::map<GripCommand::Kind, std::vector<double>> wanted = {
        {GripCommand::Kind::close, {command.speed_m_s, command.force_N}},
        {GripCommand::Kind::grip, {command.force_N, command.ramp_s}},
        {GripCommand::Kind::lock, {}},
        {GripCommand::Kind::open, {command.speed_m_s}}};
    ASSERT_EQ(told.size(), wanted.at(command.kind).size()) << calls[i].call;
    for (std::size_t k = 0; k < told.size(); ++k) EXPECT_NEAR(told[k], wanted.at(command.kind)[k], 1e-6);
  }
}

/// @param read places are in the frame of the arm's base
void expect_way(const HandlingProgram& program, const std::vector<Read>& read, double step_s) {
  const Scenario& scenario = program.scenario();
  const MotionPlan plan = planned_motion(scenario);
  const Read* before = nullptr;
  int places = 0;
  for (const Read& each : read) {
    if (!each.call.empty()) continue;
    const Pose wanted = program.palm_from_base(palm_pose(scenario, plan.palm(each.time_s)));
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(each.pose.place_m[d], wanted.place_m[d], kPlace_m) << each.time_s;
    EXPECT_LT(angle_between_rad(each.pose.attitude, wanted.attitude), kTurn_rad) << each.time_s;
    if (before != nullptr && each.time_s > before->time_s) {
      const auto& a = before->pose.place_m;
      const auto& b = each.pose.place_m;
      const double way_m = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      EXPECT_LE(way_m, (scenario.strategy.speed_m_s + 1e-6) * (each.time_s - before->time_s) + 2e-9);
    }
    before = &each;
    ++places;
  }
  double moving_s = 0.0;
  for (const ProgramMove& move : program.moves()) moving_s += move.end_s - move.start_s;
  EXPECT_GE(places, moving_s / step_s);
  ASSERT_NE(before, nullptr);
  const Pose end = program.palm_from_base(palm_pose(scenario, plan.palm(program.moves().back().end_s)));
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(before->pose.place_m[d], end.place_m[d], kPlace_m);
}

std::vector<Read> read_csv(const std::string& text) {
  std::vector<Read> read;
  for (const std::string& line : lines_of(text)) {
    if (line.front() == '#' || line.starts_with("time_s")) continue;
    std::vector<std::string> cells;
    std::istringstream in(line + ",");
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    const auto number = [&](std::size_t i) { return std::stod(cells.at(i)); };
    read.push_back(
        {number(0), {}, {{number(2), number(3), number(4)}, {number(5), {number(6), number(7), number(8)}}}});
    const std::size_t grip = cells.size() - 5;
    if (cells[grip].empty()) continue;
    std::string call;
    for (std::size_t i = grip + 1; i < grip + 4; ++i) call += cells[i] + " ";
    read.push_back({number(0), cells[grip] + " " + call, {}});
  }
  return read;
}

std::vector<Read> read_urscript(const std::string& text,
                                const std::function<Pose(const std::string&)>& pose_of_target) {
  std::vector<Read> read;
  double now_s = 0.0;
  bool body = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("  movej(")) body = true;
    if (!body) continue;
    if (line.starts_with("  servoj(")) {
      const std::size_t time = line.find(", t=");
      now_s += std::stod(line.substr(time + 4));
      read.push_back({now_s, {}, pose_of_target(line.substr(9, time - 9))});
    } else if (line.starts_with("  sleep(")) {
      now_s += std::stod(line.substr(8));
    } else if (line.starts_with("  grip_wait")) {
      now_s += std::stod(line.substr(line.find('#') + 1));
    } else if (line.starts_with("  grip_")) {
      read.push_back({now_s, line.substr(0, line.find('#')), {}});
    }
  }
  return read;
}

std::vector<Read> read_rapid(const std::string& text) {
  std::vector<Read> read;
  std::map<std::string, std::string> called;  // by the name of a procedure
  std::string procedure;
  double now_s = 0.0;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("  PROC ")) procedure = line.substr(7, line.find('(') - 7);
    const bool calls = line.starts_with("    grip_");
    if (procedure.starts_with("grip_at_") && calls) called[procedure] = line.substr(0, line.find(';'));
    if (!procedure.ends_with("_main")) continue;
    if (line.starts_with("    MoveL") && line.find("\\T:=") != std::string::npos) {
      const std::size_t time = line.find("\\T:=");
      const std::vector<double> n = numbers_in(line.substr(0, time));
      now_s += std::stod(line.substr(time + 4));
      Read place{now_s, {}, {{1e-3 * n[0], 1e-3 * n[1], 1e-3 * n[2]}, {n[3], {n[4], n[5], n[6]}}}};
      read.push_back(place);
      const std::size_t name = line.find('"');
      if (name != std::string::npos) {
        read.push_back({now_s, called.at(line.substr(name + 1, line.rfind('"') - name - 1)), {}});
      }
    } else if (line.starts_with("    WaitTime ")) {
      now_s += std::stod(line.substr(13));
    } else if (line.starts_with("    grip_wait")) {
      now_s += std::stod(line.substr(line.find('!') + 1));
    } else if (calls) {
      read.push_back({now_s, line.substr(0, line.find(';')), {}});
    }
  }
  return read;
}

Attitude attitude_of_krl(double A, double B, double C) {
  return attitude_of({0.0, 0.0, A / kDegrees}) * attitude_of({0.0, B / kDegrees, 0.0}) *
         attitude_of({C / kDegrees, 0.0, 0.0});
}

std::vector<Read> read_krl(const std::vector<ProgramFile>& files) {
  std::map<std::string, Pose> points;
  for (const std::string& line : lines_of(files.at(1).text)) {
    if (!line.starts_with("DECL FRAME ")) continue;
    const std::size_t equal = line.find('=');
    const std::vector<double> n = numbers_in(line.substr(equal));
    points[line.substr(11, equal - 11)] = {{1e-3 * n[0], 1e-3 * n[1], 1e-3 * n[2]},
                                           attitude_of_krl(n[3], n[4], n[5])};
  }
  std::vector<Read> read, block;
  double now_s = 0.0, share = 0.0;
  for (const std::string& line : lines_of(files.at(0).text)) {
    if (line == "END") break;
    const std::size_t equal = line.find('=');
    if (line.starts_with("    SPL ")) {
      block.push_back({0.0, {}, points.at(line.substr(8))});
    } else if (line.starts_with("    TRIGGER ")) {
      const std::size_t call = line.find("grip_");
      block.push_back({-1.0, line.substr(call, line.find(" PRIO") - call), {}});
    } else if (line.starts_with("    TIME_BLOCK PART")) {
      share += std::stod(line.substr(equal + 1));
      block.back().time_s = share;
    } else if (line.starts_with("    TIME_BLOCK END")) {
      EXPECT_NEAR(share, 100.0, 1e-6);
      const double whole_s = std::stod(line.substr(equal + 1));
      for (std::size_t i = block.size(); i-- > 0;) {  // a trigger comes at the point that follows it
        if (block[i].time_s < 0.0) block[i].time_s = block.at(i + 1).time_s;
      }
      for (Read& each : block) {
        each.time_s = now_s + whole_s * each.time_s / 100.0;
        read.push_back(each);
      }
      now_s += whole_s;
      share = 0.0;
      block.clear();
    } else if (line.starts_with("  WAIT SEC ")) {
      now_s += std::stod(line.substr(11));
    } else if (line.starts_with("  grip_wait")) {
      now_s += std::stod(line.substr(line.find(';') + 1));
    } else if (line.starts_with("  grip_")) {
      read.push_back({now_s, line.substr(0, line.find(';')), {}});
    }
  }
  return read;
}

Pose pose_of_numbers(const std::string& text) {
  const std::vector<double> n = numbers_in(text.substr(text.find("p[")));
  return pose_of({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
}

/// Where the posture brings the palm, from the base.
std::function<Pose(const std::string&)> pose_of_posture(const HandlingProgram& program) {
  return [&program](const std::string& text) {
    return program.palm_from_base(Arm(program.scenario().robot).palm(numbers_in(text)));
  };
}

class EachWay : public ::testing::TestWithParam<const char*> {
 protected:
  static Scenario scenario() {
    const std::string name = GetParam();
    Scenario made = name.starts_with("arm") ? carried_grip() : grip();
    return name.ends_with("belt") ? tracked_grip(made) : made;
  }
};

TEST_P(EachWay, IsReadBackFromCsv) {
  const HandlingProgram program = program_of(scenario());
  std::vector<Read> read = read_csv(path_csv(program, head()).text);
  for (Read& each : read) each.pose = program.palm_from_base(each.pose);
  expect_way(program, read, 4e-3);
  expect_calls(program, read);
}

TEST_P(EachWay, IsReadBackFromUrscript) {
  const HandlingProgram program = program_of(scenario());
  const std::string text = urscript_program(program, head()).text;
  const bool has_arm = has_robot(program.scenario());
  EXPECT_EQ(text.find("get_inverse_kin") == std::string::npos, has_arm);
  const std::vector<Read> read = read_urscript(
      text, has_arm ? pose_of_posture(program) : std::function<Pose(const std::string&)>(pose_of_numbers));
  expect_way(program, read, 8e-3);
  expect_calls(program, read);
}

TEST_P(EachWay, IsReadBackFromRapid) {
  const HandlingProgram program = program_of(scenario());
  const std::vector<Read> read = read_rapid(rapid_program(program, head()).text);
  expect_way(program, read, 0.04);
  expect_calls(program, read);
}

TEST_P(EachWay, IsReadBackFromKrl) {
  const HandlingProgram program = program_of(scenario());
  const std::vector<Read> read = read_krl(krl_program(program, head()));
  expect_way(program, read, 0.04);
  expect_calls(program, read);
}

INSTANTIATE_TEST_SUITE_P(Handled, EachWay, ::testing::Values("palm", "palm_on_a_belt", "arm", "arm_on_a_belt"),
                         [](const auto& each) { return std::string(each.param); });

TEST(JointTrajectory, SpeedsBetweenPointsStayWithinTheJointsLimits) {
  const HandlingProgram program = program_of(carried_grip());
  const std::string text = joint_trajectory(program, head(), {"a", "b", "c", "d", "e", "f"}).text;
  EXPECT_NE(text.find("joint_names: [\"a\", \"b\", \"c\", \"d\", \"e\", \"f\"]"), std::string::npos);
  std::vector<double> before;
  double before_s = 0.0;
  int points = 0;
  std::vector<double> now;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("    - positions:")) now = numbers_in(line);
    if (!line.starts_with("      time_from_start:")) continue;
    const std::vector<double> t = numbers_in(line);
    const double now_s = t[0] + 1e-9 * t[1];
    const auto sample = program.points({now_s}).front().arm.angle_rad;
    for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(now[j], sample[j], 1e-7);
    for (std::size_t j = 0; j < before.size(); ++j) {
      const double most = program.scenario().robot.joint[j].speed_rad_s * (now_s - before_s) + 1e-8;
      EXPECT_LE(std::abs(now[j] - before[j]), most);
    }
    before = now;
    before_s = now_s;
    ++points;
  }
  EXPECT_GE(points, program.end_s() / 0.02);
  EXPECT_NEAR(before_s, program.end_s(), kTime_s);
}

TEST(HandlingProgram, ACommandThatWaitsForContactIsGivenAtRestWhereThePalmRests) {
  const HandlingProgram still = program_of(grip());
  EXPECT_EQ(steps_of(still).front().command->kind, GripCommand::Kind::close);
  EXPECT_TRUE(steps_of(still)[1].command->waits_for_contact);
  ASSERT_EQ(still.moves().size(), 2U) << "a rest of 0.3 s lies between turn and transfer";
  EXPECT_NEAR(still.moves()[1].start_s - still.moves()[0].end_s, 0.3, 1e-6);
  const HandlingProgram tracked = program_of(tracked_grip(grip()));
  EXPECT_EQ(tracked.moves().front().start_s, 0.0);
  EXPECT_EQ(commands_within(tracked, tracked.moves().front()).size(), 1U) << "the grip";
}

TEST(HandlingProgram, AnEmergencyStopIsItsEndAndNothingIsOpened) {
  Scenario scenario = grip();
  scenario.strategy.stop_time_s = planned_motion(scenario).lift_end_s();
  const HandlingProgram program = program_of(scenario);
  for (const GripCommand& command : program.commands()) EXPECT_NE(command.kind, GripCommand::Kind::open);
}

TEST(HandlingProgram, ALockIsToldWhenTheLiftBegins) {
  Scenario scenario = grip();
  jaw_of(scenario).hold = HoldMode::position;
  const HandlingProgram program = program_of(scenario);
  ASSERT_EQ(program.commands().size(), 4U);
  EXPECT_EQ(program.commands()[2].kind, GripCommand::Kind::lock);
  EXPECT_NE(urscript_program(program, head()).text.find("  grip_lock()  # "), std::string::npos);
}

TEST(ProgramHead, SaysWhereItComesFromItsLimitsAndThatItWasNotTried) {
  const ProgramSource source{.name = program_name("kiwi", 5),
                             .study = "kiwi",
                             .scenario_id = 5,
                             .outcome = "held",
                             .inputs = "grip_force_N = 3",
                             .config_sha256 = std::string(64, 'a'),
                             .digest = "0123456789abcdef"};
  const std::string text = comment_lines(head_of(source, carried_grip()).lines, "#");
  for (const char* part :
       {"study kiwi, scenario 5, held", "digest of the results 0123456789abcdef", "grip_force_N = 3",
        "limits of the palm: ", "limits of joint 5: -3 to 3 rad, 4 rad/s", "NOT TRIED ON A REAL CONTROLLER"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  for (const std::string& line : lines_of(text)) EXPECT_TRUE(line.starts_with("# "));
}

TEST(ProgramName, IsAWordThatControllersTake) {
  EXPECT_EQ(program_name("robot_pick", 17), "robot_pick_17");
  EXPECT_EQ(program_name("7 kiwis/day"), "u7_kiwis_day");
  EXPECT_EQ(program_name(""), "u");
  EXPECT_EQ(program_name("a_name_that_is_much_longer_than_that", 123), "a_name_that_is_much__123");
}

TEST(FixedDigits, NeverSaysMinusNothing) {
  EXPECT_EQ(fixed_digits(-1e-12, 6), "0.000000");
  EXPECT_EQ(fixed_digits(-1.5, 3), "-1.500");
}

TEST(KrlProgram, AnglesTurnAboutZThenYThenX) {
  Scenario scenario = grip();
  scenario.strategy.tilt_rad = {0.0, 1.5707963267948966, 0.0};  // x straight down: A and C turn about one axis
  const HandlingProgram program = program_of(scenario);
  const std::vector<Read> read = read_krl(krl_program(program, head()));
  expect_way(program, read, 0.04);
}

}  // namespace
}  // namespace unbruised::studies
