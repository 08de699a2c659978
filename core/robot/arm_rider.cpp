#include "core/robot/arm_rider.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/arm_ride.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {
namespace {

constexpr double kRateResidual = 1e-6;
/// Jerks are differences of accelerations over so long: right to 1e-3 of them for motions of 0.1 s and more.
constexpr double kJerkStep_s = 2e-5;

}  // namespace

std::optional<Joints> ArmRider::start() const {
  return posture_for(arm_, palm_pose(scenario_, plan_.palm(0.0)), arm_.seed_rad(), true);
}

ArmRider::Stop ArmRider::motion_at(double time_s, const Joints& from) const {
  const PalmState palm = plan_.palm(time_s);
  Stop stop;
  const auto angle = posture_for(arm_, palm_pose(scenario_, palm), from, false);
  stop.is_in_reach = angle.has_value();
  if (!angle) return stop;
  const std::vector<Twist> J = arm_.jacobian(*angle);
  stop.manipulability = manipulability(J);
  if (stop.manipulability < kLeastManipulability) return stop;
  const JointRates speed = rates_for(J, {palm.velocity_m_s, palm.spin_rad_s});
  Twist pull = arm_.bias(*angle, speed.rate);
  for (std::size_t d = 0; d < 3; ++d) {
    pull.linear[d] = palm.acceleration_m_s2[d] - pull.linear[d];
    pull.angular[d] = palm.spin_acceleration_rad_s2[d] - pull.angular[d];
  }
  const JointRates acceleration = rates_for(J, pull);
  if (speed.residual > kRateResidual || acceleration.residual > kRateResidual) return stop;
  stop.sample.emplace();
  stop.sample->time_s = time_s;
  stop.sample->phase = plan_.phase_after_contact(time_s);
  stop.sample->motion = {*angle, speed.rate, acceleration.rate};
  return stop;
}

ArmRider::Stop ArmRider::at(double time_s, const Joints& from) const {
  Stop stop = motion_at(time_s, from);
  if (!stop.sample) return stop;
  ArmSample& sample = *stop.sample;
  sample.torque_N_m = joint_torques(arm_, sample.motion, loads_at(time_s), scenario_.cell.gravity_m_s2);
  if (!scenario_.robot.jerk_rad_s3.empty()) add_jerk(sample);
  return stop;
}

void ArmRider::add_jerk(ArmSample& sample) const {
  sample.jerk_rad_s3.assign(arm_.joint_count(), 0.0);
  for (const double h : {-kJerkStep_s, kJerkStep_s}) {
    const Stop beside = motion_at(sample.time_s + h, sample.motion.angle_rad);
    const auto stops = [](const ArmSample& each) { return each.phase == CyclePhase::stop; };
    if (!beside.sample || stops(*beside.sample) != stops(sample)) continue;
    for (std::size_t j = 0; j < arm_.joint_count(); ++j) {
      const double change = beside.sample->motion.acceleration_rad_s2[j] - sample.motion.acceleration_rad_s2[j];
      sample.jerk_rad_s3[j] = std::max(sample.jerk_rad_s3[j], std::abs(change / h));
    }
  }
}

std::vector<PointLoad> ArmRider::loads_at(double time_s) const {
  return flange_loads(scenario_, is_loaded(time_s));
}

Joints ArmRider::weight_at(const Joints& angle_rad, double time_s) const {
  const Joints none(arm_.joint_count(), 0.0);
  return joint_torques(arm_, {angle_rad, none, none}, loads_at(time_s), scenario_.cell.gravity_m_s2);
}

Joints foreseen(const ArmSample& last, double time_s) {
  Joints angle = last.motion.angle_rad;
  const double h = time_s - last.time_s;
  for (std::size_t j = 0; j < angle.size(); ++j) {
    angle[j] += h * (last.motion.speed_rad_s[j] + 0.5 * h * last.motion.acceleration_rad_s2[j]);
  }
  return angle;
}

std::array<double, 3> palm_start_m(const Scenario& scenario) {
  const auto extents = shape_extents_m(scenario.product);
  return {0.0, scenario.cell.grip_offset_m, (extents ? 0.5 * (*extents)[2] : 0.0) + scenario.cell.grip_height_m};
}

Pose palm_pose(const Scenario& scenario, const PalmState& palm) {
  const std::array<double, 3> start = palm_start_m(scenario);
  Pose pose = pose_of(palm.position_m, palm.rotation_rad);
  for (std::size_t d = 0; d < 3; ++d) pose.place_m[d] += start[d];
  return pose;
}

std::vector<PointLoad> flange_loads(const Scenario& scenario, bool carried) {
  const RobotParameters& robot = scenario.robot;
  std::vector<PointLoad> loads = {{robot.gripper_mass_kg, robot.gripper_center_of_mass_m}};
  if (!carried) return loads;
  const Pose tool = pose_of(robot.tool_place_m, robot.tool_rotation_rad);
  const Pose middle = tool * Pose{{0.0, -scenario.cell.grip_offset_m, -scenario.cell.grip_height_m}, {}};
  loads.push_back({product_mass_kg(scenario.product), middle.place_m});
  return loads;
}

}  // namespace unbruised
