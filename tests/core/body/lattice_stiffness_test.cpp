#include "core/body/lattice_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/contact/tributary_face.hpp"
#include "tests/core/algebra/dense.hpp"

namespace unbruised {
namespace {

using Extent = std::array<double, 3>;
using Count = std::array<int, 3>;
using Matrix24 = Eigen::Matrix<double, 24, 24, Eigen::RowMajor>;
using Matrix6x24 = Eigen::Matrix<double, 6, 24, Eigen::RowMajor>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kModulus = 1e6;
constexpr Extent kCube{0.005, 0.005, 0.005};
constexpr Extent kBrick{0.006, 0.005, 0.0055};
constexpr Extent kFlatBrick{0.006, 0.006, 0.005};

struct Material {
  double poisson_ratio;
  Extent cell_extent_m;
};

LatticeParameters block_parameters(const Count& count, const Extent& extent) {
  LatticeParameters parameters;
  parameters.mass_kg = 0.1;
  // The largest of the extents, a little less, divides each side into the wanted number of cells.
  parameters.cell_size_m = 0.92 * std::max({extent[0], extent[1], extent[2]});
  for (std::size_t d = 0; d < 3; ++d) parameters.size_m[d] = count[d] * extent[d];
  return parameters;
}

Lattice block_of(const Count& count, const Extent& extent) {
  const Lattice lattice = build_lattice(block_parameters(count, extent));
  EXPECT_EQ(lattice.cell_count, count);
  return lattice;
}

/// Displacement gradient of strain (Voigt, engineering shears) and rotation vector.
Eigen::Matrix3d gradient_of(const Vector6& e, const Eigen::Vector3d& rotation = Eigen::Vector3d::Zero()) {
  Eigen::Matrix3d gradient;
  gradient << e[0], e[5] / 2, e[4] / 2, e[5] / 2, e[1], e[3] / 2, e[4] / 2, e[3] / 2, e[2];
  Eigen::Matrix3d spin;
  spin << 0, -rotation[2], rotation[1], rotation[2], 0, -rotation[0], -rotation[1], rotation[0], 0;
  return gradient + spin;
}

Eigen::VectorXd field_of(const std::vector<std::array<double, 3>>& position, const Eigen::Matrix3d& gradient) {
  Eigen::VectorXd u(3 * static_cast<Eigen::Index>(position.size()));
  for (std::size_t i = 0; i < position.size(); ++i) {
    u.segment<3>(3 * static_cast<Eigen::Index>(i)) = gradient * Eigen::Vector3d(position[i].data());
  }
  return u;
}

Eigen::VectorXd gather(const Eigen::VectorXd& u, const std::array<int, 8>& cell) {
  Eigen::VectorXd local(24);
  for (int c = 0; c < 8; ++c) local.segment<3>(3 * c) = u.segment<3>(3 * cell[c]);
  return local;
}

Vector6 some_strain(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-0.01, 0.01);
  return Vector6::NullaryExpr([&] { return uniform(random); });
}

bool is_interior(const Lattice& lattice, std::size_t node) {
  int cells = 0;
  for (const auto& cell : lattice.cell) {
    for (const int corner : cell) cells += static_cast<std::size_t>(corner) == node;
  }
  return cells == 8;
}

class LatticeStiffness : public ::testing::TestWithParam<Material> {
 protected:
  CellStiffness cell() const {
    return cell_stiffness(kModulus, GetParam().poisson_ratio, GetParam().cell_extent_m);
  }
};

TEST_P(LatticeStiffness, BalancesAHomogeneousStrainAtEveryCorner) {
  const CellStiffness c = cell();
  const Eigen::Map<const Matrix24> K(c.K.data());
  const Eigen::Map<const Matrix6x24> B(c.B.data());
  const Eigen::Map<const Matrix6> D(c.D.data());
  const Lattice lattice = block_of({2, 2, 2}, GetParam().cell_extent_m);
  std::mt19937 random(11);
  for (int k = 0; k < 20; ++k) {
    const Vector6 e = some_strain(random);
    const Eigen::VectorXd u = gather(field_of(lattice.position_m, gradient_of(e)), lattice.cell[0]);
    const Eigen::VectorXd expected = c.volume_m3 * B.transpose() * (D * e);
    // Mean strain of the field, and forces, up to the rounding of a few dozen terms of K u; near nu = 1/2 the
    // terms lambda dV/V are up to 1e2 times their sum.
    EXPECT_LT((B * u - e).norm(), 1e-14);
    EXPECT_LT((K * u - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST_P(LatticeStiffness, PassesThePatchTest) {
  const Extent& h = GetParam().cell_extent_m;
  const Lattice lattice = block_of({3, 3, 4}, h);
  const CellStiffness c = cell();
  const Eigen::MatrixXd K = testing::dense(assemble_stiffness(lattice, c));
  std::mt19937 random(5);
  const Vector6 e = some_strain(random);
  const Eigen::VectorXd exact = field_of(lattice.position_m, gradient_of(e, {0.003, -0.002, 0.004}));

  std::vector<int> inner;
  Eigen::VectorXd u = exact;
  for (std::size_t i = 0; i < lattice.position_m.size(); ++i) {
    if (!is_interior(lattice, i)) continue;
    for (int axis = 0; axis < 3; ++axis) inner.push_back(3 * static_cast<int>(i) + axis);
  }
  ASSERT_EQ(inner.size(), 3u * 2u * 2u * 3u);
  u(inner).setZero();
  const Eigen::VectorXd load = -(K * u)(inner);
  const Eigen::VectorXd solved = K(inner, inner).ldlt().solve(load);
  u(inner) = solved;
  EXPECT_LT((u - exact).norm(), 1e-11 * exact.norm());

  const Eigen::Map<const Matrix6> D(c.D.data());
  const double volume = 36.0 * h[0] * h[1] * h[2];
  const double energy = 0.5 * volume * e.dot(D * e);
  EXPECT_NEAR(0.5 * u.dot(K * u), energy, 1e-10 * energy);
}

TEST_P(LatticeStiffness, GivesTheWantedModulusAndPoissonRatioInUniaxialTension) {
  const Lattice lattice = block_of({3, 2, 4}, GetParam().cell_extent_m);
  const TrueShape shape(block_parameters({3, 2, 4}, GetParam().cell_extent_m));
  const CellStiffness c = cell();
  const Eigen::MatrixXd K = testing::dense(assemble_stiffness(lattice, c));
  const Eigen::Map<const Matrix6x24> B(c.B.data());
  const double stress = 1e4;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(K.rows());
    const auto along = static_cast<std::size_t>(axis);
    const FacePlane plane(lattice, along, {static_cast<int>((along + 1) % 3), static_cast<int>((along + 2) % 3)});
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const std::vector<SurfacePoint>& side = lattice.side[2 * along + end];
      const TributaryFace face(shape, lattice, plane, side);
      for (const SurfacePoint& point : side) {
        const double area = face.area_m2(lattice.position_m[static_cast<std::size_t>(point.node)]);
        f[3 * point.node + axis] += (end == 0 ? -stress : stress) * area;
      }
    }
    // The load is in balance, so that any solution differs from the wanted one by a rigid motion only.
    const Eigen::VectorXd u = K.completeOrthogonalDecomposition().solve(f);
    ASSERT_LT((K * u - f).norm(), 1e-10 * f.norm());
    for (const auto& corners : lattice.cell) {
      const Vector6 e = B * gather(u, corners);
      EXPECT_NEAR(stress / e[axis], kModulus, 1e-10 * kModulus);
      EXPECT_NEAR(-e[(axis + 1) % 3] / e[axis], GetParam().poisson_ratio, 1e-10);
      EXPECT_NEAR(-e[(axis + 2) % 3] / e[axis], GetParam().poisson_ratio, 1e-10);
    }
  }
}

TEST_P(LatticeStiffness, HasExactlySixZeroModes) {
  for (const Count& count : {Count{2, 2, 2}, Count{3, 3, 4}}) {
    const Lattice lattice = block_of(count, GetParam().cell_extent_m);
    const Eigen::MatrixXd K = testing::dense(assemble_stiffness(lattice, cell()));
    const Eigen::VectorXd modes =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
    const double largest = modes[modes.size() - 1];
    // Rigid modes vanish up to rounding, the softest elastic mode of so small a block is 1e-4 of the stiffest or
    // more.
    EXPECT_LT(modes.head(6).cwiseAbs().maxCoeff(), 1e-13 * largest);
    EXPECT_GT(modes[6], 1e-4 * largest);
  }
}

TEST_P(LatticeStiffness, FeelsNoRigidMotion) {
  const Lattice lattice = block_of({3, 3, 4}, GetParam().cell_extent_m);
  const BlockMatrix K = assemble_stiffness(lattice, cell());
  Eigen::VectorXd u = field_of(lattice.position_m, gradient_of(Vector6::Zero(), {0.1, -0.2, 0.3}));
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] += 0.01 * static_cast<double>(i % 3 + 1);
  Eigen::VectorXd f(u.size());
  multiply(K, {u.data(), static_cast<std::size_t>(u.size())}, {f.data(), static_cast<std::size_t>(f.size())});
  const double scale = testing::dense(K).cwiseAbs().maxCoeff() * u.cwiseAbs().maxCoeff();
  EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-14 * scale);  // 81 products per row
}

TEST_P(LatticeStiffness, IsSymmetricToTheBit) {
  const CellStiffness c = cell();
  EXPECT_TRUE(testing::is_symmetric_to_the_bit(Eigen::Map<const Matrix24>(c.K.data())));
  const Lattice lattice = block_of({3, 2, 4}, GetParam().cell_extent_m);
  EXPECT_TRUE(testing::is_symmetric_to_the_bit(testing::dense(assemble_stiffness(lattice, c))));
}

std::vector<Material> materials() {
  std::vector<Material> all;
  for (const double nu : {0.0, 0.1, 0.25, 0.3, 0.4, 0.45, 0.49}) {
    for (const Extent& extent : {kCube, kBrick, kFlatBrick}) all.push_back({nu, extent});
  }
  return all;
}

std::string name_of(const ::testing::TestParamInfo<Material>& info) {
  const std::array<std::string, 3> names{"Cube", "Brick", "FlatBrick"};
  return names[info.index % 3] + "Nu" + std::to_string(std::lround(100 * info.param.poisson_ratio));
}

INSTANTIATE_TEST_SUITE_P(Materials, LatticeStiffness, ::testing::ValuesIn(materials()), name_of);

TEST(CellSprings, ReduceToTheKnownConstantsForACube) {
  // E = 1 MPa, a = 5 mm: nu = 0.25 gives k = 2000 N/m and kv = 0; nu = 0.3 gives k = 1923.08 N/m, kv = 0.19231
  // MPa; nu = 0.49 gives 1677.85 N/m, 16.107 MPa (docs/theory.md). Four cells share an edge, two a face diagonal.
  const CellSprings quarter = cell_springs(kModulus, 0.25, kCube);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(4.0 * quarter.edge_N_m[axis], 2000.0, 1e-9);
    EXPECT_NEAR(2.0 * quarter.face_diagonal_N_m[axis], 2000.0, 1e-9);
  }
  EXPECT_NEAR(quarter.volumetric_Pa, 0.0, 1e-9);
  const CellSprings stiff = cell_springs(kModulus, 0.3, kCube);
  EXPECT_NEAR(4.0 * stiff.edge_N_m[0], 1923.08, 0.005);
  EXPECT_NEAR(stiff.volumetric_Pa, 0.19231e6, 5.0);
  const CellSprings tough = cell_springs(kModulus, 0.49, kCube);
  EXPECT_NEAR(4.0 * tough.edge_N_m[0], 1677.85, 0.005);
  EXPECT_NEAR(tough.volumetric_Pa, 16.107e6, 500.0);
}

TEST(CellSprings, AreAdmissibleUpToAnAspectOfTheRootOfOneAndAHalf) {
  EXPECT_TRUE(lattice_is_admissible(kCube));
  EXPECT_TRUE(lattice_is_admissible({1.224, 1.0, 1.0}));
  EXPECT_FALSE(lattice_is_admissible({1.225, 1.0, 1.0}));
  EXPECT_TRUE(lattice_is_admissible({1.0, 1.4, 1.4}));  // a flat cell: 3 - 1 - 1.96 > 0
  EXPECT_FALSE(lattice_is_admissible({1.0, 1.42, 1.42}));
  EXPECT_FALSE(lattice_is_admissible({0.0, 1.0, 1.0}));
  EXPECT_FALSE(lattice_is_admissible({std::nan(""), 1.0, 1.0}));
}

TEST(CellSprings, RefuseWhatHasNoSuchLattice) {
  EXPECT_THROW(cell_springs(kModulus, 0.5, kCube), std::invalid_argument);
  EXPECT_THROW(cell_springs(kModulus, -0.1, kCube), std::invalid_argument);
  EXPECT_THROW(cell_springs(0.0, 0.3, kCube), std::invalid_argument);
  EXPECT_THROW(cell_stiffness(kModulus, 0.3, {1.3, 1.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace unbruised
