#pragma once

/// @file
/// Where the pads first meet a product, before anything is deformed.

#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Surface particles no deeper than this share of the body's extent behind the pole can touch a pad or the
/// support: far more than a body of validity-limited strain can be flattened, and where a sphere leans by 45
/// degrees already.
inline constexpr double kDeepestMeeting = 0.15;

struct PadMeeting {
  double depth_share = 0;  ///< behind the product's outermost place, over its width along the grip axis
  double lean_rad = 0;     ///< of the product's surface there against the pad's face
  double reach_m = 0;      ///< of a shaped pad's plane from the product's outermost place
};

/// The highest place of the true shape before the pads, both the same by symmetry; none: there is no parallel jaw
/// or lattice product, or the pads pass it. Listed fingers meet a product with any place of its surface.
std::optional<PadMeeting> pad_meeting(const Scenario& scenario);

/// How far the plane of a shaped pad stands before the product's outermost place where its face meets the product
/// [m]; 0 of flat pads.
double pad_reach_m(const Scenario& scenario);

}  // namespace unbruised
