#pragma once

/// @file
/// What the drives of a gripper are told, whatever its kind.

#include "core/lanes/lane.hpp"

namespace unbruised {

/// For one step, per lane, at t + theta dt.
struct DriveCommand {
  Lane force_limit_N{0.0};
  Lane set_speed_m_s{0.0};
  Lane told{1.0};  ///< share of the step for which the set speed is known; until then the drive goes on as it did
  Lane locked{0.0};  ///< share of the step in which a gripper that holds by position is locked
  Lane palm_acceleration_x_m_s2{0.0};
  Lane centrifugal_1_s2{0.0};  ///< square of the palm's spin about the axes across the grip axis
};

}  // namespace unbruised
