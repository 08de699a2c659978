#include "core/body/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

LatticeParameters parameters_of(Shape shape, std::array<double, 3> size, double cell, Axis axis = Axis::z) {
  LatticeParameters parameters;
  parameters.shape = shape;
  parameters.size_m = size;
  parameters.axis = axis;
  parameters.cell_size_m = cell;
  parameters.mass_kg = 0.1234;
  return parameters;
}

std::vector<LatticeParameters> assorted() {
  return {parameters_of(Shape::box, {0.04, 0.05, 0.07}, 0.0052),
          parameters_of(Shape::sphere, {0.05, 0.05, 0.05}, 0.005),
          parameters_of(Shape::sphere, {0.05, 0.05, 0.05}, 0.025),
          parameters_of(Shape::ellipsoid, {0.045, 0.05, 0.062}, 0.0047),
          parameters_of(Shape::cylinder, {0.03, 0.05, 0.06}, 0.0043, Axis::x),
          parameters_of(Shape::cylinder, {0.05, 0.04, 0.06}, 0.0051, Axis::y),
          parameters_of(Shape::cylinder, {0.037, 0.05, 0.06}, 0.003, Axis::z)};
}

long double exact_sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0L);
}

bool is_round(const LatticeParameters& parameters, std::size_t axis) {
  if (parameters.shape == Shape::box) return false;
  return parameters.shape != Shape::cylinder || static_cast<std::size_t>(parameters.axis) != axis;
}

/// Coordinate of the bounding box, [-1, 1].
double unit(const LatticeParameters& parameters, const Lattice& lattice, std::size_t axis, double x) {
  return (x - lattice.center_m[axis]) / (0.5 * parameters.size_m[axis]);
}

TEST(Lattice, DividesTheBoundingBoxExactly) {
  const Lattice lattice = build_lattice(parameters_of(Shape::box, {0.05, 0.032, 0.06}, 0.005));
  EXPECT_EQ(lattice.cell_count, (std::array<int, 3>{10, 6, 12}));
  EXPECT_EQ(lattice.cell.size(), 10u * 6u * 12u);
  EXPECT_EQ(lattice.position_m.size(), 11u * 7u * 13u);
  EXPECT_DOUBLE_EQ(lattice.cell_extent_m[1], 0.032 / 6.0);
  EXPECT_EQ(lattice.position_m.front(), (std::array<double, 3>{-0.025, -0.016, 0.0}));
  EXPECT_EQ(lattice.position_m.back(), (std::array<double, 3>{0.025, 0.016, 0.06}));
}

TEST(Lattice, HasAtLeastTwoCellsAlongEachAxis) {
  const Lattice lattice = build_lattice(parameters_of(Shape::box, {0.01, 0.01, 0.05}, 0.01));
  EXPECT_EQ(lattice.cell_count, (std::array<int, 3>{2, 2, 5}));
}

TEST(Lattice, HasExactlyTheWantedMass) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    // each mass is rounded a few times: 3 units in the last place of the total at most
    EXPECT_NEAR(static_cast<double>(exact_sum(lattice.mass_kg) - 0.1234L), 0.0, 3 * 0.1234 * 1.2e-16);
    EXPECT_GT(*std::min_element(lattice.mass_kg.begin(), lattice.mass_kg.end()), 0.0);
  }
}

TEST(Lattice, TakesItsMassFromDensityAndTrueVolume) {
  LatticeParameters parameters = parameters_of(Shape::sphere, {0.06, 0.06, 0.06}, 0.01);
  parameters.mass_kg.reset();
  parameters.density_kg_m3 = 1022.0;
  const double expected = 1022.0 * 4.0 / 3.0 * std::numbers::pi * 0.03 * 0.03 * 0.03;
  EXPECT_NEAR(static_cast<double>(exact_sum(build_lattice(parameters).mass_kg)), expected, 1e-15 * expected);
  parameters.mass_kg = 0.1;
  EXPECT_THROW(build_lattice(parameters), std::invalid_argument);
}

TEST(Lattice, KnowsTheTrueVolumeOfEachShape) {
  const std::array<double, 3> size{0.03, 0.04, 0.05};
  EXPECT_DOUBLE_EQ(true_volume_m3(parameters_of(Shape::box, size, 0.01)), 6e-5);
  EXPECT_DOUBLE_EQ(true_volume_m3(parameters_of(Shape::ellipsoid, size, 0.01)), std::numbers::pi * 1e-5);
  EXPECT_DOUBLE_EQ(true_volume_m3(parameters_of(Shape::cylinder, size, 0.01)), std::numbers::pi * 1.5e-5);
}

TEST(Lattice, VolumeConvergesToTheTrueVolume) {
  for (const Shape shape : {Shape::sphere, Shape::cylinder}) {
    for (const int cells : {8, 16, 32, 64}) {
      const LatticeParameters parameters = parameters_of(shape, {0.05, 0.05, 0.05}, 0.05 / cells);
      const Lattice lattice = build_lattice(parameters);
      const auto& h = lattice.cell_extent_m;
      const double volume = static_cast<double>(lattice.cell.size()) * h[0] * h[1] * h[2];
      // The count of grid points in a circle of radius r errs by O(r^{2/3}) (Sierpinski), relative r^{-4/3}, and
      // less in a ball; with the factor 1 that makes 16, 6.3, 2.5 and 1 %.
      EXPECT_NEAR(volume / lattice.true_volume_m3, 1.0, std::pow(0.5 * cells, -4.0 / 3.0))
          << cells << " cells across";
    }
  }
}

TEST(Lattice, IsMirrorSymmetricToTheBit) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    std::map<std::array<double, 3>, double> mass;
    for (std::size_t i = 0; i < lattice.mass_kg.size(); ++i) mass[lattice.position_m[i]] = lattice.mass_kg[i];
    ASSERT_EQ(mass.size(), lattice.position_m.size());
    for (const auto& [x, m] : mass) {
      const auto over_x = mass.find({-x[0], x[1], x[2]});
      const auto over_y = mass.find({x[0], -x[1], x[2]});
      ASSERT_TRUE(over_x != mass.end() && over_y != mass.end());
      EXPECT_EQ(over_x->second, m);
      EXPECT_EQ(over_y->second, m);
    }
  }
}

TEST(Lattice, OppositeSidesMirrorEachOtherToTheBit) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    for (const std::size_t axis : {0u, 1u}) {
      std::set<std::array<double, 4>> low;
      std::set<std::array<double, 4>> high;
      for (const SurfacePoint& point : lattice.side[2 * axis]) {
        std::array<double, 3> x = lattice.position_m[point.node];
        x[axis] = -x[axis];
        low.insert({x[0], x[1], x[2], -point.position_m});
      }
      for (const SurfacePoint& point : lattice.side[2 * axis + 1]) {
        const auto& x = lattice.position_m[point.node];
        high.insert({x[0], x[1], x[2], point.position_m});
      }
      EXPECT_EQ(low, high);
    }
  }
}

TEST(Lattice, NumbersParticlesInAscendingZThenYThenX) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    for (std::size_t i = 1; i < lattice.position_m.size(); ++i) {
      const auto& a = lattice.position_m[i - 1];
      const auto& b = lattice.position_m[i];
      EXPECT_LT((std::array<double, 3>{a[2], a[1], a[0]}), (std::array<double, 3>{b[2], b[1], b[0]}));
    }
  }
}

TEST(Lattice, CornersOfACellLieAtTheirOffsets) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    for (const auto& cell : lattice.cell) {
      const auto& origin = lattice.position_m[cell[0]];
      for (int c = 0; c < 8; ++c) {
        for (int axis = 0; axis < 3; ++axis) {
          const double offset = lattice.position_m[cell[c]][axis] - origin[axis];
          // rounding of coordinates of size 0.1 m
          ASSERT_NEAR(offset, ((c >> axis) & 1) * lattice.cell_extent_m[axis], 5e-17);
        }
      }
    }
  }
}

TEST(Lattice, HoldsTheCellsWhoseCentresAreInside) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    for (const auto& cell : lattice.cell) {
      double square = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double middle = lattice.position_m[cell[0]][axis] + 0.5 * lattice.cell_extent_m[axis];
        const double q = unit(parameters, lattice, axis, middle);
        if (is_round(parameters, axis)) square += q * q;
      }
      EXPECT_LE(square, 1.0 + 1e-12);
    }
    EXPECT_GT(lattice.cell.size(), 0u);
  }
}

TEST(Lattice, IsFaceConnected) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    std::map<std::array<int, 4>, std::vector<std::size_t>> cells_at_face;
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};
    for (std::size_t i = 0; i < lattice.cell.size(); ++i) {
      for (const auto& face : kFaces) {
        const auto& c = lattice.cell[i];
        cells_at_face[{c[face[0]], c[face[1]], c[face[2]], c[face[3]]}].push_back(i);
      }
    }
    std::vector<std::size_t> root(lattice.cell.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
      while (root[i] != i) i = root[i];
      return i;
    };
    for (const auto& [face, cells] : cells_at_face) {
      if (cells.size() == 2) root[find(cells[1])] = find(cells[0]);
    }
    for (std::size_t i = 0; i < root.size(); ++i) ASSERT_EQ(find(i), find(0));
  }
}

TEST(Lattice, SurfacePointsOfABoxStandOnItsFaces) {
  const Lattice lattice = build_lattice(parameters_of(Shape::box, {0.04, 0.05, 0.07}, 0.0052));
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    for (const SurfacePoint& point : lattice.side[side]) {
      EXPECT_EQ(point.position_m, lattice.position_m[point.node][axis]);
    }
  }
}

TEST(Lattice, SurfacePointsLieOnTheTrueSurface) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    for (std::size_t side = 0; side < 6; ++side) {
      const std::size_t axis = side / 2;
      const double outward = side % 2 == 0 ? -1.0 : 1.0;
      ASSERT_FALSE(lattice.side[side].empty());
      for (const SurfacePoint& point : lattice.side[side]) {
        double others = 0.0;
        for (const std::size_t d : {(axis + 1) % 3, (axis + 2) % 3}) {
          const double q = unit(parameters, lattice, d, lattice.position_m[point.node][d]);
          if (is_round(parameters, d)) others += q * q;
        }
        const double q = unit(parameters, lattice, axis, point.position_m);
        EXPECT_GE(outward * q, 0.0);
        EXPECT_LE(others, 1.0 + 1e-12);
        // q^2 loses half the digits only where the surface is parallel to the normal, so compare squares
        EXPECT_NEAR(q * q, is_round(parameters, axis) ? 1.0 - others : 1.0, 1e-14);
      }
    }
  }
}

TEST(Lattice, SurfacePointsAreTheOutermostOfTheirColumns) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    for (std::size_t side = 0; side < 6; ++side) {
      const std::size_t axis = side / 2;
      const double outward = side % 2 == 0 ? -1.0 : 1.0;
      std::map<std::array<double, 2>, double> outermost;
      for (const auto& x : lattice.position_m) {
        const std::array<double, 2> column{x[(axis + 1) % 3], x[(axis + 2) % 3]};
        const auto [place, fresh] = outermost.try_emplace(column, outward * x[axis]);
        if (!fresh) place->second = std::max(place->second, outward * x[axis]);
      }
      for (const SurfacePoint& point : lattice.side[side]) {
        const auto& x = lattice.position_m[point.node];
        EXPECT_EQ(outward * x[axis], outermost.at({x[(axis + 1) % 3], x[(axis + 2) % 3]}));
      }
    }
  }
}

TEST(Lattice, LowestSurfacePointStandsOnTheGround) {
  for (const LatticeParameters& parameters : assorted()) {
    const Lattice lattice = build_lattice(parameters);
    double lowest = 1.0;
    for (const SurfacePoint& point : lattice.side[4]) lowest = std::min(lowest, point.position_m);
    EXPECT_GE(lowest, 0.0);
    // Even counts of cells put a particle at the very pole.
    if (lattice.cell_count[0] % 2 == 0 && lattice.cell_count[1] % 2 == 0) {
      EXPECT_EQ(lowest, 0.0);
    }
  }
}

TEST(Lattice, RefusesExtentsAndMassesThatAreNotPositive) {
  LatticeParameters parameters = parameters_of(Shape::box, {0.04, 0.0, 0.04}, 0.01);
  EXPECT_THROW(build_lattice(parameters), std::invalid_argument);
  parameters = parameters_of(Shape::box, {0.04, 0.04, 0.04}, 0.0);
  EXPECT_THROW(build_lattice(parameters), std::invalid_argument);
  parameters = parameters_of(Shape::box, {0.04, 0.04, 0.04}, 1e-7);
  EXPECT_THROW(build_lattice(parameters), std::invalid_argument);
  parameters = parameters_of(Shape::box, {0.04, 0.04, 0.04}, 0.01);
  parameters.mass_kg = -1.0;
  EXPECT_THROW(build_lattice(parameters), std::invalid_argument);
}

}  // namespace
}  // namespace unbruised
