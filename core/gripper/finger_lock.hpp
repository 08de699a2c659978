#pragma once

/// @file
/// A brake or an air lock that holds each finger where it stands, all lanes at once. It goes on with the force D
/// that the drive pressed with as it closed, and answers each way x from there with a spring and a damper:
/// L = D - k (x + tau x'). Without a stiffness it does not give way at all.

#include <array>
#include <optional>

#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// A loss ratio of 0.2 at 50 Hz, as of rubber [s].
inline constexpr double kLockRelaxationTime_s = 0.2 / (2.0 * 3.14159265358979323846 * 50.0);

class FingerLock {
 public:
  /// @param is_there is there a lock in this lane? @param stiffness_N_m none: it does not give way
  void load(int lane, bool is_there, const std::optional<double>& stiffness_N_m);
  /// All that a lane keeps from step to step, but for what `load` sets.
  void archive(LaneArchive& lane) {
    for (Held& held : held_) lane.members(held);
    lane(closed_);
  }

  /// @param closed for which share of the step it is closed
  void begin_step(const WilsonTheta& wilson, const Lane& closed);
  /// Takes hold of a finger where it was open before. @param drive_N what the drive presses with
  void grasp(int finger, const Lane& way_m, const Lane& drive_N);
  /// A lock that closes within a step holds the finger from where it stood then.
  void slide(int finger, const std::array<Lane, 2>& way_m, const std::array<Lane, 2>& drive_N,
             const Mask& running);

  /// Is it closed in some lane?
  [[nodiscard]] bool any_closed() const { return any_closed_; }
  [[nodiscard]] const Lane& closed() const { return closed_; }
  /// Lanes in which it is closed and gives way, and in which it does not.
  [[nodiscard]] Mask springs() const { return (closed_ > Lane(0.0)) & gives_way_; }
  [[nodiscard]] Mask stands() const { return (closed_ > Lane(0.0)) & !gives_way_; }

  /// D.
  [[nodiscard]] const Lane& drive_N(int finger) const { return held_[static_cast<std::size_t>(finger)].drive; }
  /// Of spring and damper at t + theta dt: their force falls with the way by this, [N/m],
  [[nodiscard]] const Lane& slope() const { return slope_; }
  /// from what it is at way 0. @param viscous a1 w + 2 w' + a3 w'' of the finger at the start of the step
  [[nodiscard]] Lane force_at_zero(int finger, const Lane& viscous) const {
    return stiffness_ * (held_[static_cast<std::size_t>(finger)].place + Lane(kLockRelaxationTime_s) * viscous);
  }
  /// Energy of the spring, [J].
  [[nodiscard]] Lane stored(int finger, const Lane& way_m) const {
    const Lane x = way_m - held_[static_cast<std::size_t>(finger)].place;
    return Lane(0.5) * closed_ * stiffness_ * x * x;
  }

 private:
  struct Held {
    Lane place{0.0}, drive{0.0};
  };
  std::array<Held, kMostFingers> held_;
  Mask there_{false}, gives_way_{false}, closes_{false};
  Lane stiffness_{0.0}, slope_{0.0}, closed_{0.0};
  bool any_closed_ = false;
};

}  // namespace unbruised
