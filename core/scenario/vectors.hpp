#pragma once

/// @file
/// Plain vectors along x, y, z; those of all lanes at once are in lanes/lane_vector.hpp.

#include <array>
#include <cmath>

namespace unbruised {

inline double length(const std::array<double, 3>& x) { return std::hypot(x[0], x[1], x[2]); }

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline std::array<double, 3> times(double factor, const std::array<double, 3>& x) {
  return {factor * x[0], factor * x[1], factor * x[2]};
}

/// The way from one place to another.
inline std::array<double, 3> between(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

inline std::array<double, 3> sum(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

}  // namespace unbruised
