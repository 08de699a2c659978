#pragma once

/// @file
/// Spring constants that give a lattice of brick cells exactly a wanted isotropic E and nu, and their
/// assembly. With mu = E / (2 (1 + nu)), lambda = E nu / ((1 + nu)(1 - 2 nu)), cell extents h and volume V:
///   face diagonals in the plane (p, q), length l:  k = mu V l^2 / (4 h_p^2 h_q^2)    (gives C_ppqq = C_pqpq = mu)
///   edges along p:                                 k = mu V g_p / (4 h_p^2),  g_p = 3 - (h_p/h_q)^2 - (h_p/h_r)^2
///   volume change:                                 (1/2) kv V (dV/V)^2,      kv = lambda - mu
/// each the share of one cell. A cube of side a has 4 edge shares = 2 diagonal shares = E a / (2 (1 + nu)).

#include <array>
#include <cstddef>
#include <span>

#include "core/algebra/block_matrix.hpp"
#include "core/body/lattice.hpp"

namespace unbruised {

/// What one cell contributes to the springs along its edges and face diagonals, and its volumetric modulus.
struct CellSprings {
  /// By the axis of the edge.
  std::array<double, 3> edge_N_m{0.0, 0.0, 0.0};
  /// By the axis normal to the face.
  std::array<double, 3> face_diagonal_N_m{0.0, 0.0, 0.0};
  /// Negative for nu < 1/4; the cell's stiffness is positive semidefinite nevertheless.
  double volumetric_Pa = 0.0;
};

/// Matrices of one cell. Freedoms: 3 corner + axis, corners as in Lattice::cell. Strains in Voigt order
/// xx, yy, zz, yz, xz, xy with engineering shears. All row-major.
/// For every homogeneous strain e: K u(e) = V B^T D e, so a plastic strain enters as the load V B^T D e_p.
struct CellStiffness {
  /// Stiffness [N/m], 24 x 24, symmetric to the bit.
  std::array<double, 24 * 24> K{};
  /// Mean strain of the cell from its corners' displacements [1/m], 6 x 24.
  std::array<double, 6 * 24> B{};
  /// Isotropic elasticity [Pa], 6 x 6.
  std::array<double, 36> D{};
  double volume_m3 = 0.0;
};

/// The springs of one cell.
/// @throws std::invalid_argument unless E > 0, 0 <= nu < 1/2 and the cell is admissible.
CellSprings cell_springs(double youngs_modulus_Pa, double poisson_ratio,
                         const std::array<double, 3>& cell_extent_m);

/// The matrices of one cell.
/// @throws std::invalid_argument unless E > 0, 0 <= nu < 1/2 and the cell is admissible.
CellStiffness cell_stiffness(double youngs_modulus_Pa, double poisson_ratio,
                             const std::array<double, 3>& cell_extent_m);

/// What one cell has beside that of its material.
struct CellAddition {
  std::size_t cell = 0;
  std::array<double, 24 * 24> K{};  ///< as that of CellStiffness
};

/// K of the whole lattice, the sum of its cells' in their order and of what some have beside it; symmetric to the
/// bit.
/// @param cell of each material
/// @param material of each cell; empty: all are of the first
BlockMatrix assemble_stiffness(const Lattice& lattice, std::span<const CellStiffness> cell,
                               std::span<const int> material, std::span<const CellAddition> more);
/// Of one material.
inline BlockMatrix assemble_stiffness(const Lattice& lattice, const CellStiffness& cell) {
  return assemble_stiffness(lattice, std::span(&cell, 1), {}, {});
}

}  // namespace unbruised
