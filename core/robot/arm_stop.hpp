#pragma once

/// @file
/// An emergency stop of an arm: along its path, as hard as its joints can brake.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/motion/stop_law.hpp"
#include "core/robot/arm.hpp"
#include "core/robot/arm_dynamics.hpp"

namespace unbruised {

/// How a joint may brake then; none: only its torque limits it.
inline std::optional<double> stop_deceleration_rad_s2(const RobotParameters& robot, std::size_t joint) {
  const std::vector<double>& own = robot.deceleration_rad_s2;
  return of_joint(own.empty() ? robot.acceleration_rad_s2 : own, joint);
}

/// How an arm goes along its path as planned, and what hangs on it.
struct PathMotion {
  ArmMotion motion;
  std::vector<PointLoad> loads;
};
using ArmPath = std::function<std::optional<PathMotion>(double plan_s)>;

/// At each moment the joint speeds q' s' and accelerations q' s'' + q'' s'^2 of the slowed path, whose torques are
/// linear in s'', leave a range of s''; its lower end is taken, of the two ends of each part the gentler.
/// @return none: the path ends, or the arm is not at rest after 5 s
std::optional<StopLaw> arm_stop(const Arm& arm, const ArmPath& path, double start_s,
                                const std::array<double, 3>& gravity_m_s2);

}  // namespace unbruised
