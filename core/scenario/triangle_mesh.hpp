#pragma once

/// @file
/// A surface of triangles: what meshes are read into and made of.

#include <array>
#include <vector>

namespace unbruised {

/// In any unit.
struct TriangleMesh {
  std::vector<std::array<double, 3>> place;
  std::vector<std::array<int, 3>> triangle;  ///< counter-clockwise from outside

  [[nodiscard]] const std::array<double, 3>& corner(std::size_t t, std::size_t k) const {
    return place[static_cast<std::size_t>(triangle[t][k])];
  }
};

/// Least and largest coordinates.
struct Bounds {
  std::array<double, 3> low{}, high{};
};
Bounds bounds_of(const std::vector<std::array<double, 3>>& places);

}  // namespace unbruised
