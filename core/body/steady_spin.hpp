#pragma once

/// @file
/// How a body is deformed that has been spinning for long.

#include <array>

#include "core/body/body_model.hpp"
#include "core/body/body_state.hpp"

namespace unbruised {

/// Adds to a state the spin of a body that nothing holds: velocities, accelerations, and the shape in which the
/// internal forces balance M (alpha x y + omega x (omega x y)); about a principal axis the body keeps it. The
/// centre of mass stays where it is, and sum m X x u = 0.
/// @param spin_rad_s omega, along x, y, z; nothing is done where it is zero
void add_steady_spin(const BodyModel& body, const std::array<double, 3>& spin_rad_s, BodyState& state);

}  // namespace unbruised
