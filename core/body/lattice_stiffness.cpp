#include "core/body/lattice_stiffness.hpp"

#include <cmath>
#include <stdexcept>

namespace unbruised {
namespace {

using Vector3 = std::array<double, 3>;

int corner_sign(int corner, int axis) { return ((corner >> axis) & 1) ? 1 : -1; }

/// K += k d d^T / |d|^2 between two corners, d their distance.
void add_spring(CellStiffness& cell, int a, int b, double stiffness, const Vector3& d) {
  const double scale = stiffness / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      const double value = scale * (d[r] * d[s]);
      cell.K[24 * (3 * a + r) + 3 * a + s] += value;
      cell.K[24 * (3 * b + r) + 3 * b + s] += value;
      cell.K[24 * (3 * a + r) + 3 * b + s] -= value;
      cell.K[24 * (3 * b + r) + 3 * a + s] -= value;
    }
  }
}

void add_springs(CellStiffness& cell, const CellSprings& springs, const Vector3& h) {
  for (int a = 0; a < 8; ++a) {
    for (int b = a + 1; b < 8; ++b) {
      Vector3 d{};
      int axes = 0;
      int along = 0;
      int normal = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const int step = (corner_sign(b, axis) - corner_sign(a, axis)) / 2;
        d[axis] = step * h[axis];
        axes += step != 0;
        (step != 0 ? along : normal) = axis;
      }
      if (axes == 1) add_spring(cell, a, b, springs.edge_N_m[along], d);
      if (axes == 2) add_spring(cell, a, b, springs.face_diagonal_N_m[normal], d);
    }
  }
}

/// K += kv V b b^T with dV/V = b . u.
void add_volume_change(CellStiffness& cell, double volumetric_Pa) {
  std::array<double, 24> b{};
  for (int dof = 0; dof < 24; ++dof) b[dof] = cell.B[24 * (dof % 3) + dof];
  const double scale = volumetric_Pa * cell.volume_m3;
  for (int r = 0; r < 24; ++r) {
    for (int s = 0; s < 24; ++s) cell.K[24 * r + s] += scale * (b[r] * b[s]);
  }
}

/// Compilers may round a sum of products differently in two places; one triangle decides.
void mirror_upper_triangle(CellStiffness& cell) {
  for (int r = 0; r < 24; ++r) {
    for (int s = 0; s < r; ++s) cell.K[24 * r + s] = cell.K[24 * s + r];
  }
}

/// Gradients of the trilinear shape functions at the centre: sign / (4 h).
void set_mean_strain(CellStiffness& cell, const Vector3& h) {
  for (int c = 0; c < 8; ++c) {
    Vector3 gradient{};
    for (int axis = 0; axis < 3; ++axis) gradient[axis] = corner_sign(c, axis) / (4.0 * h[axis]);
    for (int axis = 0; axis < 3; ++axis) {
      const int q = (axis + 1) % 3;
      const int r = (axis + 2) % 3;
      cell.B[24 * axis + 3 * c + axis] = gradient[axis];
      // Row 3 + axis is the shear in the plane normal to the axis: yz, xz, xy.
      cell.B[24 * (3 + axis) + 3 * c + q] = gradient[r];
      cell.B[24 * (3 + axis) + 3 * c + r] = gradient[q];
    }
  }
}

void set_elasticity(CellStiffness& cell, double mu, double lambda) {
  for (int p = 0; p < 3; ++p) {
    for (int q = 0; q < 3; ++q) cell.D[6 * p + q] = lambda + (p == q ? 2.0 * mu : 0.0);
    cell.D[6 * (3 + p) + 3 + p] = mu;
  }
}

struct LameConstants {
  double mu;
  double lambda;
};

LameConstants lame_constants(double E, double nu) {
  return {E / (2.0 * (1.0 + nu)), E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))};
}

}  // namespace

CellSprings cell_springs(double youngs_modulus_Pa, double poisson_ratio,
                         const std::array<double, 3>& cell_extent_m) {
  if (!(youngs_modulus_Pa > 0.0) || !(poisson_ratio >= 0.0) || !(poisson_ratio < 0.5)) {
    throw std::invalid_argument("cell_springs: needs E > 0 and 0 <= nu < 0.5");
  }
  if (!lattice_is_admissible(cell_extent_m)) throw std::invalid_argument("cell_springs: cell too far from a cube");

  const Vector3& h = cell_extent_m;
  const double V = h[0] * h[1] * h[2];
  const auto [mu, lambda] = lame_constants(youngs_modulus_Pa, poisson_ratio);
  CellSprings springs;
  for (std::size_t p = 0; p < 3; ++p) {
    const double hq2 = h[(p + 1) % 3] * h[(p + 1) % 3];
    const double hr2 = h[(p + 2) % 3] * h[(p + 2) % 3];
    springs.edge_N_m[p] = mu * V * edge_spring_share(h, p) / (4.0 * h[p] * h[p]);
    springs.face_diagonal_N_m[p] = mu * V * (hq2 + hr2) / (4.0 * hq2 * hr2);
  }
  springs.volumetric_Pa = lambda - mu;
  return springs;
}

CellStiffness cell_stiffness(double youngs_modulus_Pa, double poisson_ratio,
                             const std::array<double, 3>& cell_extent_m) {
  const CellSprings springs = cell_springs(youngs_modulus_Pa, poisson_ratio, cell_extent_m);
  const auto [mu, lambda] = lame_constants(youngs_modulus_Pa, poisson_ratio);
  CellStiffness cell;
  cell.volume_m3 = cell_extent_m[0] * cell_extent_m[1] * cell_extent_m[2];
  set_mean_strain(cell, cell_extent_m);
  set_elasticity(cell, mu, lambda);
  add_springs(cell, springs, cell_extent_m);
  add_volume_change(cell, springs.volumetric_Pa);
  mirror_upper_triangle(cell);
  return cell;
}

namespace {

using Blocks = std::array<std::array<double, 9>, 64>;

Blocks blocks_of(const std::array<double, 24 * 24>& K) {
  Blocks block{};
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < 8; ++b) {
      for (int r = 0; r < 3; ++r) {
        for (int s = 0; s < 3; ++s) block[8 * a + b][3 * r + s] = K[24 * (3 * a + r) + 3 * b + s];
      }
    }
  }
  return block;
}

void add_blocks(const std::array<int, 8>& corners, const Blocks& block, BlockMatrixBuilder& builder) {
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < 8; ++b) builder.add(corners[a], corners[b], block[8 * a + b]);
  }
}

}  // namespace

BlockMatrix assemble_stiffness(const Lattice& lattice, std::span<const CellStiffness> cell,
                               std::span<const int> material, std::span<const CellAddition> more) {
  std::vector<Blocks> block;
  for (const CellStiffness& of_material : cell) block.push_back(blocks_of(of_material.K));
  BlockMatrixBuilder builder(static_cast<int>(lattice.position_m.size()));
  for (std::size_t c = 0; c < lattice.cell.size(); ++c) {
    add_blocks(lattice.cell[c], block[material.empty() ? 0 : static_cast<std::size_t>(material[c])], builder);
  }
  for (const CellAddition& each : more) add_blocks(lattice.cell[each.cell], blocks_of(each.K), builder);
  return builder.build();
}

}  // namespace unbruised
