#include "core/scenario/cell_surface.hpp"

#include <cmath>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// Where the normal lies this near to x, x says nothing of a direction in the plane.
constexpr double kAlongX = 0.999;

using Vector = std::array<double, 3>;

Vector of_length_1(const Vector& v) { return {v[0] / length(v), v[1] / length(v), v[2] / length(v)}; }

}  // namespace

std::array<Vector, 3> surface_axes(const CellSurfaceParameters& surface) {
  const Vector n = of_length_1(surface.normal);
  const std::size_t nearest = std::abs(n[0]) > kAlongX ? 1 : 0;
  Vector first{};
  for (std::size_t i = 0; i < 3; ++i) first[i] = (i == nearest ? 1.0 : 0.0) - n[nearest] * n[i];
  first = of_length_1(first);
  return {first, cross(n, first), n};
}

}  // namespace unbruised
