#pragma once

/// @file
/// Geometry of a lattice product: brick cells inside a shape, their corner particles with masses, and the
/// particles that stand for its true surface (docs/theory.md, "Lattice").

#include <array>
#include <vector>

#include "core/scenario/lattice_cells.hpp"

namespace unbruised {

/// A particle that carries the true surface of its column towards one side of the body.
struct SurfacePoint {
  /// Outermost particle of its column along the side's outward normal.
  int node = 0;
  /// Plain coordinate, along the side's axis, of the true surface at the particle's place in the two
  /// other axes: x for the sides -x and +x (so usually negative on -x), and so on.
  double position_m = 0.0;
};

/// The undeformed lattice. It stands centred on x = y = 0, the lowest point of its true shape on z = 0.
/// Positions are mirror-symmetric about x = 0 and y = 0 to the last bit.
struct Lattice {
  /// Cells that divide the bounding box.
  std::array<int, 3> cell_count{0, 0, 0};
  std::array<double, 3> cell_extent_m{0.0, 0.0, 0.0};
  /// Particles in ascending z, then y, then x; only those that belong to a cell.
  std::vector<std::array<double, 3>> position_m;
  /// Each cell gives an eighth of its share to each corner; the sum is the product's mass.
  std::vector<double> mass_kg;
  /// Cells in ascending z, then y, then x; corner c = i + 2 j + 4 k lies at offset (i, j, k) in {0, 1}^3.
  std::vector<std::array<int, 8>> cell;
  /// Sides -x, +x, -y, +y, -z, +z; in each the particles ascend.
  std::array<std::vector<SurfacePoint>, 6> side;
  /// Of the true shape, not of the cells.
  double true_volume_m3 = 0.0;
  /// Centre of the true shape.
  std::array<double, 3> center_m{0.0, 0.0, 0.0};
};

/// The lattice of the cells whose centres lie in the true shape (a box takes all).
/// @throws std::invalid_argument for extents, cell size or mass that are not positive and finite, and for
/// more cells than 32-bit particle numbers can serve.
Lattice build_lattice(const LatticeParameters& parameters);

}  // namespace unbruised
