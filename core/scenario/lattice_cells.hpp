#pragma once

/// @file
/// What follows from the parameters of a lattice product alone: its cells, its volume, its mass.

#include <array>
#include <cstddef>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Cells per axis: max(2, round(size / cell_size)).
/// @throws std::invalid_argument when a count is no number or does not fit an int.
std::array<int, 3> lattice_cell_count(const LatticeParameters& parameters);

/// Extents of a cell: size / count, so that the bounding box is divided exactly.
std::array<double, 3> lattice_cell_extent_m(const LatticeParameters& parameters);

/// Volume of the true shape: box a b c, ellipsoid (pi / 6) a b c, cylinder (pi / 4) a b c for full extents.
double true_volume_m3(const LatticeParameters& parameters);

/// The product's mass: as given, or density times true volume.
/// @throws std::invalid_argument unless exactly one of mass and density is given.
double lattice_mass_kg(const LatticeParameters& parameters);

/// g_p = 3 - (h_p/h_q)^2 - (h_p/h_r)^2: what the face diagonals of a cell leave of C_pppp to its edges along
/// `axis`, over the shear modulus.
double edge_spring_share(const std::array<double, 3>& cell_extent_m, std::size_t axis);

/// Do all edge springs of such a cell come out positive, g_p > 0 for each axis?
/// True whenever the longest extent is below sqrt(3/2) = 1.2247 times the shortest.
bool lattice_is_admissible(const std::array<double, 3>& cell_extent_m);

}  // namespace unbruised
