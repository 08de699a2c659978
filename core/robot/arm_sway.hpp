#pragma once

/// @file
/// How the joints of an arm really move where their controllers lag and their gears give way.

#include <memory>
#include <vector>

#include "core/robot/arm.hpp"
#include "core/robot/arm_dynamics.hpp"

namespace unbruised {

/// Told q, a motor goes tau m' = q - m, tau = 1 / (2 pi bandwidth). Behind it the links l = m + e hang on the
/// springs of the joints, K = diag(k): M e'' + C e' + K e = -f, with M of the arm and what it carries in the
/// posture m, f the torques that move all of it as the motors do (those of weight the controller has taken out: at
/// rest e = 0), and C with which every mode has the same damping ratio. Each mode is stepped exactly for a torque
/// that changes evenly over the step; one that is too fast for the steps follows without ringing.
class ArmSway {
 public:
  /// In steady motion at the start.
  /// @param arm kept as a reference @param told, loads at the start
  ArmSway(const Arm& arm, double step_s, const ArmMotion& told, const std::vector<PointLoad>& loads);
  ~ArmSway();

  /// How the links move. @param told a step later
  ArmMotion follow(const ArmMotion& told, const std::vector<PointLoad>& loads);
  [[nodiscard]] const ArmMotion& links() const { return links_; }

 private:
  struct Springs;

  void follow_motors(const ArmMotion& told);

  const Arm& arm_;
  double step_s_;
  Joints told_speed_rad_s_;
  Joints lag_rad_;  ///< q - m
  ArmMotion motors_, links_;
  std::unique_ptr<Springs> springs_;  ///< nullptr: the joints are rigid
};

}  // namespace unbruised
