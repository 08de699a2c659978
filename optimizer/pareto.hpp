#pragma once

/// @file
/// Pareto fronts of two or three objectives, all minimised.

#include <cstddef>
#include <span>
#include <vector>

namespace unbruised::optimizer {

using Objectives = std::vector<double>;

/// Is a at least as good as b in all, and better in one? Neither may hold NaN.
bool dominates(const Objectives& a, const Objectives& b);

/// Indices of the points that no other dominates, ascending; of equal points the first. A point with a NaN is
/// none.
std::vector<std::size_t> nondominated(const std::vector<Objectives>& points);

/// Area or volume between the points and the reference: of what at least one point dominates. Points that are not
/// below the reference in every objective count for nothing. Exact up to rounding: by slices along the last
/// objective.
/// @param points of two or three objectives, as many as the reference has
double hypervolume(const std::vector<Objectives>& points, const Objectives& reference);

/// The point farthest from the line or plane through the ends of the front, on the side of the ideal point, in
/// objectives scaled to [0, 1] over the front (Das 1999). The end of objective k is the point that is best in it.
/// Where three ends span no plane that faces the ideal point, it is the plane through (1, 0, 0), (0, 1, 0) and (0,
/// 0, 1). Of several the first. @param front nondominated, not empty, of two or three objectives. @return index
/// into front
std::size_t knee(const std::vector<Objectives>& front);

}  // namespace unbruised::optimizer
