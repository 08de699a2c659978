#include "core/scenario/finger_axes.hpp"

#include <cmath>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// Where a finger closes this near to z, z says nothing of a direction in its pad.
constexpr double kAlongZ = 0.999;

using Vector = std::array<double, 3>;

Vector of_length_1(const Vector& v) { return {v[0] / length(v), v[1] / length(v), v[2] / length(v)}; }

Vector closing_direction(const FingerParameters& finger) {
  if (finger.direction) return of_length_1(*finger.direction);
  const double angle_rad = finger.angle_rad.value_or(0.0);
  return {-std::cos(angle_rad), -std::sin(angle_rad), 0.0};
}

}  // namespace

std::array<Vector, 3> finger_axes(const FingerParameters& finger) {
  const Vector d = closing_direction(finger);
  const std::size_t nearest = std::abs(d[2]) > kAlongZ ? 1 : 2;
  Vector up{};
  for (std::size_t i = 0; i < 3; ++i) up[i] = (i == nearest ? 1.0 : 0.0) - d[nearest] * d[i];
  up = of_length_1(up);
  return {cross(up, d), up, d};
}

std::size_t faced_axis(const Vector& direction) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) axis = std::abs(direction[i]) > std::abs(direction[axis]) ? i : axis;
  return axis;
}

std::array<std::size_t, 2> face_tangents(std::size_t axis) {
  return {axis == 0 ? std::size_t{1} : 0, axis == 2 ? std::size_t{1} : 2};
}

}  // namespace unbruised
