#pragma once

/// @file
/// How near a product is to yielding below a pad (docs/theory.md, "First yield"), all lanes at once.

#include "core/contact/contact_model.hpp"
#include "core/contact/surface_tally.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

/// Mean pressure of a pad's patch / mean pressure at first yield; 0 where the pad carries nothing.
/// @param extent_m of a pad contact's tributary rectangle, along y and z
/// @param yield_stress of the product [Pa]
Lane yield_ratio(const SurfaceTally& tally, const PatchForm& form, const std::array<double, 2>& extent_m,
                 const SurfaceLane& pad, const Lane& yield_stress);

}  // namespace unbruised
