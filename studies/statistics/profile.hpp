#pragma once

/// @file
/// Intervals of single parameters of a least-squares fit by their profile: how the least sum of squares over all
/// other parameters grows with one of them.

#include <cstddef>
#include <span>
#include <vector>

namespace unbruised::studies {

enum class Side { low, high };

/// What the linear model of residuals r(p + d) = r + J d says of the profile of one parameter.
struct ProfileStep {
  double squares = 0.0;      ///< least sum of squares with the parameter where it is
  std::vector<double> step;  ///< d: to where the least sum of squares is the wanted one, the others at their best
};

/// @param J [point][parameter], parameters on scales of 0 to 1 @param r as many as points
/// @param of the parameter @param squares wanted; where no place has so few, d leads to the one with the least
/// @param side on which the place is looked for. The parameter's own step is one, its whole scale, at most.
ProfileStep profile_step(const std::vector<std::vector<double>>& J, std::span<const double> r, std::size_t of,
                         double squares, Side side);

}  // namespace unbruised::studies
