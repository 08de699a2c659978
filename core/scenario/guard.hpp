#pragma once

/// @file
/// A guarded approach before anything has moved: what the range sensors read, and what the guard costs.

#include <array>
#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// How far the rays of a gripper come before they meet the undeformed product, alike for both fingers.
struct RayAtStart {
  double distance_m = 0;        ///< where the fingers start
  double touch_distance_m = 0;  ///< when the pads touch
};

/// Where the rays of a gripper start, from the product's middle, on the side of the first finger.
std::array<double, 3> ray_start_m(const Scenario& scenario, const ParallelJawParameters& jaw);

/// None: there are no range sensors, or their rays or the pads pass the product.
std::optional<RayAtStart> ray_at_start(const Scenario& scenario);

/// An approach as a drive goes through it that brakes a finger with its force limit: without friction, waiting for
/// a sample, or noise.
struct PlannedApproach {
  double time_s = 0;           ///< from the start to the first contact
  double touch_speed_m_s = 0;  ///< of a finger then
};
PlannedApproach planned_approach(const Scenario& scenario);

}  // namespace unbruised
