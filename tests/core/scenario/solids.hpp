#pragma once

/// @file
/// Solids of revolution and superellipsoids for tests.

#include <cmath>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised::testing {

inline LatticeParameters revolution_of(const std::vector<std::array<double, 2>>& points,
                                       const std::array<double, 3>& size_m, Axis axis = Axis::z) {
  LatticeParameters product;
  product.shape = Shape::revolution;
  product.size_m = size_m;
  product.axis = axis;
  product.mass_kg = 0.1;
  for (const auto& [height, radius] : points) {
    product.profile_height.push_back(height);
    product.profile_radius.push_back(radius);
  }
  return product;
}

/// Points of a sphere of radius 1, unevenly placed.
inline std::vector<std::array<double, 2>> sphere_profile() {
  std::vector<std::array<double, 2>> points;
  for (const double height : {-1.0, -0.9, -0.3, 0.05, 0.6, 1.0}) {
    points.push_back({height, std::sqrt(1.0 - height * height)});
  }
  return points;
}

/// A pear that stands on a flat calyx, 1 unit high.
inline std::vector<std::array<double, 2>> pear_profile() {
  return {{0.0, 0.0},  {0.0, 0.12},  {0.05, 0.24}, {0.15, 0.34}, {0.3, 0.38}, {0.45, 0.35},
          {0.6, 0.26}, {0.75, 0.19}, {0.88, 0.16}, {0.96, 0.11}, {1.0, 0.0}};
}

/// A bottle: straight wall, neck, flat at both ends.
inline std::vector<std::array<double, 2>> bottle_profile() {
  return {{0.0, 0.0},  {0.0, 0.9}, {0.15, 1.0}, {0.6, 1.0},  {1.2, 1.0},  {1.8, 1.0},  {2.4, 1.0},
          {2.7, 0.95}, {3.0, 0.8}, {3.3, 0.6},  {3.6, 0.48}, {4.0, 0.45}, {4.4, 0.45}, {4.4, 0.0}};
}

inline LatticeParameters superellipsoid_of(const std::array<double, 2>& exponents,
                                           const std::array<double, 3>& size_m) {
  LatticeParameters product;
  product.shape = Shape::superellipsoid;
  product.size_m = size_m;
  product.exponents = exponents;
  product.mass_kg = 0.1;
  return product;
}

}  // namespace unbruised::testing
