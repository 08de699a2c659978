#pragma once

/// @file
/// The way of a palm from stop to stop: each leg from rest to rest, turning as it goes.

#include <array>
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
};

/// On a leg the palm goes straight and turns about a fixed axis by the shortest way. Both follow one profile, the
/// fastest of its kind with which neither speed nor acceleration of either passes its limit.
class PalmPath {
 public:
  /// Limits of one motion.
  struct Limits {
    double speed = 0.0, acceleration = 0.0;  ///< > 0
  };

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
  };

  std::vector<Leg> legs_;
  PalmStop from_;  ///< where it stands without legs
  double duration_s_ = 0.0;
};

}  // namespace unbruised
