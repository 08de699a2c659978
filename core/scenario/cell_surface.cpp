#include "core/scenario/cell_surface.hpp"

#include <cmath>

namespace unbruised {
namespace {

/// Where the normal lies this near to x, x says nothing of a direction in the plane.
constexpr double kAlongX = 0.999;

using Vector = std::array<double, 3>;

Vector of_length_1(const Vector& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

}  // namespace

std::array<Vector, 3> surface_axes(const CellSurfaceParameters& surface) {
  const Vector n = of_length_1(surface.normal);
  const std::size_t nearest = std::abs(n[0]) > kAlongX ? 1 : 0;
  Vector first{};
  for (std::size_t i = 0; i < 3; ++i) first[i] = (i == nearest ? 1.0 : 0.0) - n[nearest] * n[i];
  first = of_length_1(first);
  const Vector second = {n[1] * first[2] - n[2] * first[1], n[2] * first[0] - n[0] * first[2],
                         n[0] * first[1] - n[1] * first[0]};
  return {first, second, n};
}

}  // namespace unbruised
