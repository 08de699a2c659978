#pragma once

/// @file
/// What follows from the parameters of a conveyor alone.

#include <array>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A palm that meets a moving place is up to 1.44 times as fast (motion/moving_transfer.hpp).
inline constexpr double kPalmRoom = 1.5;

/// Does the support move?
bool has_belt(const CellParameters& cell);
/// Unit vector along which the belt runs, x and y; the direction as written must not be zero.
std::array<double, 2> belt_direction(const ConveyorParameters& conveyor);
/// Speed at the start of the run, at which the product rides along [m/s].
double belt_start_speed_m_s(const ConveyorParameters& conveyor);

}  // namespace unbruised
