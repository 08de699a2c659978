#include "optimizer/pareto.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace unbruised::optimizer {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Points of f2 = 1 - sqrt(f1) (ZDT1; Zitzler, Deb and Thiele 2000) at f1 = (i / n)^2, ends included.
std::vector<Objectives> root_front(int n) {
  std::vector<Objectives> points;
  for (int i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / n;
    points.push_back({t * t, 1.0 - t});
  }
  return points;
}

/// f = 1 - u on the octant of the unit sphere: all nondominated, the ideal point at 0.
std::vector<Objectives> sphere_front(int n) {
  std::vector<Objectives> points;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double a = 0.5 * std::numbers::pi * i / n;
      const double b = 0.5 * std::numbers::pi * j / n;
      points.push_back({1.0 - std::cos(a) * std::cos(b), 1.0 - std::sin(a) * std::cos(b), 1.0 - std::sin(b)});
    }
  }
  return points;
}

/// Points on a grid of whole numbers below `size`, and so with many equal coordinates.
std::vector<Objectives> grid_points(std::mt19937& random, std::size_t objectives, int count, int size) {
  std::uniform_int_distribution<int> place(0, size - 1);
  std::vector<Objectives> points;
  for (int i = 0; i < count; ++i) {
    Objectives point(objectives);
    for (double& value : point) value = place(random);
    points.push_back(point);
  }
  return points;
}

/// Cells of the unit grid that at least one point dominates: what the hypervolume of whole numbers must be.
double cells_dominated(const std::vector<Objectives>& points, int size) {
  int count = 0;
  const int depth = points.front().size() == 3 ? size : 1;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < depth; ++z) {
        bool covered = false;
        for (const Objectives& p : points) {
          covered = covered || (p[0] <= x && p[1] <= y && (p.size() == 2 || p[2] <= z));
        }
        count += covered ? 1 : 0;
      }
    }
  }
  return count;
}

TEST(Pareto, KeepsWhatNoOtherDominatesOnceAndInOrder) {
  const std::vector<Objectives> points = {{2, 2}, {1, 3}, {3, 1}, {2, 2}, {3, 3}, {1, 4}, {0, 9}, {kNan, 0}};
  EXPECT_EQ(nondominated(points), (std::vector<std::size_t>{0, 1, 2, 6}));
  EXPECT_TRUE(nondominated({}).empty());
  EXPECT_TRUE(nondominated({{kNan, kNan}}).empty());
}

TEST(Pareto, KeepsExactlyTheMaximalSetOfRandomPoints) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const std::vector<Objectives> points = grid_points(random, 2 + seed % 2, 60, 8);
    const std::vector<std::size_t> front = nondominated(points);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool stays = true;
      for (std::size_t j = 0; j < points.size(); ++j) {
        stays = stays && !dominates(points[j], points[i]) && !(j < i && points[j] == points[i]);
      }
      if (stays) expected.push_back(i);
    }
    EXPECT_EQ(front, expected) << "seed " << seed;
  }
}

TEST(Pareto, AreaUnderTheRootFrontIsItsStaircaseAndTendsToTwoThirds) {
  for (const int n : {1, 4, 50, 400}) {
    // Steps of width ((i + 1)^2 - i^2) / n^2 and height i / n; their sum in closed form.
    const double m = n;
    const double steps = ((m - 1.0) * m * (2.0 * m - 1.0) / 3.0 + (m - 1.0) * m / 2.0) / (m * m * m);
    const double area = hypervolume(root_front(n), {1.0, 1.0});
    EXPECT_NEAR(area, steps, 1e-13) << n;   // n roundings of numbers below one
    EXPECT_NEAR(area, 2.0 / 3.0, 1.0 / m);  // a monotone function is within one step of its staircase
  }
}

TEST(Pareto, VolumeOfTheSphereFrontTendsToThatOfTheOctant) {
  const double exact = std::numbers::pi / 6.0;
  // The staircase lies inside, by a layer of about the distance of the points, pi / 2n, on an area of pi / 2.
  for (const int n : {10, 20, 40}) {
    const double volume = hypervolume(sphere_front(n), {1.0, 1.0, 1.0});
    EXPECT_LT(volume, exact);
    EXPECT_GT(volume, exact - std::numbers::pi / 2.0 * std::numbers::pi / (2.0 * n));
  }
}

TEST(Pareto, HypervolumeOfWholeNumbersIsTheNumberOfCells) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const std::size_t objectives = 2 + seed % 2;
    const std::vector<Objectives> points = grid_points(random, objectives, 12, 7);
    EXPECT_EQ(hypervolume(points, Objectives(objectives, 7.0)), cells_dominated(points, 7)) << "seed " << seed;
  }
}

TEST(Pareto, PointsBeyondTheReferenceCountForNothing) {
  EXPECT_EQ(hypervolume({{0.5, 2.0}, {2.0, 0.5}, {1.0, 0.0}, {kNan, 0.0}}, {1.0, 1.0}), 0.0);
  EXPECT_EQ(hypervolume({{0.5, 0.5, 0.5}, {0.0, 0.0, 1.0}, {0.0, kNan, 0.0}}, {1.0, 1.0, 1.0}), 0.125);
  EXPECT_EQ(hypervolume({}, {1.0, 1.0, 1.0}), 0.0);
}

TEST(Pareto, KneeOfTheRootFrontIsWhereItsSlopeIsThatOfTheLineThroughTheEnds) {
  // x + y = t^2 + 1 - t is least at t = 1/2, in whatever units the objectives are.
  std::vector<Objectives> front = root_front(100);
  EXPECT_EQ(knee(front), 50U);
  for (Objectives& point : front) point = {3e-6 * point[0] - 1.0, 7e4 * point[1] + 5.0};
  EXPECT_EQ(knee(front), 50U);
}

TEST(Pareto, KneeOfTheSphereFrontIsOnItsDiagonal) {
  std::vector<Objectives> front = {{0.0, 1.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 1.0, 0.0}};
  for (const Objectives& point : sphere_front(7)) front.push_back(point);
  const double diagonal = 1.0 - 1.0 / std::sqrt(3.0);
  front.push_back({diagonal, diagonal, diagonal});
  EXPECT_EQ(knee(front), front.size() - 1);
}

TEST(Pareto, KneeIsMeasuredFromThePlaneThroughTheRealEnds) {
  // The plane through the first three has the normal (1, 1/2, 1): 0.9 and 0.975 at the last two. Their sums, the
  // distance from the plane through (1, 0, 0), (0, 1, 0), (0, 0, 1), rank them the other way.
  const std::vector<Objectives> front = {
      {0.0, 1.0, 1.0}, {1.0, 0.0, 0.5}, {1.0, 1.0, 0.0}, {0.45, 0.05, 0.5}, {0.3, 0.3, 0.45}};
  ASSERT_EQ(nondominated(front).size(), front.size());
  EXPECT_EQ(knee(front), 4U);
}

TEST(Pareto, KneeOfFewPointsIsOneOfThem) {
  EXPECT_EQ(knee({{3.0, 4.0}}), 0U);
  EXPECT_EQ(knee({{3.0, 4.0, 5.0}}), 0U);
  EXPECT_EQ(knee({{0.0, 1.0}, {1.0, 0.0}}), 0U);                             // both on the line: the first
  EXPECT_EQ(knee({{0.0, 1.0, 2.0}, {1.0, 0.0, 2.0}, {0.2, 0.2, 2.0}}), 2U);  // no plane: two objectives are left
}

}  // namespace
}  // namespace unbruised::optimizer
