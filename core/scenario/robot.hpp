#pragma once

/// @file
/// The parameters of the arm that carries the gripper: a chain of turning joints from its base to its flange, what
/// hangs on it, and how it is asked to follow the palm. Frames: x, y, z of the cell have their origin where the
/// support's plane lies under the product's middle at the start.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace unbruised {

/// Most joints of an arm.
inline constexpr std::size_t kMostArmJoints = 8;

/// A turning joint and the link that it moves. Vectors are in the frame that turns with the joint.
struct ArmJointParameters {
  /// Of the joint's frame, at angle 0, in the frame of the joint before it, of the first in that of the base.
  std::array<double, 3> place_m{};
  std::array<double, 3> rotation_rad{};
  /// Not zero; the joint turns about it, of any length.
  std::array<double, 3> axis{0.0, 0.0, 1.0};
  /// < upper_rad; none: it turns without end
  std::optional<double> lower_rad;
  std::optional<double> upper_rad;
  /// > 0
  double speed_rad_s = 3.0;
  /// > 0
  double torque_N_m = 100.0;
  /// >= 0; of the link
  double mass_kg = 0.0;
  std::array<double, 3> center_of_mass_m{};
  /// About the centre of mass: xx, yy, zz, xy, xz, yz; of a body that can be.
  std::array<double, 6> inertia_kg_m2{};
};

/// What becomes of a palm path that an arm cannot follow.
enum class RobotTiming {
  check,  ///< the scenario is out_of_range, with the joint, the time and the limit
  fit,    ///< lift, carrying and lowering are each slowed down until it can
};

struct RobotParameters {
  /// Of the arm's base in the cell.
  std::array<double, 3> base_place_m{};
  std::array<double, 3> base_rotation_rad{};
  /// Of the flange in the frame of the last joint.
  std::array<double, 3> flange_place_m{};
  std::array<double, 3> flange_rotation_rad{};
  /// Of the palm, the middle between the pads, in the frame of the flange. Its x is the grip axis, its z is up
  /// while the palm is upright: a flange whose z points out of it looks down on the product.
  std::array<double, 3> tool_place_m{0.0, 0.0, 0.15};
  std::array<double, 3> tool_rotation_rad{3.141592653589793, 0.0, 0.0};
  /// Empty: all 0, else one angle for each joint, within its limits; the start is the posture that is found from
  /// it.
  std::vector<double> seed_posture_rad;
  /// Each of these is empty, or has one for each joint or one for all. > 0; empty: no limits
  std::vector<double> acceleration_rad_s2;
  /// > 0; of an emergency stop. Empty: those of acceleration
  std::vector<double> deceleration_rad_s2;
  /// > 0; empty: no limits
  std::vector<double> jerk_rad_s3;
  /// > 0; of the joints' gears, as springs between motor and link. Empty: rigid
  std::vector<double> stiffness_N_m_rad;
  /// >= 0, < 1; of each mode of an arm with such springs
  double damping_ratio = 0.05;
  /// > 0; of each joint's controller, which follows its angle as a lag of first order. Empty: at once
  std::vector<double> bandwidth_Hz;
  /// >= 0; a point at gripper_center_of_mass_m of the flange
  double gripper_mass_kg = 0.0;
  std::array<double, 3> gripper_center_of_mass_m{0.0, 0.0, 0.05};
  /// > 0; of gripper and product together
  std::optional<double> max_payload_kg;
  RobotTiming timing = RobotTiming::check;
  /// > 0, <= 1; of each limit of speed, acceleration, jerk and torque, so much may be used
  double use_most = 1.0;
  /// None: no arm. At most 8, from the base on.
  std::vector<ArmJointParameters> joint;
};

/// A joint's number of a list with one for each joint or one for all.
inline std::optional<double> of_joint(const std::vector<double>& list, std::size_t joint) {
  if (list.empty()) return std::nullopt;
  return list.size() == 1 ? list.front() : list[joint];
}

}  // namespace unbruised
