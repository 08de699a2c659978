// The true shape against closed forms: what is inside, how much it holds, how far a place is from the surface.

#include "core/scenario/true_shape.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/scenario/lattice_cells.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

LatticeParameters product(Shape shape, Place size_m, Axis axis = Axis::z) {
  LatticeParameters parameters;
  parameters.shape = shape;
  parameters.size_m = size_m;
  parameters.axis = axis;
  return parameters;
}

const std::vector<LatticeParameters>& all_shapes() {
  static const std::vector<LatticeParameters> all = {
      product(Shape::box, {0.04, 0.06, 0.08}), product(Shape::sphere, {0.05, 0.05, 0.05}),
      product(Shape::ellipsoid, {0.04, 0.06, 0.1}), product(Shape::cylinder, {0.04, 0.06, 0.08}, Axis::y),
      product(Shape::cylinder, {0.05, 0.05, 0.02})};
  return all;
}

/// Distances of some centimetres from sums of some ten terms: round-off of 1e-16 m each.
constexpr double kRoundOff_m = 1e-15;

void expect_nearest(const TrueShape& shape, const Place& place, double distance_m, const Place& normal) {
  const NearestSurface nearest = shape.nearest(place);
  EXPECT_NEAR(nearest.distance_m, distance_m, kRoundOff_m);
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(nearest.normal[d], normal[d], 1e-12) << d;
}

TEST(TrueShape, ReachesAsFarAsItsFarthestPlace) {
  const double a = 0.6, b = 0.8;
  EXPECT_NEAR(TrueShape(all_shapes()[0]).reach_m({0.0, a, -b}), 0.03 * a + 0.04 * b, kRoundOff_m);
  EXPECT_NEAR(TrueShape(all_shapes()[1]).reach_m({a, b, 0.0}), 0.025, kRoundOff_m);
  EXPECT_NEAR(TrueShape(all_shapes()[2]).reach_m({a, 0.0, b}), std::hypot(0.02 * a, 0.05 * b), kRoundOff_m);
  EXPECT_NEAR(TrueShape(all_shapes()[3]).reach_m({0.0, a, b}), 0.03 * a + 0.04 * b, kRoundOff_m);
  EXPECT_NEAR(TrueShape(all_shapes()[3]).reach_m({a, 0.0, b}), std::hypot(0.02 * a, 0.04 * b), kRoundOff_m);
  EXPECT_NEAR(TrueShape(all_shapes()[4]).reach_m({a, 0.0, b}), 0.025 * a + 0.01 * b, kRoundOff_m);
}

TEST(TrueShape, NoPlaceOfItLiesBeyondItsReach) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (const LatticeParameters& parameters : all_shapes()) {
    const TrueShape shape(parameters);
    Place way = {part(random), part(random), part(random)};
    const double length = std::hypot(way[0], way[1], way[2]);
    for (double& component : way) component /= length;
    const double reach_m = shape.reach_m(way);
    double farthest_m = 0.0;
    for (int i = 0; i < 200000; ++i) {
      Place place;
      for (std::size_t d = 0; d < 3; ++d) place[d] = 0.5 * part(random) * parameters.size_m[d];
      if (!shape.contains(place)) continue;
      farthest_m = std::max(farthest_m, place[0] * way[0] + place[1] * way[1] + place[2] * way[2]);
    }
    EXPECT_LE(farthest_m, reach_m);
    EXPECT_GT(farthest_m, 0.9 * reach_m);  // 2e5 places come within 2 % of a side in each direction
  }
}

TEST(TrueShape, HoldsTheVolumeThatItContains) {
  for (const LatticeParameters& parameters : all_shapes()) {
    const TrueShape shape(parameters);
    constexpr int kSide = 60;
    int inside = 0;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const std::array<int, 3> at = {i % kSide, i / kSide % kSide, i / kSide / kSide};
      Place place;
      for (std::size_t d = 0; d < 3; ++d) place[d] = ((at[d] + 0.5) / kSide - 0.5) * parameters.size_m[d];
      inside += shape.contains(place) ? 1 : 0;
    }
    const Place& size = parameters.size_m;
    const double counted = size[0] * size[1] * size[2] * inside / (kSide * kSide * kSide);
    // Grid points of a smooth body err by far less than one layer of cells at the surface, 6 / 60 of it.
    EXPECT_NEAR(counted, shape.volume_m3(), 2e-3 * shape.volume_m3());
    EXPECT_EQ(true_volume_m3(parameters), shape.volume_m3());
  }
}

TEST(TrueShape, ABoxIsNearestAtItsFaceEdgeOrCorner) {
  const TrueShape box(product(Shape::box, {0.04, 0.06, 0.08}));
  expect_nearest(box, {0.015, 0.0, 0.0}, -0.005, {1.0, 0.0, 0.0});
  expect_nearest(box, {0.0, -0.035, 0.01}, 0.005, {0.0, -1.0, 0.0});
  expect_nearest(box, {0.023, 0.034, 0.0}, 0.005, {0.6, 0.8, 0.0});
  expect_nearest(box, {-0.021, 0.032, 0.042}, 0.003, {-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0});
}

TEST(TrueShape, ASphereIsNearestAlongTheRadius) {
  const TrueShape sphere(product(Shape::sphere, {0.05, 0.05, 0.05}));
  for (const double radius : {0.001, 0.024, 0.025, 0.1}) {
    expect_nearest(sphere, {0.6 * radius, 0.0, -0.8 * radius}, radius - 0.025, {0.6, 0.0, -0.8});
  }
  EXPECT_NEAR(sphere.nearest({0.0, 0.0, 0.0}).distance_m, -0.025, kRoundOff_m);
}

TEST(TrueShape, ACylinderIsNearestAtItsMantleOrItsEnd) {
  const TrueShape cylinder(product(Shape::cylinder, {0.05, 0.05, 0.08}));
  expect_nearest(cylinder, {0.018, 0.0, 0.0}, -0.007, {1.0, 0.0, 0.0});
  expect_nearest(cylinder, {0.0, 0.005, 0.038}, -0.002, {0.0, 0.0, 1.0});
  expect_nearest(cylinder, {0.0, 0.028, -0.044}, 0.005, {0.0, 0.6, -0.8});
}

TEST(TrueShape, AnEllipsoidIsNearestAtThePolesOfItsAxesAndInTheMiddleAtTheShortest) {
  const TrueShape ellipsoid(product(Shape::ellipsoid, {0.04, 0.06, 0.1}));
  expect_nearest(ellipsoid, {0.03, 0.0, 0.0}, 0.01, {1.0, 0.0, 0.0});
  expect_nearest(ellipsoid, {0.0, 0.0, -0.06}, 0.01, {0.0, 0.0, -1.0});
  const NearestSurface middle = ellipsoid.nearest({0.0, 0.0, 0.0});
  EXPECT_NEAR(middle.distance_m, -0.02, kRoundOff_m);
  // On the long axis, nearer to the middle than its centre of curvature at c - a^2 / c = 0.042 m: the foot lies
  // where z_foot = c^2 z / (c^2 - a^2).
  const double z = 0.01, foot_z = 0.0025 * z / (0.0025 - 0.0004);
  const double foot_x = 0.02 * std::sqrt(1.0 - foot_z * foot_z / 0.0025);
  EXPECT_NEAR(ellipsoid.nearest({0.0, 0.0, z}).distance_m, -std::hypot(foot_x, foot_z - z), kRoundOff_m);
}

TEST(TrueShape, AStepOfTheDistanceAgainstTheNormalEndsOnTheSurface) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-0.06, 0.06);
  for (const LatticeParameters& parameters : all_shapes()) {
    const TrueShape shape(parameters);
    for (int i = 0; i < 200; ++i) {
      const Place place = {anywhere(random), anywhere(random), anywhere(random)};
      const NearestSurface nearest = shape.nearest(place);
      EXPECT_EQ(nearest.distance_m <= 0.0, shape.contains(place));
      Place within, beyond;
      for (std::size_t d = 0; d < 3; ++d) {
        const double foot = place[d] - nearest.distance_m * nearest.normal[d];
        // A nanometre to either side: the foot itself is known to some 1e-13 m where it is bisected near a pole.
        within[d] = foot - 1e-9 * nearest.normal[d];
        beyond[d] = foot + 1e-9 * nearest.normal[d];
      }
      EXPECT_TRUE(shape.contains(within)) << place[0] << " " << place[1] << " " << place[2];
      EXPECT_FALSE(shape.contains(beyond)) << place[0] << " " << place[1] << " " << place[2];
    }
  }
}

TEST(TrueShape, ChordAndCurvatureAtThePoleAreThoseOfTheEllipsoid) {
  const TrueShape ellipsoid(product(Shape::ellipsoid, {0.04, 0.06, 0.1}));
  EXPECT_EQ(ellipsoid.column_m(0, {0.0, 0.0, 0.0}), 0.02);
  EXPECT_DOUBLE_EQ(ellipsoid.column_m(1, {0.0, 0.03 * 0.6, 0.0}).value(), 0.02 * 0.8);
  EXPECT_EQ(ellipsoid.column_m(0, {0.0, 0.031, 0.0}), std::nullopt);
  EXPECT_DOUBLE_EQ(ellipsoid.pole_radius_m(0, 1), 0.03 * 0.03 / 0.02);
  EXPECT_EQ(ellipsoid.curvatures(0), 2);
  EXPECT_EQ(TrueShape(product(Shape::cylinder, {0.05, 0.05, 0.02})).curvatures(0), 1);
  EXPECT_EQ(TrueShape(product(Shape::cylinder, {0.05, 0.05, 0.02})).curvatures(4), 0);
}

}  // namespace
}  // namespace unbruised
