#pragma once

/// @file
/// The true surface of a lattice product as triangles, to be looked at and to carry a skin.

#include <array>
#include <optional>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

struct ShapeMesh {
  std::vector<std::array<double, 3>> place_m;  ///< from the middle of the shape
  std::vector<std::array<int, 3>> triangle;    ///< counter-clockwise from outside
};

/// About 1,200 places on the surface, whatever the cells. An edge has places of both sides, so that it stays
/// sharp; a round surface is closed. None: the product has no surface.
std::optional<ShapeMesh> shape_mesh(const ProductParameters& product);

}  // namespace unbruised
