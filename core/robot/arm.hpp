#pragma once

/// @file
/// The geometry of an arm: where its joints, its flange and the palm are, how they move with the joints, and which
/// posture brings the palm to a place.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/scenario/attitude.hpp"
#include "core/scenario/robot.hpp"

namespace unbruised {

/// A place and an attitude of one frame in another.
struct Pose {
  std::array<double, 3> place_m{};
  Attitude attitude;
};
/// First `second`, then `first`.
Pose operator*(const Pose& first, const Pose& second);
Pose pose_of(const std::array<double, 3>& place_m, const std::array<double, 3>& rotation_rad);
Pose inverse(const Pose& pose);

/// Velocity and spin, or acceleration and its spin's, along x, y, z.
struct Twist {
  std::array<double, 3> linear{};
  std::array<double, 3> angular{};
};

/// Angles, speeds or torques, one for each joint from the base on.
using Joints = std::vector<double>;

class Arm {
 public:
  /// @param robot has joints, whose axes are not zero
  explicit Arm(const RobotParameters& robot);

  [[nodiscard]] std::size_t joint_count() const { return robot_.joint.size(); }
  [[nodiscard]] const RobotParameters& robot() const { return robot_; }
  /// From the frame of a joint to its axis, of length 1.
  [[nodiscard]] const std::array<double, 3>& axis(std::size_t joint) const { return axis_[joint]; }

  /// The frames of the joints, turned by their angles, and of the flange in the cell.
  [[nodiscard]] std::vector<Pose> frames(const Joints& angle_rad) const;
  [[nodiscard]] Pose palm(const Joints& angle_rad) const;
  /// How the palm moves with each joint: 6 x n, a column for each.
  [[nodiscard]] std::vector<Twist> jacobian(const Joints& angle_rad) const;
  /// The acceleration of the palm where no joint accelerates.
  [[nodiscard]] Twist bias(const Joints& angle_rad, const Joints& speed_rad_s) const;

  /// The seed: within the joints' limits.
  [[nodiscard]] Joints seed_rad() const;
  /// Distance of a joint from the middle of its range over half of it, at most 1 within; 0 where it has no limits.
  [[nodiscard]] double position_use(std::size_t joint, double angle_rad) const;

 private:
  RobotParameters robot_;
  std::vector<std::array<double, 3>> axis_;
  std::vector<Pose> link_;  ///< of each joint at angle 0 in the one before it
  Pose flange_;             ///< in the last joint
  Pose tool_;               ///< the palm in the flange
};

// Inverse kinematics (arm_inverse.cpp).

/// The posture nearest to `from` that brings the palm there, by damped least squares (Nakamura & Hanafusa 1986,
/// J. Dyn. Sys. Meas. Control 108, 163-171): J' (J J' + lambda I)^-1 e, lambda smaller after each step that helps.
/// @param keep_limits joints stop at their limits on the way
/// @return none: it is out of reach. Place and angle agree within 1e-10 m and rad.
std::optional<Joints> posture_for(const Arm& arm, const Pose& palm, Joints from, bool keep_limits);

/// What the Jacobian says of a posture: joint rates x of least size with J x = twist, and the smallest over the
/// largest singular value of J, lengths in m. Rates of six joints are those of a J that is not singular.
struct JointRates {
  Joints rate;
  double residual = 0.0;  ///< |J x - twist| over |twist|, 0 where the arm can
};
JointRates rates_for(const std::vector<Twist>& jacobian, const Twist& twist);
double manipulability(const std::vector<Twist>& jacobian);

}  // namespace unbruised
