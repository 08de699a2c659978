#pragma once

/// @file
/// The horizontal way of a palm that leaves one moving place for another: from a belt onto a table, from a table
/// onto a belt.

#include <array>

#include "core/motion/profile.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

using Horizontal = std::array<double, 2>;  ///< along x and y

/// A place that moves evenly.
struct MovingPlace {
  Horizontal place_m{};  ///< at the start of the transfer
  Horizontal velocity_m_s{};
};

/// From one moving place to another in the time T: velocity changes over the whole of T (evenly, or as 10 s^3 -
/// 15 s^4 + 6 s^5 where the profile is of minimum jerk or an s_curve), and what is left of the way is a
/// rest-to-rest profile of that time on top. T is the shortest found in which both together stay within the limits
/// of speed, acceleration and, of an s_curve, jerk. To meet a place that leads, the palm is up to 1.44 times as
/// fast (1 / 2 + 15 / 16): hence kPalmRoom.
class MovingTransfer {
 public:
  /// Nowhere, at once.
  MovingTransfer() = default;
  /// @param m > 0, the speed kPalmRoom times that of the faster place or more
  static MovingTransfer plan(ProfileKind kind, const MovingPlace& from, const MovingPlace& to,
                             const MotionLimits& m);

  [[nodiscard]] double duration_s() const { return duration_s_; }

  /// When the acceleration jumps, after the start [s].
  [[nodiscard]] std::vector<double> jumps_s() const { return rest_.jumps_s(); }

  struct State {
    Horizontal place_m{}, velocity_m_s{}, acceleration_m_s2{};
    Horizontal jerk_m_s3{};  ///< where the acceleration does not jump
  };
  /// With the first place before the start, with the second after the end.
  [[nodiscard]] State at(double time_s) const;

 private:
  MovingTransfer(ProfileKind kind, const MovingPlace& from, const MovingPlace& to, double duration_s);

  ProfileKind kind_ = ProfileKind::minimum_jerk;
  MovingPlace from_, to_;
  Horizontal along_{};  ///< of what is left of the way
  MotionProfile rest_;
  double duration_s_ = 0.0;
};

}  // namespace unbruised
