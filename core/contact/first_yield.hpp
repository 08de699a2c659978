#pragma once

/// @file
/// How near a product is to yielding below a surface (docs/theory.md, "First yield").

#include "core/contact/contact_model.hpp"
#include "core/contact/surface_tally.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

/// A face of the product under a surface.
struct PressedFace {
  const SurfaceTally& tally;
  const PatchForm& form;
  const std::array<double, 2>& extent_m;  ///< of a contact's cell, along the tangents
  const SurfaceLane& surface;
  bool ends_within = true;  ///< may the surface end within the face, as a pad does?
};

/// Largest von Mises stress below a surface's patch over the yield stress, in one lane: of its mean pressure,
/// times what the edges of a pad and the traction of its resultants add (pad_edge.hpp, patch_traction.hpp); 0
/// where it carries nothing.
/// @param layer_N_m3 stiffness of the surface's layer per area, under this force
double yield_ratio(const PressedFace& face, double layer_N_m3, double yield_stress_Pa, int lane);

}  // namespace unbruised
