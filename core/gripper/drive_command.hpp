#pragma once

/// @file
/// What the drives of a gripper are told, whatever its kind.

#include <array>

#include "core/lanes/lane.hpp"
#include "core/scenario/finger_axes.hpp"

namespace unbruised {

/// For one step, per lane, at t + theta dt.
struct DriveCommand {
  Lane force_limit_N{0.0};
  Lane set_speed_m_s{0.0};
  Lane told{1.0};  ///< share of the step for which the set speed is known; until then the drive goes on as it did
  Lane locked{0.0};  ///< share of the step in which a gripper that holds by position is locked
  /// Of the palm, gravity counted against it, along the way of each finger.
  std::array<Lane, kMostFingers> palm_acceleration_m_s2 = none();
  /// Square of the palm's spin about the axes across the way of each finger.
  std::array<Lane, kMostFingers> centrifugal_1_s2 = none();

 private:
  static std::array<Lane, kMostFingers> none() {
    std::array<Lane, kMostFingers> values;
    values.fill(Lane(0.0));
    return values;
  }
};

}  // namespace unbruised
