#include "core/robot/arm.hpp"

#include <algorithm>
#include <cmath>

#include "core/door/require.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

}  // namespace

Pose operator*(const Pose& first, const Pose& second) {
  return {sum(first.place_m, turned(first.attitude, second.place_m)), first.attitude * second.attitude};
}

Pose pose_of(const std::array<double, 3>& place_m, const std::array<double, 3>& rotation_rad) {
  return {place_m, attitude_of(rotation_rad)};
}

Pose inverse(const Pose& pose) {
  const Attitude back = inverse(pose.attitude);
  return {times(-1.0, turned(back, pose.place_m)), back};
}

Arm::Arm(const RobotParameters& robot)
    : robot_(robot),
      flange_(pose_of(robot.flange_place_m, robot.flange_rotation_rad)),
      tool_(pose_of(robot.tool_place_m, robot.tool_rotation_rad)) {
  require(!robot.joint.empty(), "Arm: there are no joints");
  const Pose base = pose_of(robot.base_place_m, robot.base_rotation_rad);
  for (const ArmJointParameters& joint : robot.joint) {
    const double size = length(joint.axis);
    require(size > 0.0, "Arm: a joint has no axis");
    axis_.push_back(times(1.0 / size, joint.axis));
    const Pose link = pose_of(joint.place_m, joint.rotation_rad);
    link_.push_back(link_.empty() ? base * link : link);
  }
}

std::vector<Pose> Arm::frames(const Joints& angle_rad) const {
  require(angle_rad.size() == joint_count(), "Arm: a posture has one angle for each joint");
  std::vector<Pose> all;
  all.reserve(joint_count() + 1);
  Pose frame;
  for (std::size_t i = 0; i < joint_count(); ++i) {
    frame = frame * link_[i] * Pose{{}, attitude_of(times(angle_rad[i], axis_[i]))};
    all.push_back(frame);
  }
  all.push_back(frame * flange_);
  return all;
}

Pose Arm::palm(const Joints& angle_rad) const { return frames(angle_rad).back() * tool_; }

std::vector<Twist> Arm::jacobian(const Joints& angle_rad) const {
  const std::vector<Pose> all = frames(angle_rad);
  const Pose palm = all.back() * tool_;
  std::vector<Twist> columns;
  columns.reserve(joint_count());
  for (std::size_t i = 0; i < joint_count(); ++i) {
    const Vector z = turned(all[i].attitude, axis_[i]);
    columns.push_back({cross(z, between(all[i].place_m, palm.place_m)), z});
  }
  return columns;
}

Twist Arm::bias(const Joints& angle_rad, const Joints& speed_rad_s) const {
  const std::vector<Pose> all = frames(angle_rad);
  Vector place = all.front().place_m, w{};
  Twist a;
  const auto go_to = [&](const Vector& to) {
    const Vector r = between(place, to);
    a.linear = sum(a.linear, sum(cross(a.angular, r), cross(w, cross(w, r))));
    place = to;
  };
  for (std::size_t i = 0; i < joint_count(); ++i) {
    go_to(all[i].place_m);
    const Vector turning = times(speed_rad_s[i], turned(all[i].attitude, axis_[i]));
    a.angular = sum(a.angular, cross(w, turning));
    w = sum(w, turning);
  }
  go_to((all.back() * tool_).place_m);
  return a;
}

Joints Arm::seed_rad() const {
  Joints seed = robot_.seed_posture_rad;
  seed.resize(joint_count(), 0.0);
  for (std::size_t i = 0; i < seed.size(); ++i) {
    const ArmJointParameters& joint = robot_.joint[i];
    seed[i] = std::max(seed[i], joint.lower_rad.value_or(seed[i]));
    seed[i] = std::min(seed[i], joint.upper_rad.value_or(seed[i]));
  }
  return seed;
}

double Arm::position_use(std::size_t joint, double angle_rad) const {
  const ArmJointParameters& limits = robot_.joint[joint];
  if (!limits.lower_rad || !limits.upper_rad) return 0.0;
  const double middle = 0.5 * (*limits.lower_rad + *limits.upper_rad);
  return std::abs(angle_rad - middle) / (0.5 * (*limits.upper_rad - *limits.lower_rad));
}

}  // namespace unbruised
