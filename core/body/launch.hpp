#pragma once

/// @file
/// How a solid begins that stands on nothing: turned, spinning, at a height.

#include "core/body/body_model.hpp"
#include "core/body/body_state.hpp"

namespace unbruised {

/// Turns a solid that starts in the air about its centre of mass, as deformed as its spin keeps it, and lifts its
/// lowest place to where it is said to be; velocities that the state has are added, and so is its displacement,
/// which is that of a product at rest that handling has deformed. Of any other product the state stays as it is.
void launch(const ProductParameters& product, const BodyModel& body, BodyState& state);

}  // namespace unbruised
