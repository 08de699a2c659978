#pragma once

/// @file
/// How near a product is to yielding below a surface (docs/theory.md, "First yield"), all lanes at once.

#include "core/contact/contact_model.hpp"
#include "core/contact/surface_tally.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

/// Mean pressure of a surface's patch / mean pressure at first yield, times what the traction of its resultants
/// adds to the stress below (patch_traction.hpp); 0 where it carries nothing.
/// @param extent_m of a contact's cell, along the tangents
/// @param yield_stress of the product [Pa]
Lane yield_ratio(const SurfaceTally& tally, const PatchForm& form, const std::array<double, 2>& extent_m,
                 const SurfaceLane& surface, const Lane& yield_stress);

}  // namespace unbruised
