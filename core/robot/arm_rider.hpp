#pragma once

/// @file
/// An arm along a plan, time by time: the branch of the inverse kinematics is that of the time before.

#include <optional>
#include <vector>

#include "core/motion/motion_plan.hpp"
#include "core/robot/arm.hpp"
#include "core/robot/arm_dynamics.hpp"

namespace unbruised {

struct ArmSample {
  double time_s = 0.0;
  CyclePhase phase = CyclePhase::approach;
  ArmMotion motion;
  Joints jerk_rad_s3;  ///< the larger of those before and after, where it is limited; else empty
  Joints torque_N_m;
};

class ArmRider {
 public:
  /// Both are kept as references. @param scenario has a robot
  ArmRider(const Scenario& scenario, const MotionPlan& plan)
      : scenario_(scenario), plan_(plan), arm_(scenario.robot) {}

  [[nodiscard]] const Arm& arm() const { return arm_; }

  /// The posture at the start; none: it is out of reach.
  [[nodiscard]] std::optional<Joints> start() const;

  struct Stop {
    std::optional<ArmSample> sample;  ///< none: out of reach or singular
    bool is_in_reach = false;
    double manipulability = 0.0;
  };
  /// @param from a posture close by
  [[nodiscard]] Stop at(double time_s, const Joints& from) const;
  /// The same without torques and jerks.
  [[nodiscard]] Stop motion_at(double time_s, const Joints& from) const;

  /// Does the product hang on it?
  [[nodiscard]] bool is_loaded(double time_s) const {
    return time_s >= plan_.lift_start_s() && time_s < plan_.release_start_s();
  }
  [[nodiscard]] std::vector<PointLoad> loads_at(double time_s) const;
  /// Of the arm at rest in this posture.
  [[nodiscard]] Joints weight_at(const Joints& angle_rad, double time_s) const;

 private:
  void add_jerk(ArmSample& sample) const;

  const Scenario& scenario_;
  const MotionPlan& plan_;
  Arm arm_;
};

/// Where the arm will be about: near enough that the posture is found at once.
Joints foreseen(const ArmSample& last, double time_s);

/// The arm's frame of the palm: the middle between the pads, x along the grip axis, z up.
Pose palm_pose(const Scenario& scenario, const PalmState& palm);
/// Where that is at the start, the palm upright.
std::array<double, 3> palm_start_m(const Scenario& scenario);
/// What hangs on the flange. @param carried the product too
std::vector<PointLoad> flange_loads(const Scenario& scenario, bool carried);

}  // namespace unbruised
