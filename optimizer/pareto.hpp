#pragma once

/// @file
/// Pareto fronts of two or three objectives, all minimised.

#include <cstddef>
#include <span>
#include <vector>

namespace unbruised::optimizer {

using Objectives = std::vector<double>;

/// Is a at least as good as b in all, and better in one?
bool dominates(const Objectives& a, const Objectives& b);

/// Indices of the points that no other dominates, ascending; of equal points the first.
std::vector<std::size_t> nondominated(const std::vector<Objectives>& points);

/// Area or volume that the points dominate below the reference; points beyond it count for nothing. Exact, by slices
/// along the last objective. @param points of two or three objectives
double hypervolume(const std::vector<Objectives>& points, const Objectives& reference);

/// The point with the largest distance from the line or plane through the ends of the front, in objectives scaled to
/// [0, 1], on the side of the ideal point. @param front nondominated, not empty. @return index into front
std::size_t knee(const std::vector<Objectives>& front);

}  // namespace unbruised::optimizer
