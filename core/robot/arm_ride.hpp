#pragma once

/// @file
/// How an arm follows the palm of a scenario: its posture, speeds, accelerations and torques along the planned
/// path, and the first limit that it would break. Nothing here steps in time: the path is known when it is
/// planned.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/motion_plan.hpp"
#include "core/robot/arm_rider.hpp"

namespace unbruised {

/// What an arm can run into.
enum class ArmLimit : std::uint8_t { reach, singular, position, speed, acceleration, jerk, torque, payload };

/// The ratio of the Jacobian's singular values below which a posture is called singular.
inline constexpr double kLeastManipulability = 1e-3;

struct ArmBreach {
  ArmLimit limit = ArmLimit::reach;
  double time_s = 0.0;
  int joint = -1;    ///< from 0; -1: it is of the whole arm
  double use = 0.0;  ///< of the limit, where it has a size
};
/// "joint 3 needs 1.31 of its torque".
std::string words_of(const ArmBreach& breach);

/// The largest use of one limit along the way.
struct ArmUse {
  double use = 0.0;
  int joint = -1;
  double time_s = 0.0;
};

/// Phases that one slowing stretches together.
enum class ArmLeg : std::uint8_t { lift, carry, lower };

/// What one leg asks for.
struct LegNeed {
  /// The least factor by which its time has to be stretched so that no joint breaks a limit: speeds fall with it,
  /// accelerations and their torques with its square, torques of weight stay. Infinite: weight alone is too much.
  double stretch = 1.0;
  double jerk_stretch = 1.0;                  ///< the same of jerks, which fall with its cube
  double peak_m_s2 = 0.0, peak_rad_s2 = 0.0;  ///< of the palm
};

struct ArmRide {
  std::vector<ArmSample> samples;
  ArmUse position, speed, acceleration, jerk, torque;
  double least_manipulability = 1.0;
  double joint_travel_rad = 0.0;
  double moving_s = 0.0;            ///< from the start of the lift to the end of the lowering
  std::optional<ArmBreach> breach;  ///< the first; behind one of reach or a singular posture the samples end
  std::optional<ArmBreach> stuck;   ///< the first of reach, a singular posture or a range: slowing down mends none
  std::array<LegNeed, 3> need;

  /// The limit of which most is used: of range, speed, acceleration, jerk, torque.
  [[nodiscard]] ArmBreach binding() const;
};

/// @param scenario has a robot
/// @param plan whose palm is followed, from 0 to its end
ArmRide ride(const Scenario& scenario, const MotionPlan& plan);
/// At times that ascend, from the posture at the plan's start on: for traces. Empty where the arm gets stuck.
std::vector<ArmSample> ride_at(const Scenario& scenario, const MotionPlan& plan,
                               const std::vector<double>& time_s);

}  // namespace unbruised
