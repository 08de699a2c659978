#include "core/robot/arm_dynamics.hpp"

#include "core/door/require.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(double factor, const Vector& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

/// I x, in the axes of the cell.
Vector inertia_times(const std::array<double, 6>& inertia, const Attitude& attitude, const Vector& x) {
  const auto [xx, yy, zz, xy, xz, yz] = inertia;
  const Vector own = turned(inverse(attitude), x);
  return turned(attitude, {xx * own[0] + xy * own[1] + xz * own[2], xy * own[0] + yy * own[1] + yz * own[2],
                           xz * own[0] + yz * own[1] + zz * own[2]});
}

/// How the frame of a link moves.
struct LinkMotion {
  Pose frame;
  Vector axis{};  ///< of its joint, in the cell
  Vector velocity{}, acceleration{}, spin{}, spin_acceleration{};

  [[nodiscard]] Vector velocity_at(const Vector& r) const { return velocity + cross(spin, r); }
  [[nodiscard]] Vector acceleration_at(const Vector& r) const {
    return acceleration + cross(spin_acceleration, r) + cross(spin, cross(spin, r));
  }
};

/// @param base_acceleration_m_s2 of everything; - g stands for gravity
std::vector<LinkMotion> link_motions(const Arm& arm, const ArmMotion& motion,
                                     const Vector& base_acceleration_m_s2) {
  const std::vector<Pose> frames = arm.frames(motion.angle_rad);
  std::vector<LinkMotion> all;
  LinkMotion before;
  before.frame = frames.front();
  before.acceleration = base_acceleration_m_s2;
  for (std::size_t i = 0; i < arm.joint_count(); ++i) {
    LinkMotion link;
    link.frame = frames[i];
    link.axis = turned(frames[i].attitude, arm.axis(i));
    const Vector r = frames[i].place_m - before.frame.place_m;
    link.velocity = before.velocity_at(r);
    link.acceleration = before.acceleration_at(r);
    const Vector turning = motion.speed_rad_s[i] * link.axis;
    link.spin = before.spin + turning;
    link.spin_acceleration =
        before.spin_acceleration + motion.acceleration_rad_s2[i] * link.axis + cross(before.spin, turning);
    all.push_back(link);
    before = link;
  }
  return all;
}

/// Place of a load from the last joint, in the axes of the cell.
Vector arm_to(const Arm& arm, const LinkMotion& last, const PointLoad& load) {
  const RobotParameters& robot = arm.robot();
  return turned(last.frame.attitude,
                (pose_of(robot.flange_place_m, robot.flange_rotation_rad) * Pose{load.place_m, {}}).place_m);
}

}  // namespace

Joints joint_torques(const Arm& arm, const ArmMotion& motion, const std::vector<PointLoad>& loads,
                     const std::array<double, 3>& gravity_m_s2) {
  const std::size_t n = arm.joint_count();
  require(motion.speed_rad_s.size() == n && motion.acceleration_rad_s2.size() == n,
          "joint_torques: a motion has one number for each joint");
  const std::vector<LinkMotion> links = link_motions(arm, motion, -1.0 * gravity_m_s2);
  Joints torque(n);
  Vector force{}, moment{};  // of what the link carries, about its own joint
  for (const PointLoad& load : loads) {
    const Vector r = arm_to(arm, links.back(), load);
    const Vector f = load.mass_kg * links.back().acceleration_at(r);
    force = force + f;
    moment = moment + cross(r, f);
  }
  for (std::size_t i = n; i-- > 0;) {
    const LinkMotion& link = links[i];
    const ArmJointParameters& joint = arm.robot().joint[i];
    if (i + 1 < n) moment = moment + cross(links[i + 1].frame.place_m - link.frame.place_m, force);
    const Vector r = turned(link.frame.attitude, joint.center_of_mass_m);
    const Vector f = joint.mass_kg * link.acceleration_at(r);
    const auto I = [&](const Vector& x) { return inertia_times(joint.inertia_kg_m2, link.frame.attitude, x); };
    force = force + f;
    moment = moment + cross(r, f) + I(link.spin_acceleration) + cross(link.spin, I(link.spin));
    torque[i] = dot(link.axis, moment);
  }
  return torque;
}

ArmEnergy arm_energy(const Arm& arm, const ArmMotion& motion, const std::vector<PointLoad>& loads,
                     const std::array<double, 3>& gravity_m_s2) {
  const std::vector<LinkMotion> links = link_motions(arm, motion, {});
  ArmEnergy energy;
  const auto add = [&](double mass_kg, const LinkMotion& link, const Vector& r) {
    const Vector v = link.velocity_at(r);
    energy.kinetic_J += 0.5 * mass_kg * dot(v, v);
    energy.potential_J -= mass_kg * dot(gravity_m_s2, link.frame.place_m + r);
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LinkMotion& link = links[i];
    const ArmJointParameters& joint = arm.robot().joint[i];
    add(joint.mass_kg, link, turned(link.frame.attitude, joint.center_of_mass_m));
    energy.kinetic_J += 0.5 * dot(link.spin, inertia_times(joint.inertia_kg_m2, link.frame.attitude, link.spin));
  }
  for (const PointLoad& load : loads) add(load.mass_kg, links.back(), arm_to(arm, links.back(), load));
  return energy;
}

}  // namespace unbruised
