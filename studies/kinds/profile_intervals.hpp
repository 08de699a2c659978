#pragma once

/// @file
/// Intervals of the fitted keys of one curve: the places where the profile has grown by what the scatter allows.
/// Found by Gauss and Newton's steps from both sides of the fit, all ends of all keys together.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "studies/findings/specimen_fit.hpp"

namespace unbruised::studies {

/// Points on the fit's scale, where each key's range is 0 to 1.
using UnitPoints = std::vector<std::vector<double>>;
/// The residuals at points, in their order; those of a scenario without a curve are empty. Nothing: stopped.
using AskResiduals = std::function<std::optional<std::vector<std::vector<double>>>(const UnitPoints& points)>;

/// Central differences of a curve: h^2 |f'''| / 6 is 1e-6 of it, and its noise 1e-9 / h.
inline constexpr double kCurveDifference = 1e-3;

/// The best point of a fit, with residuals and their derivatives there.
struct BestPoint {
  std::vector<double> unit;
  std::vector<double> residuals;
  std::vector<std::vector<double>> derivatives;  ///< [point][key]
};

/// Rounds of steps, at most; a profile like a parabola needs one.
inline constexpr std::size_t kProfileRoundsMost = 6;
/// Scenarios that the ends of all keys ask for, at most.
std::size_t profile_scenarios_at_most(std::size_t keys);

/// Of each key the places on either side of the best point where the least sum of squares over the other keys is
/// `allowed`, more than at the best point. An interval goes no further than the range.
/// @return nothing when stopped
std::optional<std::vector<KeyInterval>> profile_intervals(const BestPoint& best, double allowed,
                                                          const AskResiduals& ask);

}  // namespace unbruised::studies
