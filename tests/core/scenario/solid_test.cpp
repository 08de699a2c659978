// Solids of revolution and superellipsoids: where they are a sphere or an ellipsoid they give its numbers;
// elsewhere what they say of themselves agrees with what they contain.

#include "core/scenario/solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/scenario/profile_curve.hpp"
#include "core/scenario/true_shape.hpp"
#include "tests/core/scenario/solids.hpp"

namespace unbruised {
namespace {

using namespace testing;
using Place = std::array<double, 3>;

constexpr double kPi = std::numbers::pi;

LatticeParameters ellipsoid_of(const Place& size_m) {
  LatticeParameters product;
  product.shape = Shape::ellipsoid;
  product.size_m = size_m;
  return product;
}

/// With the ellipsoid that each of them is.
std::vector<std::pair<LatticeParameters, LatticeParameters>> ellipsoids() {
  std::vector<std::pair<LatticeParameters, LatticeParameters>> all;
  const Place ball = {0.05, 0.05, 0.05}, egg = {0.04, 0.04, 0.06}, lying = {0.04, 0.06, 0.04},
              odd = {0.04, 0.05, 0.06};
  all.emplace_back(revolution_of(sphere_profile(), ball), ellipsoid_of(ball));
  all.emplace_back(revolution_of(sphere_profile(), egg), ellipsoid_of(egg));
  all.emplace_back(revolution_of(sphere_profile(), lying, Axis::y), ellipsoid_of(lying));
  all.emplace_back(superellipsoid_of({2.0, 2.0}, ball), ellipsoid_of(ball));
  all.emplace_back(superellipsoid_of({2.0, 2.0}, odd), ellipsoid_of(odd));
  return all;
}

std::vector<LatticeParameters> others() {
  return {revolution_of(pear_profile(), {0.06, 0.06, 0.08}),
          revolution_of(pear_profile(), {0.06, 0.08, 0.06}, Axis::y),
          revolution_of(bottle_profile(), {0.03, 0.03, 0.066}),
          superellipsoid_of({3.0, 2.5}, {0.04, 0.06, 0.05}),
          superellipsoid_of({4.0, 4.0}, {0.05, 0.04, 0.03}),
          superellipsoid_of({2.0, 3.5}, {0.05, 0.05, 0.04})};
}

// The curve through a sphere's points is that sphere, so that all but searches by golden sections is exact.
TEST(Solid, OfAnEllipsoidHasItsNumbers) {
  for (const auto& [parameters, same] : ellipsoids()) {
    const TrueShape shape(parameters), ellipsoid(same);
    ASSERT_NE(shape.solid(), nullptr);
    EXPECT_NEAR(shape.volume_m3() / ellipsoid.volume_m3(), 1.0, 1e-12);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_NEAR(shape.center_of_mass_m()[d], 0.0, 1e-15);
      EXPECT_NEAR(shape.mean_square_share(d), 0.05, 1e-13);
      // Along the axis of revolution the outline is summed with five points a piece.
      EXPECT_NEAR(shape.section_m2(d) / ellipsoid.section_m2(d), 1.0, 0.01);
    }
    for (std::size_t side = 0; side < 6; ++side) {
      EXPECT_EQ(shape.curvatures(side), 2);
      for (std::size_t along = 0; along < 3; ++along) {
        if (along == side / 2) continue;
        EXPECT_NEAR(shape.pole_radius_m(side, along) / ellipsoid.pole_radius_m(side, along), 1.0, 1e-9);
        EXPECT_NEAR(shape.pole_m(side)[along], 0.0, 1e-6);
      }
    }
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-0.04, 0.04);
    for (int i = 0; i < 200; ++i) {
      const Place place = {part(random), part(random), part(random)};
      EXPECT_EQ(shape.contains(place), ellipsoid.contains(place));
      EXPECT_NEAR(shape.nearest(place).distance_m, ellipsoid.nearest(place).distance_m, 1e-8);
      for (std::size_t side = 0; side < 6; ++side) {
        const auto column = shape.column_m(side, place), expected = ellipsoid.column_m(side, place);
        ASSERT_EQ(column.has_value(), expected.has_value());
        if (!column) continue;
        EXPECT_NEAR(*column, *expected, 1e-12);
        Place there = place;
        there[side / 2] = (side % 2 == 0 ? -1.0 : 1.0) * *expected;
        for (std::size_t d = 0; d < 3; ++d) {
          EXPECT_NEAR(shape.outward(side, there)[d], ellipsoid.outward(side, there)[d], 1e-7);
        }
      }
      Place way = {part(random), part(random), part(random)};
      const double length = std::hypot(way[0], way[1], way[2]);
      for (double& w : way) w /= length;
      EXPECT_NEAR(shape.reach_m(way), ellipsoid.reach_m(way), 1e-12);
      const Place start = {place[0] - 0.2 * way[0], place[1] - 0.2 * way[1], place[2] - 0.2 * way[2]};
      const auto hit = shape.first_hit(start, way), expected = ellipsoid.first_hit(start, way);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      if (!hit) continue;
      EXPECT_NEAR(hit->distance_m, expected->distance_m, 1e-9);
    }
  }
}

// Grid points of a smooth body err by far less than one layer of cells at the surface, 6 / 80 of it.
TEST(Solid, HasTheVolumeAndTheMomentsOfWhatItContains) {
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    constexpr int kSide = 80;
    double count = 0.0;
    Place first{}, second{};
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const std::array<int, 3> at = {i % kSide, i / kSide % kSide, i / kSide / kSide};
      Place place{};
      for (std::size_t d = 0; d < 3; ++d) place[d] = ((at[d] + 0.5) / kSide - 0.5) * parameters.size_m[d];
      if (!shape.contains(place)) continue;
      count += 1.0;
      for (std::size_t d = 0; d < 3; ++d) {
        first[d] += place[d];
        second[d] += place[d] * place[d];
      }
    }
    const double box = parameters.size_m[0] * parameters.size_m[1] * parameters.size_m[2];
    EXPECT_NEAR(count / std::pow(kSide, 3) * box / shape.volume_m3(), 1.0, 3e-3);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_NEAR(first[d] / count, shape.center_of_mass_m()[d], 2e-3 * parameters.size_m[d]);
      const double share = second[d] / count / (parameters.size_m[d] * parameters.size_m[d]);
      EXPECT_NEAR(share / shape.mean_square_share(d), 1.0, 5e-3);
    }
  }
}

TEST(Solid, ReachesAsFarAsItsFarthestColumn) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    for (int round = 0; round < 8; ++round) {
      Place way = {part(random), part(random), part(random)};
      const double length = std::hypot(way[0], way[1], way[2]);
      for (double& component : way) component /= length;
      double farthest_m = 0.0;
      for (int i = 0; i < 6000; ++i) {
        Place place;
        for (std::size_t d = 0; d < 3; ++d) place[d] = 0.5 * part(random) * parameters.size_m[d];
        const std::size_t side = static_cast<std::size_t>(i % 6);
        const auto column = shape.column_m(side, place);
        if (!column) continue;
        place[side / 2] = (side % 2 == 0 ? -1.0 : 1.0) * *column;
        farthest_m = std::max(farthest_m, place[0] * way[0] + place[1] * way[1] + place[2] * way[2]);
      }
      EXPECT_LE(farthest_m, shape.reach_m(way) + 1e-9);
      EXPECT_GT(farthest_m, 0.97 * shape.reach_m(way));  // some thousand places of the surface come so near
    }
  }
}

// The nearest place is as far away as it says along its normal, and none of many places of the surface is nearer.
TEST(Solid, NoPlaceOfItsSurfaceIsNearerThanTheNearest) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    for (int round = 0; round < 20; ++round) {
      Place place;
      for (std::size_t d = 0; d < 3; ++d) place[d] = 0.7 * part(random) * parameters.size_m[d];
      const NearestSurface nearest = shape.nearest(place);
      EXPECT_EQ(nearest.distance_m < 0.0, shape.contains(place));
      double least = 1.0;
      for (int i = 0; i < 5000; ++i) {
        Place there;
        for (std::size_t d = 0; d < 3; ++d) there[d] = 0.5 * part(random) * parameters.size_m[d];
        const std::size_t side = static_cast<std::size_t>(i % 6);
        const auto column = shape.column_m(side, there);
        if (!column) continue;
        there[side / 2] = (side % 2 == 0 ? -1.0 : 1.0) * *column;
        least = std::min(least, std::hypot(there[0] - place[0], there[1] - place[1], there[2] - place[2]));
      }
      EXPECT_LT(std::abs(nearest.distance_m), least + 1e-7);
      EXPECT_GT(std::abs(nearest.distance_m), least - 4e-3);  // the places lie about two millimetres apart
    }
  }
}

TEST(Solid, IsHitWhereARayFirstComesIn) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (const LatticeParameters& parameters : others()) {
    const TrueShape shape(parameters);
    for (int round = 0; round < 60; ++round) {
      Place towards, way = {part(random), part(random), round % 5 == 0 ? 0.0 : part(random)};
      const double length = std::hypot(way[0], way[1], way[2]);
      for (double& component : way) component /= length;
      for (std::size_t d = 0; d < 3; ++d) towards[d] = 0.5 * part(random) * parameters.size_m[d];
      constexpr double kStep_m = 2e-5, kBefore_m = 0.15;
      double marched = -1.0;
      const auto at = [&](double t) {
        return Place{towards[0] + (t - kBefore_m) * way[0], towards[1] + (t - kBefore_m) * way[1],
                     towards[2] + (t - kBefore_m) * way[2]};
      };
      for (double t = 0.0; t < 2.0 * kBefore_m && marched < 0.0; t += kStep_m) {
        if (shape.contains(at(t))) marched = t;
      }
      const auto hit = shape.first_hit(at(0.0), way);
      if (marched < 0.0) continue;  // passed, or grazed between two steps
      ASSERT_TRUE(hit.has_value());
      EXPECT_LE(hit->distance_m, marched + 1e-9);
      EXPECT_GT(hit->distance_m, marched - 1.5 * kStep_m);
      EXPECT_LT(hit->normal[0] * way[0] + hit->normal[1] * way[1] + hit->normal[2] * way[2], 1e-9);
    }
  }
}

TEST(Solid, OfAStraightProfileIsACylinder) {
  const TrueShape can(revolution_of({{0.0, 0.0}, {0.0, 3.0}, {8.0, 3.0}, {8.0, 0.0}}, {0.05, 0.05, 0.06}));
  EXPECT_NEAR(can.volume_m3() / (kPi * 0.025 * 0.025 * 0.06), 1.0, 1e-12);
  EXPECT_EQ(can.curvatures(0), 1);
  EXPECT_TRUE(can.curves(0, 1));
  EXPECT_FALSE(can.curves(0, 2));
  EXPECT_EQ(can.curvatures(4), 0);
  EXPECT_NEAR(can.face_extents_m(4)[0] * can.face_extents_m(4)[1], kPi * 0.025 * 0.025, 1e-12);
  EXPECT_EQ(can.outward(5, {0.01, 0.0, 0.03}), (Place{0.0, 0.0, 1.0}));
  EXPECT_NEAR(can.nearest({0.0, 0.005, 0.028}).distance_m, -0.002, 1e-12);
  EXPECT_NEAR(can.reach_m({0.6, 0.0, 0.8}), 0.6 * 0.025 + 0.8 * 0.03, 1e-12);
}

TEST(Solid, HasTheCurvatureOfItsPoles) {
  const TrueShape pear(revolution_of(pear_profile(), {0.06, 0.06, 0.08}));
  // Its widest place lies below the middle; around it the radius is that of the belly.
  EXPECT_LT(pear.pole_m(0)[2], -0.01);
  EXPECT_NEAR(pear.pole_radius_m(0, 1), 0.03, 1e-12);
  EXPECT_EQ(pear.curvatures(4), 0);
  EXPECT_EQ(pear.curvatures(5), 2);
  EXPECT_LT(pear.center_of_mass_m()[2], -0.005);
  EXPECT_FALSE(pear.is_mirrored(2));
  EXPECT_TRUE(pear.is_mirrored(0));
  // A bottle's wall counts as straight.
  const TrueShape bottle(revolution_of(bottle_profile(), {0.03, 0.03, 0.066}));
  EXPECT_EQ(bottle.curvatures(0), 1);
  // The parabola through a third of the half extent: 18 times an ellipsoid's radius for an exponent of 4.
  const TrueShape cushion(superellipsoid_of({4.0, 2.0}, {0.06, 0.06, 0.04}));
  EXPECT_NEAR(cushion.pole_radius_m(0, 1), 18.0 * 0.03, 1e-12);
  EXPECT_NEAR(cushion.pole_radius_m(0, 2), 0.02 * 0.02 / 0.03, 1e-12);
}

TEST(ProfileCurve, GoesThroughItsPointsAndIsTwiceContinuous) {
  const LatticeParameters pear = revolution_of(pear_profile(), {0.76, 0.76, 1.0});
  const ProfileCurve curve(pear.profile_height, pear.profile_radius, 1.0, 0.38);
  double widest = 0.0;
  for (int i = 0; i <= 4000; ++i) widest = std::max(widest, curve.q(i / 4000.0 - 0.5));
  EXPECT_NEAR(std::sqrt(widest), 0.38, 1e-6);
  const auto& pieces = curve.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double h = pieces[i].length;
    EXPECT_NEAR(pieces[i].q.at(h), pieces[i + 1].q.at(0.0), 1e-13);
    EXPECT_NEAR(pieces[i].q.slope(h), pieces[i + 1].q.slope(0.0), 1e-12);
    EXPECT_NEAR(2.0 * pieces[i].q.c[2] + 6.0 * h * pieces[i].q.c[3], 2.0 * pieces[i + 1].q.c[2], 1e-11);
  }
}

std::string fault_of(const std::vector<std::array<double, 2>>& points) {
  const LatticeParameters product = revolution_of(points, {0.05, 0.05, 0.05});
  const auto fault = profile_fault(product.profile_height, product.profile_radius);
  return fault ? (fault->of_heights ? "height " : "radius ") + fault->value + ": " + fault->rule : "";
}

TEST(ProfileFault, SaysEachInASentence) {
  EXPECT_EQ(fault_of(pear_profile()), "");
  EXPECT_EQ(fault_of(bottle_profile()), "");
  EXPECT_EQ(fault_of({{0, 0}, {1, 1}, {2, 0}}), "height 3 points: must be 4 to 1000 points, from end to end");
  EXPECT_EQ(
      fault_of({{0, 0.5}, {1, 1}, {2, 1}, {3, 0}}),
      "radius 0.5: must begin at 0, on the axis: the profile is open there; a flat end has the axis and its rim "
      "at one height");
  EXPECT_EQ(
      fault_of({{0, 0}, {1, 1}, {2, 1}, {3, 0.5}}),
      "radius 0.5: must end at 0, on the axis: the profile is open there; a flat end has the axis and its rim at "
      "one height");
  EXPECT_EQ(fault_of({{0, 0}, {1, 1}, {2, -1}, {3, 0}}),
            "radius -1.0: must be >= 0: it is the distance from the axis");
  EXPECT_EQ(fault_of({{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}}),
            "radius 0.0: must be > 0 between the ends: the profile touches its axis at the height 2");
  EXPECT_EQ(fault_of({{0, 0}, {2, 1}, {1, 1}, {3, 0}}),
            "height 1.0: must be > the height before it, 2.0: the points go from end to end along the axis");
  EXPECT_EQ(fault_of({{0, 0}, {1, 1}, {1, 0.5}, {2, 0.5}, {3, 0}}),
            "height 1.0: must be > the height before it, 1.0: the points go from end to end along the axis");
  EXPECT_EQ(
      fault_of({{0, 0}, {0.1, 0.01}, {1, 1}, {2, 1}, {3, 0}}),
      "radius : make a smooth curve that crosses its axis at the height 0: give more points around it, or round "
      "the end off");
  LatticeParameters uneven = revolution_of(pear_profile(), {0.05, 0.05, 0.05});
  uneven.profile_radius.pop_back();
  EXPECT_EQ(profile_fault(uneven.profile_height, uneven.profile_radius)->rule,
            "must be as many as profile_height = 11");
}

}  // namespace
}  // namespace unbruised
