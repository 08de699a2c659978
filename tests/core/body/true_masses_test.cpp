// Masses by which a lattice turns as its true shape does.

#include "core/body/true_masses.hpp"

#include <gtest/gtest.h>

#include "core/scenario/true_shape.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/scenario/solids.hpp"

namespace unbruised {
namespace {

struct Case {
  Shape shape;
  std::array<double, 3> mean_square_share;  ///< of the true shape, over the squares of its extents
};

TEST(TrueMasses, HaveTheMassAndTheMomentsOfTheShapeAndStayPositive) {
  const double flat = 1.0 / 12.0, disc = 1.0 / 16.0, ball = 1.0 / 20.0;
  for (const Case& each : {Case{Shape::box, {flat, flat, flat}}, Case{Shape::cylinder, {disc, disc, flat}},
                           Case{Shape::ellipsoid, {ball, ball, ball}}}) {
    for (const int cells : {2, 3, 5, 8}) {
      LatticeParameters product;
      product.shape = each.shape;
      product.size_m = {0.05, 0.06, 0.055};
      product.cell_size_m = 0.05 / cells;
      product.mass_kg = 0.1;
      const Lattice lattice = build_lattice(product);
      double mass_kg = 0.0;
      std::array<double, 3> square{};
      const std::vector<double> masses = true_masses(product, lattice);
      for (std::size_t p = 0; p < masses.size(); ++p) {
        EXPECT_GT(masses[p], 0.0);
        mass_kg += masses[p];
        for (std::size_t d = 0; d < 3; ++d) {
          const double q = (lattice.position_m[p][d] - lattice.center_m[d]) / product.size_m[d];
          square[d] += masses[p] * q * q;
        }
      }
      // Newton's method ends at rounding.
      EXPECT_NEAR(mass_kg, 0.1, 1e-14);
      for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(square[d] / 0.1, each.mean_square_share[d], 1e-13);
    }
  }
}

TEST(TrueMasses, OfASolidOfRevolutionHaveItsCentreToo) {
  for (const Axis axis : {Axis::y, Axis::z}) {
    std::array<double, 3> size_m = {0.06, 0.06, 0.06};
    size_m[static_cast<std::size_t>(axis)] = 0.08;
    LatticeParameters pear = testing::revolution_of(testing::pear_profile(), size_m, axis);
    pear.cell_size_m = 0.006;
    const TrueShape shape(pear);
    const Lattice lattice = build_lattice(pear);
    const std::vector<double> masses = true_masses(pear, lattice);
    double mass_kg = 0.0;
    std::array<double, 3> first{}, square{};
    for (std::size_t p = 0; p < masses.size(); ++p) {
      EXPECT_GT(masses[p], 0.0);
      mass_kg += masses[p];
      for (std::size_t d = 0; d < 3; ++d) {
        const double q = (lattice.position_m[p][d] - lattice.center_m[d]) / size_m[d];
        first[d] += masses[p] * q;
        square[d] += masses[p] * q * q;
      }
    }
    EXPECT_NEAR(mass_kg, 0.1, 1e-14);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_NEAR(first[d] / 0.1, shape.center_of_mass_m()[d] / size_m[d], 1e-13);
      EXPECT_NEAR(square[d] / 0.1, shape.mean_square_share(d), 1e-13);
    }
  }
}

TEST(TrueMasses, OfAMeshHaveItsCentreAndItsProductsToo) {
  LatticeParameters lobes = testing::mesh_product(testing::lobed_mesh(4), {0.08, 0.05, 0.05});
  lobes.cell_size_m = 0.006;
  const TrueShape shape(lobes);
  const Lattice lattice = build_lattice(lobes);
  const std::vector<double> masses = true_masses(lobes, lattice);
  double mass_kg = 0.0;
  std::array<double, 3> first{}, square{}, product{};
  for (std::size_t p = 0; p < masses.size(); ++p) {
    EXPECT_GT(masses[p], 0.0);
    mass_kg += masses[p];
    std::array<double, 3> q{};
    for (std::size_t d = 0; d < 3; ++d) q[d] = (lattice.position_m[p][d] - lattice.center_m[d]) / lobes.size_m[d];
    for (std::size_t d = 0; d < 3; ++d) {
      first[d] += masses[p] * q[d];
      square[d] += masses[p] * q[d] * q[d];
      product[d] += masses[p] * q[d] * q[(d + 1) % 3];
    }
  }
  EXPECT_NEAR(mass_kg, 0.1, 1e-14);
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_NEAR(first[d] / 0.1, shape.center_of_mass_m()[d] / lobes.size_m[d], 1e-13);
    EXPECT_NEAR(square[d] / 0.1, shape.mean_square_share(d), 1e-13);
    EXPECT_NEAR(product[d] / 0.1, shape.mean_product_share(d, (d + 1) % 3), 1e-13);
  }
}

// A lattice that has the moments already keeps its masses: so the change vanishes with the cells.
TEST(TrueMasses, ChangeLessOnFinerCells) {
  double before = 1.0;
  for (const int cells : {4, 8, 16}) {
    LatticeParameters product;
    product.size_m = {0.06, 0.06, 0.06};
    product.cell_size_m = 0.06 / cells;
    product.mass_kg = 0.1;
    const Lattice lattice = build_lattice(product);
    const std::vector<double> masses = true_masses(product, lattice);
    double largest = 0.0;
    for (std::size_t p = 0; p < masses.size(); ++p) {
      largest = std::max(largest, std::abs(masses[p] / lattice.mass_kg[p] - 1.0));
    }
    EXPECT_LT(largest, 0.5 * before);
    before = largest;
  }
}

}  // namespace
}  // namespace unbruised
