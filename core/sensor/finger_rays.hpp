#pragma once

/// @file
/// The rays of a gripper's range sensors: where they start and whereto they go, as palm and fingers move.

#include <array>

#include "core/gripper/gripper_lanes.hpp"
#include "core/sensor/carried_surface.hpp"
#include "core/surface/carrier_motion.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// Of one lane, at the end of a step.
/// @param middle_m of the product's shape at rest
std::array<Ray, kJawFingers> finger_rays(const Scenario& scenario, const std::array<double, 3>& middle_m,
                                         const CarrierMotion& carriers, const GripperLanes& gripper, int lane);

}  // namespace unbruised
