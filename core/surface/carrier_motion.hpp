#pragma once

/// @file
/// How what carries a surface moves: every surface that can move gives its place, velocity and acceleration,
/// because a viscous layer answers to the velocity and the integration extrapolates with the acceleration.

#include <array>
#include <vector>

#include "core/lanes/lane_archive.hpp"
#include "core/lanes/lane_vector.hpp"

namespace unbruised {

/// Motion along one axis since the start, per lane.
struct AxisMotion {
  Lane place_m{0.0}, velocity_m_s{0.0}, acceleration_m_s2{0.0};
};

/// Sets place, velocity and acceleration in one lane.
inline void set_motion(AxisMotion& motion, int lane, const std::array<double, 3>& values) {
  motion.place_m.set(lane, values[0]);
  motion.velocity_m_s.set(lane, values[1]);
  motion.acceleration_m_s2.set(lane, values[2]);
}

/// The carriers of surfaces at one time, each along x, y, z: the palm carries the fingers with their pads, the
/// cell the support. A surface that the cell lists is a carrier by itself, along its own axes.
struct CarrierMotion {
  std::array<AxisMotion, 3> palm, cell;
  std::vector<std::array<AxisMotion, 3>> listed;  ///< as many as the cells of the lanes list
  /// Of the palm, which turns about the centre of the pads, from upright; the other two along x, y, z.
  LaneVector palm_rotation_rad, palm_spin_rad_s, palm_spin_acceleration_rad_s2;

  /// All of one lane.
  void archive(LaneArchive& lane) {
    for (std::array<AxisMotion, 3>* carrier : {&palm, &cell}) lane.members(*carrier);
    for (std::array<AxisMotion, 3>& surface : listed) lane.members(surface);
    lane(palm_rotation_rad.at, palm_spin_rad_s.at, palm_spin_acceleration_rad_s2.at);
  }
};

}  // namespace unbruised
