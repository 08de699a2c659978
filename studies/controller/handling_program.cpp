#include "studies/controller/handling_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/door/require.hpp"
#include "core/scenario/conveyor.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "studies/execution/arm_run.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr double kLook_s = 2e-3;  // rests are looked for so closely
constexpr double kShortestRest_s = 0.01;
constexpr double kPostureStep_s = 4e-3;   // from posture to posture, so that the branch is kept
constexpr std::size_t kLongestName = 24;  // of a KRL module; RAPID takes 32
constexpr int kHalvings = 20;             // of kLook_s: to 2 ns

std::string limits_line(const Scenario& scenario) {
  const StrategyParameters& s = scenario.strategy;
  const double lift = s.lift_acceleration_m_s2;
  return joined({"limits of the palm: ", short_number(s.speed_m_s), " m/s; lift ", short_number(lift),
                 ", transfer ", short_number(s.transfer_acceleration_m_s2.value_or(lift)), ", lowering ",
                 short_number(s.lower_acceleration_m_s2.value_or(lift)), " m/s^2; turns ",
                 short_number(s.tilt_speed_rad_s), " rad/s, ", short_number(s.tilt_acceleration_rad_s2),
                 " rad/s^2"});
}

std::string joint_line(const RobotParameters& robot, std::size_t j) {
  const ArmJointParameters& joint = robot.joint[j];
  const std::string range =
      joint.lower_rad && joint.upper_rad
          ? joined({short_number(*joint.lower_rad), " to ", short_number(*joint.upper_rad), " rad"})
          : std::string("turns without end");
  const auto limit = [j](const std::vector<double>& list, std::string_view unit) {
    const auto most = of_joint(list, j);
    return most ? joined({short_number(*most), unit}) : std::string();
  };
  return joined({"limits of joint ", std::to_string(j), ": ", range, ", ", short_number(joint.speed_rad_s),
                 " rad/s, ", limit(robot.acceleration_rad_s2, " rad/s^2, "),
                 limit(robot.jerk_rad_s3, " rad/s^3, "), short_number(joint.torque_N_m), " N m"});
}

/// What hangs on the flange, which a controller has to know.
std::string masses_line(const Scenario& scenario) {
  const RobotParameters& robot = scenario.robot;
  const std::string product = joined({", product ", short_number(product_mass_kg(scenario.product)), " kg"});
  if (!(robot.gripper_mass_kg > 0.0)) {
    return joined(
        {"on the flange: the gripper's mass is NOT KNOWN (robot.gripper_mass_kg), where the file has to "
         "name one it says ",
         short_number(tool_mass_kg(robot)), " kg", product});
  }
  const auto& [x, y, z] = robot.gripper_center_of_mass_m;
  return joined({"on the flange: gripper ", short_number(robot.gripper_mass_kg), " kg, its centre at ",
                 short_number(x), ", ", short_number(y), ", ", short_number(z), " m of the flange", product,
                 "; the controller's load is yours to set"});
}

void add_what_is_left_out(const Scenario& scenario, std::vector<std::string>& lines) {
  const StrategyParameters& s = scenario.strategy;
  if (s.guard != GuardKind::none) {
    lines.push_back(joined(
        {"not in it: the guard of the approach, which slows the fingers down to ", short_number(s.guard_speed_m_s),
         " m/s when ", s.guard == GuardKind::range ? "a range sensor reads less than " : "a force exceeds ",
         short_number(s.guard == GuardKind::range ? s.guard_range_m.value_or(0.0) : s.guard_force_N.value_or(0.0)),
         s.guard == GuardKind::range ? " m" : " N"}));
  }
  if (s.pick == PickKind::tracking && has_belt(scenario.cell)) {
    lines.push_back(
        "the palm goes with the belt from the first point on: start it when the product passes its place at "
        "time 0. A belt that does not run as simulated needs the controller's own tracking");
  }
}

}  // namespace

std::string_view word_of(GripCommand::Kind kind) {
  constexpr std::array<std::string_view, 4> kWords = {"close", "grip", "lock", "open"};
  return kWords.at(static_cast<std::size_t>(kind));
}

HandlingProgram::HandlingProgram(const Scenario& scenario, double lift_time_s)
    : scenario_(scenario),
      plan_(followed_plan(scenario, lift_time_s)),
      grip_s_(ramp_start_s(scenario, lift_time_s)) {
  require(std::isfinite(lift_time_s), "HandlingProgram: nothing was lifted");
  end_s_ = plan_.release_end_s() < kNever ? plan_.release_end_s() : plan_.end_s();
  add_commands();
  find_moves();
}

void HandlingProgram::add_commands() {
  using Kind = GripCommand::Kind;
  const StrategyParameters& s = scenario_.strategy;
  commands_.push_back({.kind = Kind::close, .speed_m_s = s.approach_speed_m_s, .force_N = s.contact_force_N});
  commands_.push_back({.kind = Kind::grip,
                       .time_s = std::max(0.0, grip_s_),
                       .force_N = s.grip_force_N,
                       .ramp_s = s.grip_ramp_s,
                       .waits_for_contact = !s.ramp_from_start});
  const auto* jaw = parallel_jaw(scenario_);
  if (jaw != nullptr && jaw->hold != HoldMode::force) {
    commands_.push_back({.kind = Kind::lock, .time_s = plan_.lift_start_s()});
  }
  if (plan_.release_start_s() < kNever) {
    commands_.push_back({.kind = Kind::open, .time_s = plan_.release_start_s(), .speed_m_s = s.release_speed_m_s});
  }
}

bool HandlingProgram::rests(double time_s) const {
  const PalmState palm = plan_.palm(time_s);
  return length(palm.velocity_m_s) == 0.0 && length(palm.spin_rad_s) == 0.0;
}

void HandlingProgram::find_moves() {
  const int looks = static_cast<int>(std::ceil(end_s_ / kLook_s));
  const auto at = [&](int i) { return std::min(end_s_, kLook_s * i); };
  const auto change_s = [&](double before_s, double after_s) {
    const bool rested = rests(before_s);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle_s = 0.5 * (before_s + after_s);
      (rests(middle_s) == rested ? before_s : after_s) = middle_s;
    }
    return rested ? before_s : after_s;
  };
  // Between two looks at which it rests it rests: no motion is as short as that.
  std::optional<double> start_s;
  for (int i = 0; i < looks; ++i) {
    const bool now = rests(at(i)), then = rests(at(i + 1));
    if (!start_s && !(now && then)) start_s = now ? change_s(at(i), at(i + 1)) : at(i);
    if (start_s && now && then) {
      moves_.push_back({*start_s, at(i)});
      start_s.reset();
    } else if (start_s && !now && then) {
      moves_.push_back({*start_s, change_s(at(i), at(i + 1))});
      start_s.reset();
    }
  }
  if (start_s) moves_.push_back({*start_s, end_s_});
  std::vector<ProgramMove> merged;
  for (const ProgramMove& move : moves_) {
    if (!merged.empty() && move.start_s - merged.back().end_s < kShortestRest_s) {
      merged.back().end_s = move.end_s;
    } else {
      merged.push_back(move);
    }
  }
  moves_ = std::move(merged);
}

double HandlingProgram::opening_m() const { return 2.0 * opened_half_m(scenario_); }

std::vector<double> HandlingProgram::times(double start_s, double end_s, double step_s) const {
  std::vector<double> times;
  const int steps = std::max(1, static_cast<int>(std::ceil((end_s - start_s) / step_s - 1e-9)));
  for (int i = 0; i < steps; ++i) times.push_back(start_s + (end_s - start_s) * i / steps);
  times.push_back(end_s);
  for (const GripCommand& command : commands_) {
    if (command.time_s > start_s && command.time_s < end_s) times.push_back(command.time_s);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<ProgramPoint> HandlingProgram::points(const std::vector<double>& time_s) const {
  std::vector<ProgramPoint> points;
  for (const double t : time_s) {
    const PalmState palm = plan_.palm(t);
    points.push_back({t,
                      t >= grip_s_ ? plan_.phase_after_contact(t) : CyclePhase::approach,
                      palm_pose(scenario_, palm),
                      {palm.velocity_m_s, palm.spin_rad_s},
                      {}});
  }
  if (!has_robot(scenario_) || time_s.empty()) return points;
  std::vector<double> followed = times(0.0, time_s.back(), kPostureStep_s);
  followed.insert(followed.end(), time_s.begin(), time_s.end());
  std::ranges::sort(followed);
  followed.erase(std::unique(followed.begin(), followed.end()), followed.end());
  const std::vector<ArmSample> samples = ride_at(scenario_, plan_, followed);
  require(samples.size() == followed.size(), "HandlingProgram: the arm cannot follow");
  for (ProgramPoint& point : points) {
    const auto place = std::ranges::lower_bound(followed, point.time_s) - followed.begin();
    point.arm = samples[static_cast<std::size_t>(place)].motion;
  }
  return points;
}

Pose HandlingProgram::palm_from_base(const Pose& palm) const {
  if (!has_robot(scenario_)) return palm;
  const RobotParameters& robot = scenario_.robot;
  return inverse(pose_of(robot.base_place_m, robot.base_rotation_rad)) * palm;
}

std::string program_name(const std::string& text) {
  std::string name = text.substr(0, kLongestName);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_letter(c) && !(c >= '0' && c <= '9'); }, '_');
  if (name.empty() || !is_letter(name.front())) name = joined({"u", name}).substr(0, kLongestName);
  return name;
}

std::string program_name(const std::string& text, std::uint64_t number) {
  const std::string behind = joined({"_", std::to_string(number)});
  return program_name(joined({text.substr(0, kLongestName - behind.size()), behind}));
}

ProgramHead head_of(const ProgramSource& source, const Scenario& scenario) {
  ProgramHead head;
  head.name = source.name;
  head.lines = {
      joined({"made by ", build_line()}),
      joined({"study ", source.study, ", scenario ", std::to_string(source.scenario_id), ", ", source.outcome}),
      joined({"config sha256 ", source.config_sha256}), joined({"digest of the results ", source.digest})};
  if (!source.inputs.empty()) head.lines.push_back(joined({"with ", source.inputs}));
  head.lines.push_back(limits_line(scenario));
  for (std::size_t j = 0; j < scenario.robot.joint.size(); ++j) {
    head.lines.push_back(joint_line(scenario.robot, j));
  }
  if (has_robot(scenario) && scenario.robot.use_most < 1.0) {
    head.lines.push_back(
        joined({"of each of these but the range ", short_number(scenario.robot.use_most), " may be used"}));
  }
  head.lines.push_back(masses_line(scenario));
  head.lines.emplace_back(
      "NOT TRIED ON A REAL CONTROLLER. Read it; run it slowly and without a product first, a hand on the stop");
  add_what_is_left_out(scenario, head.lines);
  return head;
}

}  // namespace unbruised::studies
