#pragma once

/// @file
/// A product that begins turned.

#include <array>

#include "core/body/body_model.hpp"
#include "core/body/body_state.hpp"

namespace unbruised {

/// Turns a whole state about the centre of mass at rest: places, velocities and accelerations.
/// @param rotation_rad about this vector by its length
void turn_state(const BodyModel& body, const std::array<double, 3>& rotation_rad, BodyState& state);

}  // namespace unbruised
