#pragma once

/// @file
/// The way of a palm from stop to stop: each leg from rest to rest or blended into the next, turning as it goes.

#include <array>
#include <optional>
#include <vector>

#include "core/motion/profile.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Where a palm is, how it has turned, and how both change.
struct PalmState {
  /// Along x, y, z from where the product's starting place has its palm.
  std::array<double, 3> position_m{};
  std::array<double, 3> velocity_m_s{};
  std::array<double, 3> acceleration_m_s2{};
  /// About the centre of the pads, from upright: about the vector by its length; the other two along x, y, z.
  std::array<double, 3> rotation_rad{};
  std::array<double, 3> spin_rad_s{};
  std::array<double, 3> spin_acceleration_rad_s2{};

  bool operator==(const PalmState&) const = default;
};

/// On a leg the palm goes straight, or on an arc, and turns about a fixed axis by the shortest way. Both follow
/// one profile, the fastest of its kind with which neither speed nor acceleration nor, of an s_curve, jerk of
/// either passes its limit; on an arc acceleration and jerk are those along and across it together. At a stop that
/// is blended the next leg begins before the last has ended: both motions add up, so that the path is as smooth as
/// they are, and by so much that the palm passes within blend_m of the stop and all limits hold; where that is
/// faster the legs of a path with blends leave room for it.
class PalmPath {
 public:
  using Limits = MotionLimits;

  PalmPath() = default;
  PalmPath(const PalmStop& from, const std::vector<PalmStop>& stops, ProfileKind profile, const Limits& m,
           const Limits& rad);

  /// Until the last stop has been waited at [s].
  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// When the acceleration jumps [s].
  [[nodiscard]] std::vector<double> jumps_s() const;
  /// At rest at its ends before the start and after the end.
  [[nodiscard]] PalmState at(double time_s) const;

 private:
  struct Leg {
    double start_s = 0.0;
    PalmStop from;
    std::array<double, 3> way_m{}, turn_rad{};
    MotionProfile share;  ///< from 0 to 1
    std::optional<Arc> arc;

    [[nodiscard]] double end_s() const { return start_s + share.duration_s(); }
    /// How place and attitude differ from those where it began; the rates are along x, y, z.
    [[nodiscard]] PalmState done(const MotionProfile::State& share_done) const;
  };
  /// How the palm jerks while two legs add up: of what both profiles give.
  struct Peaks {
    double speed = 0.0, acceleration = 0.0, jerk = 0.0, spin = 0.0, spin_acceleration = 0.0, spin_jerk = 0.0;
    double least_distance_m = 0.0;  ///< from the stop between them
  };
  [[nodiscard]] static Peaks peaks_of(const Leg& last, const Leg& next, double overlap_s);
  /// By how much the next leg begins before the last has ended [s].
  [[nodiscard]] static double overlap_s(const Leg& last, const Leg& next, double blend_m, const Limits& m,
                                        const Limits& rad);

  /// @param room share of the limits of acceleration and jerk that each leg alone may use
  void add_legs(const std::vector<PalmStop>& stops, ProfileKind profile, const Limits& m, const Limits& rad,
                double room);

  std::vector<Leg> legs_;
  PalmStop from_;  ///< where it stands without legs
  double duration_s_ = 0.0;
};

}  // namespace unbruised
