#include "core/body/rigid_motion.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

using Point = std::array<double, 3>;

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point centroid(const std::vector<Point>& points) {
  Point sum{};
  for (const Point& x : points) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += x[k] / static_cast<double>(points.size());
  }
  return sum;
}

std::vector<double> rigid_field(const std::vector<Point>& points, const Point& t, const Point& w) {
  const Point center = centroid(points);
  std::vector<double> u;
  for (const Point& x : points) {
    const Point turned = cross(w, {x[0] - center[0], x[1] - center[1], x[2] - center[2]});
    for (std::size_t k = 0; k < 3; ++k) u.push_back(t[k] + turned[k]);
  }
  return u;
}

std::vector<Point> cloud(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.03, 0.05);
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (Point& x : points) x = {uniform(random), uniform(random), uniform(random)};
  return points;
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) result = std::max(result, std::isnan(value) ? HUGE_VAL : std::abs(value));
  return result;
}

TEST(RigidMotion, RecoversAKnownMotion) {
  const std::vector<Point> points = cloud(40);
  std::vector<double> u = rigid_field(points, {0.01, -0.02, 0.03}, {0.1, 0.2, -0.3});
  const RigidMotion motion = best_fit_rigid_motion(points, u);
  const RigidMotion expected{{0.01, -0.02, 0.03}, {0.1, 0.2, -0.3}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(motion.translation[k], expected.translation[k], 1e-15);
    EXPECT_NEAR(motion.rotation[k], expected.rotation[k], 1e-13);  // 0.03 m lever: 1e-15 / 0.03 and some rounding
  }
  remove_rigid_motion(points, u);
  EXPECT_LT(largest(u), 1e-15);
}

TEST(RigidMotion, LeavesAPureStrainOfASymmetricBodyAlone) {
  std::vector<Point> points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) points.push_back({x, y, z + 5.0});
    }
  }
  std::vector<double> u;
  for (const Point& x : points) u.insert(u.end(), {0.1 * x[0] + 0.02 * x[1], 0.02 * x[0], -0.05 * (x[2] - 5.0)});
  const std::vector<double> before = u;
  remove_rigid_motion(points, u);
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], before[i], 1e-15);
}

TEST(RigidMotion, WhatIsLeftIsTheShortestAndHasNoRigidPart) {
  const std::vector<Point> points = cloud(25);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::vector<double> u(75);
  for (double& value : u) value = normal(random);
  remove_rigid_motion(points, u);
  const RigidMotion left = best_fit_rigid_motion(points, u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(left.translation[k], 0.0, 1e-15);
    EXPECT_NEAR(left.rotation[k], 0.0, 1e-13);
  }
}

TEST(RigidMotion, OfCollinearPointsHasNoRotationAboutTheirLine) {
  std::vector<Point> points;
  for (int i = 0; i < 7; ++i) points.push_back({0.1 * i, 0.2 * i, -0.05 * i});
  std::vector<double> u = rigid_field(points, {1.0, 2.0, 3.0}, {0.2, -0.1, 0.3});
  const RigidMotion motion = best_fit_rigid_motion(points, u);
  const double along = 0.1 * motion.rotation[0] + 0.2 * motion.rotation[1] - 0.05 * motion.rotation[2];
  EXPECT_NEAR(along, 0.0, 1e-13);
  remove_rigid_motion(points, u);
  EXPECT_LT(largest(u), 1e-13);
}

TEST(RigidMotion, OfOnePointOrNoneIsATranslation) {
  const std::vector<Point> one{{1.0, 2.0, 3.0}};
  std::vector<double> u{4.0, 5.0, 6.0};
  const RigidMotion motion = best_fit_rigid_motion(one, u);
  EXPECT_EQ(motion.translation, (Point{4.0, 5.0, 6.0}));
  EXPECT_EQ(motion.rotation, (Point{0.0, 0.0, 0.0}));
  remove_rigid_motion(one, u);
  EXPECT_EQ(u, std::vector<double>(3, 0.0));
  EXPECT_EQ(best_fit_rigid_motion({}, {}).translation, (Point{0.0, 0.0, 0.0}));
}

TEST(RigidMotion, RefusesFieldsThatDoNotFit) {
  const std::vector<double> u(5);
  EXPECT_THROW(best_fit_rigid_motion(cloud(2), u), std::invalid_argument);
}

}  // namespace
}  // namespace unbruised
