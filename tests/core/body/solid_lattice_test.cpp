// Lattices of solids of revolution, superellipsoids and meshes: mass, surface, and the patch test inside them.

#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/body/lattice_stiffness.hpp"
#include "core/door/eigen.hpp"
#include "core/scenario/true_shape.hpp"
#include "tests/core/algebra/dense.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/scenario/solids.hpp"

namespace unbruised {
namespace {

using namespace testing;

std::vector<LatticeParameters> solids(double cell_m) {
  std::vector<LatticeParameters> all = {revolution_of(pear_profile(), {0.06, 0.06, 0.08}),
                                        revolution_of(pear_profile(), {0.06, 0.08, 0.06}, Axis::y),
                                        revolution_of(bottle_profile(), {0.04, 0.04, 0.088}),
                                        superellipsoid_of({3.0, 2.5}, {0.04, 0.06, 0.05}),
                                        mesh_product(icosphere(4), {0.05, 0.05, 0.05}),
                                        mesh_product(lobed_mesh(3), {0.09, 0.06, 0.06})};
  for (LatticeParameters& solid : all) solid.cell_size_m = cell_m;
  return all;
}

TEST(SolidLattice, HasExactlyTheWantedMass) {
  for (LatticeParameters solid : solids(0.005)) {
    const auto sum = [](const std::vector<double>& masses) {
      return std::accumulate(masses.begin(), masses.end(), 0.0L);
    };
    EXPECT_NEAR(static_cast<double>(sum(build_lattice(solid).mass_kg)), 0.1, 1e-15);
    solid.mass_kg.reset();
    solid.density_kg_m3 = 900.0;
    const double mass_kg = 900.0 * TrueShape(solid).volume_m3();
    EXPECT_NEAR(static_cast<double>(sum(build_lattice(solid).mass_kg)), mass_kg, 1e-14 * mass_kg);
  }
}

TEST(SolidLattice, ConvergesToTheTrueVolume) {
  for (const double cell_m : {0.006, 0.003}) {
    for (const LatticeParameters& solid : solids(cell_m)) {
      const Lattice lattice = build_lattice(solid);
      const auto& h = lattice.cell_extent_m;
      const double volume_m3 = static_cast<double>(lattice.cell.size()) * h[0] * h[1] * h[2];
      // Half a layer of cells at the surface, of which most cancels.
      EXPECT_NEAR(volume_m3 / lattice.true_volume_m3, 1.0, 8.0 * cell_m);
    }
  }
}

TEST(SolidLattice, IsFaceConnected) {
  for (const LatticeParameters& solid : solids(0.006)) {
    const Lattice lattice = build_lattice(solid);
    // Cells that share four corners.
    std::vector<int> parent(lattice.position_m.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
      while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
      return i;
    };
    for (const auto& cell : lattice.cell) {
      for (const int corner : cell) parent[static_cast<std::size_t>(root(corner))] = root(cell[0]);
    }
    std::set<int> parts;
    for (int i = 0; i < static_cast<int>(parent.size()); ++i) parts.insert(root(i));
    EXPECT_EQ(parts.size(), 1U);
  }
}

TEST(SolidLattice, SurfacePointsLieOnTheTrueSurface) {
  for (const LatticeParameters& solid : solids(0.006)) {
    const Lattice lattice = build_lattice(solid);
    const TrueShape shape(solid);
    for (std::size_t side = 0; side < 6; ++side) {
      EXPECT_FALSE(lattice.side[side].empty());
      for (const SurfacePoint& point : lattice.side[side]) {
        std::array<double, 3> place = lattice.position_m[static_cast<std::size_t>(point.node)];
        place[side / 2] = point.position_m;
        for (std::size_t d = 0; d < 3; ++d) place[d] -= lattice.center_m[d];
        EXPECT_NEAR(shape.nearest(place).distance_m, 0.0, 1e-9);
      }
    }
  }
}

// A homogeneous strain forced on the surface particles is that of all inner ones.
TEST(SolidLattice, PassesThePatchTest) {
  for (const LatticeParameters& solid : solids(0.01)) {
    const Lattice lattice = build_lattice(solid);
    const Eigen::MatrixXd K = dense(assemble_stiffness(lattice, cell_stiffness(1e6, 0.3, lattice.cell_extent_m)));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(-0.01, 0.01);
    const Eigen::Matrix3d gradient = Eigen::Matrix3d::NullaryExpr([&] { return part(random); });
    std::vector<int> cells(lattice.position_m.size(), 0);
    for (const auto& cell : lattice.cell) {
      for (const int corner : cell) ++cells[static_cast<std::size_t>(corner)];
    }
    Eigen::VectorXd exact(3 * static_cast<Eigen::Index>(cells.size()));
    std::vector<int> inner;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      exact.segment<3>(3 * static_cast<Eigen::Index>(i)) =
          gradient * Eigen::Vector3d(lattice.position_m[i].data());
      for (int axis = 0; axis < 3 && cells[i] == 8; ++axis) inner.push_back(3 * static_cast<int>(i) + axis);
    }
    ASSERT_FALSE(inner.empty());
    Eigen::VectorXd u = exact;
    u(inner).setZero();
    const Eigen::VectorXd load = -(K * u)(inner);
    const Eigen::VectorXd solved = K(inner, inner).ldlt().solve(load);
    u(inner) = solved;
    EXPECT_LT((u - exact).norm(), 1e-11 * exact.norm());
  }
}

}  // namespace
}  // namespace unbruised
