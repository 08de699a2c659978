// A mesh of a sphere has the numbers of the sphere, one with edges keeps them, and what any mesh says of itself
// agrees with what it contains.

#include "core/scenario/mesh_solid.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/scenario/mesh_fault.hpp"
#include "core/scenario/true_shape.hpp"
#include "core/scenario/vectors.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/scenario/solids.hpp"

namespace unbruised {
namespace {

using namespace testing;
using Place = std::array<double, 3>;

Place place_in(std::mt19937& random, const Place& size_m, double share) {
  std::uniform_real_distribution<double> part(-0.5 * share, 0.5 * share);
  return {part(random) * size_m[0], part(random) * size_m[1], part(random) * size_m[2]};
}

Place direction_of(std::mt19937& random) {
  std::normal_distribution<double> part;
  Place way = {part(random), part(random), part(random)};
  return times(1.0 / length(way), way);
}

// Smoothed to 1e-4 of the extent, and of that the facets leave a third: so near are all lengths.
TEST(MeshSolid, OfASphereOrAnEllipsoidHasItsNumbers) {
  for (const Place& size_m : {Place{0.05, 0.05, 0.05}, Place{0.04, 0.05, 0.06}}) {
    LatticeParameters same;
    same.shape = Shape::ellipsoid;
    same.size_m = size_m;
    const TrueShape ellipsoid(same);
    for (const int divisions : {2, 4}) {  // 320 and 5,120 triangles
      const TrueShape shape(mesh_product(icosphere(divisions), size_m));
      EXPECT_NEAR(shape.volume_m3() / ellipsoid.volume_m3(), 1.0, 1e-3);
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(shape.center_of_mass_m()[d], 0.0, 1e-9);
        EXPECT_NEAR(shape.mean_square_share(d) / 0.05, 1.0, 1e-3);
        EXPECT_NEAR(shape.mean_product_share(d, (d + 1) % 3), 0.0, 1e-7);
        EXPECT_NEAR(shape.section_m2(d) / ellipsoid.section_m2(d), 1.0, 3e-3);
      }
      for (std::size_t side = 0; side < 6; ++side) {
        EXPECT_EQ(shape.curvatures(side), 2);
        for (std::size_t along = 0; along < 3; ++along) {
          if (along == side / 2) continue;
          EXPECT_NEAR(shape.pole_radius_m(side, along) / ellipsoid.pole_radius_m(side, along), 1.0, 0.02);
          EXPECT_NEAR(shape.pole_m(side)[along], 0.0, 1e-9);
        }
      }
      std::mt19937 random(3);
      for (int i = 0; i < 300; ++i) {
        const Place place = place_in(random, size_m, 1.6);
        const double distance_m = ellipsoid.nearest(place).distance_m;
        EXPECT_NEAR(shape.nearest(place).distance_m, distance_m, 1e-5);
        if (std::abs(distance_m) > 1e-5) {
          EXPECT_EQ(shape.contains(place), ellipsoid.contains(place));
        }
        for (std::size_t side = 0; side < 6; ++side) {
          const auto column = shape.column_m(side, place), expected = ellipsoid.column_m(side, place);
          // Near its rim a column is short of it by more than the surface is.
          if (!expected || *expected < 0.1 * size_m[side / 2]) continue;
          ASSERT_TRUE(column);
          EXPECT_NEAR(*column, *expected, 5e-5);
          Place there = place;
          there[side / 2] = side_sign(side) * *expected;
          EXPECT_GT(dot(shape.outward(side, there), ellipsoid.outward(side, there)), std::cos(0.02));
        }
        const Place way = direction_of(random);
        EXPECT_NEAR(shape.reach_m(way), ellipsoid.reach_m(way), 1e-5);
        const auto hit = shape.first_hit(sum(place, times(-0.2, way)), way);
        const auto expected = ellipsoid.first_hit(sum(place, times(-0.2, way)), way);
        if (!expected || std::abs(dot(expected->normal, way)) < 0.3 * length(expected->normal))
          continue;  // grazes
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->distance_m, expected->distance_m, 3e-5);
      }
    }
  }
}

TEST(MeshSolid, OfACubeKeepsItsEdges) {
  const TrueShape cube(mesh_product(cube_mesh(), {0.04, 0.06, 0.08}));
  EXPECT_NEAR(cube.volume_m3(), 0.04 * 0.06 * 0.08, 1e-18);
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(cube.mean_square_share(d), 1.0 / 12.0, 1e-12);
  for (std::size_t side = 0; side < 6; ++side) {
    EXPECT_EQ(cube.curvatures(side), 0);
    const auto extents = cube.face_extents_m(side);
    const Place size_m = {0.04, 0.06, 0.08};
    EXPECT_NEAR(extents[0] * extents[1], cube.volume_m3() / size_m[side / 2], 1e-12);
  }
  EXPECT_NEAR(cube.nearest({0.0, 0.0, 0.05}).distance_m, 0.01, 1e-12);
  EXPECT_NEAR(cube.nearest({0.019, 0.0, 0.0}).distance_m, -0.001, 1e-12);
  EXPECT_NEAR(cube.nearest({0.019, 0.0, 0.0}).normal[0], 1.0, 1e-12);
  EXPECT_NEAR(cube.outward(5, {0.0199, 0.0299, 0.04})[2], 1.0, 1e-12);
}

// Cell centres and particles stand on edges and corners of such a mesh: each column has to come in once and go out
// once, wherever it passes.
TEST(MeshSolid, DecidesOnEdgesAndCornersToo) {
  for (const TriangleMesh& mesh : {cube_mesh(), icosphere(3)}) {
    const TrueShape shape(mesh_product(mesh, {2.0, 2.0, 2.0}));
    int inside = 0;
    for (int i = -8; i <= 8; ++i) {
      for (int j = -8; j <= 8; ++j) {
        for (int k = -12; k <= 12; ++k) {
          const Place place = {i / 8.0, j / 8.0, k / 8.0};
          if (!shape.contains(place)) continue;
          ++inside;
          EXPECT_LE(std::max({std::abs(place[0]), std::abs(place[1]), std::abs(place[2])}), 1.0);
        }
      }
    }
    EXPECT_TRUE(shape.contains({0.0, 0.0, 0.0}));
    EXPECT_GT(inside, 1500);
  }
}

std::vector<LatticeParameters> others() {
  return {mesh_product(lobed_mesh(4), {0.08, 0.05, 0.06}), mesh_product(lobed_mesh(2), {0.06, 0.06, 0.06}),
          mesh_product(moved(icosphere(3),
                             [](const Place& p) {
                               return Place{p[0] + 0.4 * p[1], p[1], p[2] + p[0]};
                             }),
                       {0.05, 0.04, 0.06})};
}

// Grid points of a smooth body err by far less than one layer of cells at the surface, 6 / 60 of it.
TEST(MeshSolid, HasTheVolumeAndTheMomentsOfWhatItContains) {
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    constexpr int kSide = 60;
    double count = 0.0;
    Place first{}, second{}, product{};
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const std::array<int, 3> at = {i % kSide, i / kSide % kSide, i / kSide / kSide};
      Place q{};
      for (std::size_t d = 0; d < 3; ++d) q[d] = (at[d] + 0.5) / kSide - 0.5;
      if (!shape.contains({q[0] * parameters.size_m[0], q[1] * parameters.size_m[1], q[2] * parameters.size_m[2]}))
        continue;
      count += 1.0;
      for (std::size_t d = 0; d < 3; ++d) {
        first[d] += q[d];
        second[d] += q[d] * q[d];
        product[d] += q[d] * q[(d + 1) % 3];
      }
    }
    const double box = parameters.size_m[0] * parameters.size_m[1] * parameters.size_m[2];
    EXPECT_NEAR(count / std::pow(kSide, 3) * box / shape.volume_m3(), 1.0, 3e-3);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_NEAR(first[d] / count, shape.center_of_mass_m()[d] / parameters.size_m[d], 2e-3);
      EXPECT_NEAR(second[d] / count / shape.mean_square_share(d), 1.0, 5e-3);
      EXPECT_NEAR(product[d] / count, shape.mean_product_share(d, (d + 1) % 3), 1e-3);
    }
  }
}

TEST(MeshSolid, NoPlaceOfItsSurfaceIsNearerThanTheNearestNorFartherThanItsReach) {
  std::mt19937 random(11);
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    std::vector<Place> on;
    for (int i = 0; i < 12000; ++i) {
      Place there = place_in(random, parameters.size_m, 1.0);
      const auto column = shape.column_m(static_cast<std::size_t>(i % 6), there);
      if (!column) continue;
      there[static_cast<std::size_t>(i % 6 / 2)] = (i % 2 == 0 ? -1.0 : 1.0) * *column;
      on.push_back(there);
    }
    for (int round = 0; round < 20; ++round) {
      const Place place = place_in(random, parameters.size_m, 1.5), way = direction_of(random);
      const NearestSurface nearest = shape.nearest(place);
      EXPECT_EQ(nearest.distance_m < 0.0, shape.contains(place));
      double least = 1.0, farthest = 0.0;
      for (const Place& there : on) {
        least = std::min(least, length(between(place, there)));
        farthest = std::max(farthest, dot(way, there));
      }
      EXPECT_LT(std::abs(nearest.distance_m), least + 1e-7);
      EXPECT_GT(std::abs(nearest.distance_m), least - 4e-3);  // the places lie about two millimetres apart
      EXPECT_LE(farthest, shape.reach_m(way) + 1e-9);
      EXPECT_GT(farthest, 0.97 * shape.reach_m(way));
    }
  }
}

TEST(MeshSolid, IsHitWhereARayFirstComesIn) {
  std::mt19937 random(5);
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    for (int round = 0; round < 40; ++round) {
      const Place way = direction_of(random);
      const Place start = sum(place_in(random, parameters.size_m, 1.0), times(-0.15, way));
      constexpr double kStep_m = 2e-5;
      double marched = -1.0;
      for (double t = 0.0; t < 0.3 && marched < 0.0; t += kStep_m) {
        if (shape.contains(sum(start, times(t, way)))) marched = t;
      }
      if (marched < 0.0) continue;  // passed, or grazed between two steps
      const auto hit = shape.first_hit(start, way);
      ASSERT_TRUE(hit.has_value());
      EXPECT_LE(hit->distance_m, marched + 1e-9);
      EXPECT_GT(hit->distance_m, marched - 1.5 * kStep_m);
      EXPECT_LT(dot(hit->normal, way), 1e-9);
    }
  }
}

// A cylinder of 24 sides: neighbouring ones turn by 15 degrees and are one wall, top and bottom have an edge.
TEST(MeshSolid, OfACylinderHasAWallAndFlatEnds) {
  constexpr int kSides = 24;
  TriangleMesh mesh;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    for (const double z : {-1.0, 1.0}) mesh.place.push_back({std::cos(angle), std::sin(angle), z});
  }
  mesh.place.push_back({0.0, 0.0, -1.0});
  mesh.place.push_back({0.0, 0.0, 1.0});
  for (int i = 0; i < kSides; ++i) {
    const int low = 2 * i, next = 2 * ((i + 1) % kSides);
    mesh.triangle.push_back({low, next, low + 1});
    mesh.triangle.push_back({next, next + 1, low + 1});
    mesh.triangle.push_back({2 * kSides, next, low});
    mesh.triangle.push_back({2 * kSides + 1, low + 1, next + 1});
  }
  ASSERT_EQ(mesh_fault(mesh).value_or(""), "");
  const TrueShape can(mesh_product(mesh, {0.05, 0.05, 0.06}));
  for (const std::size_t side : {4U, 5U}) EXPECT_EQ(can.curvatures(side), 0);
  EXPECT_EQ(can.curvatures(0), 1);
  EXPECT_NEAR(can.pole_radius_m(0, 1) / 0.025, 1.0, 0.04);
  EXPECT_NEAR(can.volume_m3() / (std::numbers::pi * 0.025 * 0.025 * 0.06), 1.0, 2e-3);  // a polygon: 1.1 % less
  EXPECT_NEAR(can.outward(5, {0.02, 0.0, 0.03})[2], 1.0, 1e-12);
}

}  // namespace
}  // namespace unbruised
