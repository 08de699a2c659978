#pragma once

/// @file
/// The plan of one handling cycle: grip, lift, hold, transfer, lower, release, recover. A tilt is taken as the
/// hold begins and taken back as the transfer ends. Times are real numbers; everything is fixed by the scenario
/// and the time at which the grip is ramped up. A plan never changes: the simulator follows one, and the estimate
/// of a run's cost reads its end.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "core/motion/belt.hpp"
#include "core/motion/moving_transfer.hpp"
#include "core/motion/profile.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Motion along x, y, z from where the product's starting place has its palm and its plane: of the palm, of a
/// plane.
struct PalmState {
  std::array<double, 3> position_m{};
  std::array<double, 3> velocity_m_s{};
  std::array<double, 3> acceleration_m_s2{};
  /// About the centre of the pads, from upright: about the vector by its length; the other two along it.
  std::array<double, 3> rotation_rad{};
  std::array<double, 3> spin_rad_s{};
  std::array<double, 3> spin_acceleration_rad_s2{};
};

/// The phases in their order; the codes stand in results files.
enum class CyclePhase : std::uint8_t { approach, grip, lift, hold, transfer, lower, release, recover, stop };
inline constexpr std::array<std::string_view, 9> kCyclePhaseWords = {
    "approach", "grip", "lift", "hold", "transfer", "lower", "release", "recover", "stop"};

/// The planes under the product.
enum class SupportPlane {
  start,   ///< what it stands on, a belt where there is one
  target,  ///< what it is put down on; the same one where neither height nor motion differs
};

/// A time that does not come.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

class MotionPlan {
 public:
  MotionPlan() = default;
  /// @param ramp_start_s when the drive's force limit begins to rise; kNever: the fingers only approach
  MotionPlan(const Scenario& scenario, double ramp_start_s);

  /// The phase at a time after the first contact; lower lasts until the fingers open.
  [[nodiscard]] CyclePhase phase_after_contact(double time_s) const;
  /// Has an emergency stop begun?
  [[nodiscard]] bool is_stopped(double time_s) const { return time_s > stop_s_; }
  [[nodiscard]] PalmState palm(double time_s) const;
  /// Largest drive force per finger.
  [[nodiscard]] double force_limit_N(double time_s) const;
  /// Closing speed the drive aims at per finger, before the end stops of the stroke are looked at.
  [[nodiscard]] double set_speed_m_s(double time_s) const;
  /// The plane under a product that follows the plan.
  [[nodiscard]] SupportPlane support_plane(double time_s) const;
  [[nodiscard]] PalmState support(SupportPlane plane, double time_s) const;
  /// Where the product is to stand, from where it stood at the start, along x and y [m].
  [[nodiscard]] Horizontal target_m(double time_s) const;
  [[nodiscard]] const Belt& belt() const { return belt_; }

  [[nodiscard]] double lift_start_s() const { return lift_start_s_; }
  [[nodiscard]] double lift_end_s() const { return lift_end_s_; }
  /// The lift and the tilt are over.
  [[nodiscard]] double hold_start_s() const { return hold_start_s_; }
  [[nodiscard]] double hold_end_s() const { return hold_end_s_; }
  [[nodiscard]] double lower_end_s() const { return lower_end_s_; }
  [[nodiscard]] double release_start_s() const { return release_start_s_; }
  [[nodiscard]] double release_end_s() const { return release_end_s_; }
  /// End of the run.
  [[nodiscard]] double end_s() const { return end_s_; }

 private:
  void schedule(const Scenario& scenario);
  void stop(double time_s, double deceleration_m_s2);
  [[nodiscard]] PalmState planned_palm(double time_s) const;
  [[nodiscard]] PalmState braking_palm(double time_s) const;
  /// The horizontal part.
  [[nodiscard]] PalmState across(double time_s) const;

  StrategyParameters strategy_{};
  double pressing_speed_m_s_ = 0.0;  ///< aimed at once the force limit rises
  double place_height_m_ = 0.0;
  Horizontal transfer_m_{}, place_velocity_m_s_{};
  Belt belt_;
  bool target_differs_ = false;
  MotionProfile lift_, tilt_, transfer_, lower_;  ///< the tilt in rad
  Horizontal transfer_direction_{};
  std::array<double, 3> tilt_axis_{0.0, 0.0, 0.0};
  /// Instead of transfer_ where palm or target move during the pick or the placing.
  std::optional<MovingTransfer> moving_transfer_;
  double ramp_start_s_ = kNever, lift_start_s_ = kNever, lift_end_s_ = kNever;
  double hold_start_s_ = kNever, hold_end_s_ = kNever, level_start_s_ = kNever;
  double transfer_end_s_ = kNever, lower_end_s_ = kNever, release_start_s_ = kNever, release_end_s_ = kNever;
  double end_s_ = kNever;
  double stop_s_ = kNever, stop_deceleration_m_s2_ = 0.0;
  PalmState stopped_;  ///< where the stop begins
};

}  // namespace unbruised
