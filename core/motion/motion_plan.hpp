#pragma once

/// @file
/// The plan of one handling cycle: grip, lift, turn, hold, transfer, lower, release, recover. The palm turns by
/// its waypoints, as which it then puts the product down, or by a tilt, which it takes back before it lowers.
/// Times are real numbers; everything is fixed by the scenario and the time at which the grip is ramped up. A plan
/// never changes: the simulator follows one, and the estimate of a run's cost reads its end.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/motion/belt.hpp"
#include "core/motion/moving_transfer.hpp"
#include "core/motion/palm_carrier.hpp"
#include "core/motion/palm_path.hpp"
#include "core/motion/profile.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// The phases; the codes stand in results files. A palm turns between lift and hold, and a tilted one between
/// transfer and lowering too.
enum class CyclePhase : std::uint8_t { approach, grip, lift, hold, transfer, lower, release, recover, stop, turn };
inline constexpr std::array<std::string_view, 10> kCyclePhaseWords = {
    "approach", "grip", "lift", "hold", "transfer", "lower", "release", "recover", "stop", "turn"};

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
  /// @param guard_s when an instrument showed what the guard waits for; kNever: not yet
  /// @param carrier decides how an emergency stop brakes; nullptr: evenly, with cell.stop_deceleration_m_s2
  MotionPlan(const Scenario& scenario, double ramp_start_s, double guard_s = kNever,
             const PalmCarrier* carrier = nullptr);
  /// This plan, whose palm really goes along a track from its start on. @param track nullptr: as planned
  [[nodiscard]] MotionPlan tracked(std::shared_ptr<const PalmTrack> track) const;

  /// The phase at a time after the first contact; lower lasts until the fingers open.
  [[nodiscard]] CyclePhase phase_after_contact(double time_s) const;
  /// Has an emergency stop begun?
  [[nodiscard]] bool is_stopped(double time_s) const { return time_s > stop_s_; }
  /// Where the palm is.
  [[nodiscard]] PalmState palm(double time_s) const;
  /// Where it was told to be: what carries it may lag behind that and sway.
  [[nodiscard]] PalmState told_palm(double time_s) const;
  /// Does the palm go otherwise than it is told to?
  [[nodiscard]] bool has_track() const { return track_ != nullptr; }
  /// Does the palm go with a belt until the lift?
  [[nodiscard]] bool goes_with_belt() const { return tracks_; }
  /// Largest drive force per finger.
  [[nodiscard]] double force_limit_N(double time_s) const;
  /// For how much of the step with this time, t + theta dt, the drives know what they aim at. Of steps that are
  /// all as long as the scenario's.
  [[nodiscard]] double told(double time_s) const;
  /// In how much of a step a lock holds the fingers: from the start of the lift to that of the release.
  /// @param time_s t + theta dt of the step
  [[nodiscard]] double locked(double time_s, double end_s, double step_s) const;
  /// Closing speed the drive aims at per finger, before the end stops of the stroke are looked at.
  [[nodiscard]] double set_speed_m_s(double time_s) const;
  /// The plane under a product that follows the plan.
  [[nodiscard]] SupportPlane support_plane(double time_s) const;
  [[nodiscard]] PalmState support(SupportPlane plane, double time_s) const;
  /// Where the palm is to put the product down, from where the product stood at the start, along x and y [m].
  [[nodiscard]] Horizontal target_m(double time_s) const;
  [[nodiscard]] const Belt& belt() const { return belt_; }

  /// Does the acceleration of the palm jump between two times?
  [[nodiscard]] bool jumps_between(double from_s, double to_s) const;

  /// The force limit rises no more.
  [[nodiscard]] double ramp_end_s() const { return ramp_start_s_ + strategy_.grip_ramp_s; }
  [[nodiscard]] double lift_start_s() const { return lift_start_s_; }
  [[nodiscard]] double lift_end_s() const { return lift_end_s_; }
  /// The lift and the tilt or the waypoints are over.
  [[nodiscard]] double hold_start_s() const { return hold_start_s_; }
  [[nodiscard]] double hold_end_s() const { return hold_end_s_; }
  /// The transfer is over.
  [[nodiscard]] double level_start_s() const { return level_start_s_; }
  [[nodiscard]] double lower_end_s() const { return lower_end_s_; }
  [[nodiscard]] double release_start_s() const { return release_start_s_; }
  [[nodiscard]] double release_end_s() const { return release_end_s_; }
  /// End of the run.
  [[nodiscard]] double end_s() const { return end_s_; }

 private:
  void plan_speeds(const Scenario& scenario);
  void plan_ways(const Scenario& scenario);
  void schedule(const Scenario& scenario);
  void stop(const Scenario& scenario, const PalmCarrier* carrier);
  void find_jumps();
  /// How much of the force's ramp has passed, 0 to 1.
  [[nodiscard]] double ramped(double time_s) const;
  /// Closing speed before the grip, and of one that a guard has begun.
  [[nodiscard]] double guarded_speed_m_s(double time_s) const;
  [[nodiscard]] PalmState planned_palm(double time_s) const;
  [[nodiscard]] PalmState braking_palm(double time_s) const;
  /// Gives a palm that goes from stop to stop its horizontal way beside that: with a belt, and of the transfer.
  void go_across(double time_s, PalmState& palm) const;

  StrategyParameters strategy_{};
  double pressing_speed_m_s_ = 0.0;  ///< aimed at once the force limit rises
  double guard_s_ = kNever;
  double command_step_s_ = 0.0, command_lag_s_ = 0.0;  ///< dt, theta dt
  double place_height_m_ = 0.0;
  Horizontal transfer_m_{}, place_velocity_m_s_{};
  Belt belt_;
  bool tracks_ = false;  ///< the palm goes with it
  bool target_differs_ = false;
  MotionProfile lift_, transfer_, lower_;
  PalmPath path_;   ///< from the end of the lift, or where a palm that tracked has come to rest, to the hold
  PalmPath level_;  ///< back to upright, after a tilt
  Horizontal transfer_direction_{};
  /// From a belt to rest over the first waypoint.
  std::optional<MovingTransfer> leave_;
  /// Instead of transfer_ where palm or target move during the pick or the placing.
  std::optional<MovingTransfer> moving_transfer_;
  double ramp_start_s_ = kNever, lift_start_s_ = kNever, lift_end_s_ = kNever;
  double leave_end_s_ = kNever;  ///< the path from stop to stop begins
  double hold_start_s_ = kNever, hold_end_s_ = kNever, level_start_s_ = kNever;
  double transfer_end_s_ = kNever, lower_end_s_ = kNever, release_start_s_ = kNever, release_end_s_ = kNever;
  double end_s_ = kNever;
  double stop_s_ = kNever, stop_deceleration_m_s2_ = 0.0;
  PalmState stopped_;                            ///< where the stop begins
  std::optional<StopLaw> law_;                   ///< of a stop along the path
  std::shared_ptr<const MotionPlan> unstopped_;  ///< that path
  std::shared_ptr<const PalmTrack> track_;
  std::vector<double> jump_s_;  ///< of the palm's acceleration, ascending
};

/// The plan where the fingers meet the product as it is planned, but for what they compress.
MotionPlan planned_motion(const Scenario& scenario, const PalmCarrier* carrier = nullptr);

/// When a scenario ends in which everything goes as planned, but for what the fingers compress [s].
double planned_end_s(const Scenario& scenario);

}  // namespace unbruised
