#pragma once

/// @file
/// How far the pads stand from the product before the approach.

#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// The way of each pad where neither the gap nor the opening is given [m].
inline constexpr double kUsualApproachGap_m = 0.005;

/// How far a product with a shape reaches from the middle of the grip towards the line of a listed finger's pad,
/// and towards all pads; of a jaw half its width [m].
std::optional<double> reach_to_finger_m(const Scenario& scenario, const FingerParameters& finger);
std::optional<double> half_width_m(const Scenario& scenario);

/// From each pad face to the nearest point of the undeformed product at the start [m]; of listed fingers, which
/// start at one distance from the middle, from the one that comes nearest: cell.approach_gap_m;
/// without it what the opening leaves, (gripper.opening_m - product.size_m[0]) / 2, or what the product reaches
/// towards the fingers; without either kUsualApproachGap_m. Of shaped pads the way along which they close until
/// they meet the product. Not positive where the product is wider than the opening, which `validate` refuses.
double approach_gap_m(const Scenario& scenario);
/// What the opening leaves [m].
double gap_in_opening_m(double opening_m, double width_m, const Scenario& scenario);

/// From the middle of each pad's face to the middle between them at the start [m].
double opened_half_m(const Scenario& scenario);

}  // namespace unbruised
