#pragma once

/// @file
/// The materials of a lattice product: layers by depth below its true surface or by place, cell by cell, and a
/// skin as a membrane on that surface (docs/theory.md, "Layers and skin").

#include <array>
#include <cstddef>
#include <vector>

#include "core/body/lattice.hpp"
#include "core/body/lattice_stiffness.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Which material each cell is of: 0 that of the product's own keys, i + 1 that of its layer i. Empty: all are of
/// the first.
std::vector<int> cell_materials(const LatticeParameters& product, const Lattice& lattice);

/// Cells of each material; one number where there are no layers.
std::vector<std::size_t> cells_of_materials(const LatticeParameters& product);

/// The matrices of a cell of each material.
std::vector<CellStiffness> material_cells(const LatticeParameters& product,
                                          const std::array<double, 3>& cell_extent_m);

/// What the skin adds to the cells below the true surface, in their order. A piece of surface is stretched as the
/// cell below it is where it lies; membranes have plane stress along the surface and no bending. Empty: there is
/// no skin.
std::vector<CellAddition> cell_skins(const LatticeParameters& product, const Lattice& lattice);

}  // namespace unbruised
