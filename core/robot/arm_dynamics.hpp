#pragma once

/// @file
/// Torques of an arm's joints: recursive Newton-Euler in the axes of the cell (Luh, Walker & Paul 1980, J. Dyn.
/// Sys. Meas. Control 102, 69-76).

#include <array>
#include <vector>

#include "core/robot/arm.hpp"

namespace unbruised {

/// A mass at a place of the flange.
struct PointLoad {
  double mass_kg = 0.0;
  std::array<double, 3> place_m{};
};

struct ArmMotion {
  Joints angle_rad, speed_rad_s, acceleration_rad_s2;
};

/// The torques that move the arm so, against gravity.
/// @return one for each joint [N m]
Joints joint_torques(const Arm& arm, const ArmMotion& motion, const std::vector<PointLoad>& loads,
                     const std::array<double, 3>& gravity_m_s2);

/// Of motion, and of height against gravity from the origin of the cell [J].
struct ArmEnergy {
  double kinetic_J = 0.0;
  double potential_J = 0.0;
};
ArmEnergy arm_energy(const Arm& arm, const ArmMotion& motion, const std::vector<PointLoad>& loads,
                     const std::array<double, 3>& gravity_m_s2);

}  // namespace unbruised
