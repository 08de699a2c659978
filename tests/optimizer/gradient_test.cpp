#include "optimizer/gradient.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/optimizer/known_problems.hpp"

namespace unbruised::optimizer {
namespace {

using Points = std::vector<std::vector<double>>;

/// Two smooth functions of three variables with derivatives of order one.
std::vector<double> smooth(const std::vector<double>& x) {
  return {std::sin(x[0] + 2.0 * x[1]) * std::exp(x[2]), x[0] * x[1] * x[2] + std::cos(x[0])};
}

Points exact_gradient(const std::vector<double>& x) {
  const double wave = std::cos(x[0] + 2.0 * x[1]) * std::exp(x[2]);
  return {{wave, 2.0 * wave, std::sin(x[0] + 2.0 * x[1]) * std::exp(x[2])},
          {x[1] * x[2] - std::sin(x[0]), x[0] * x[2], x[0] * x[1]}};
}

Points values_at(const Points& points, double noise) {
  Points values;
  for (const std::vector<double>& x : points) {
    values.push_back(smooth(x));
    for (double& value : values.back()) value += noise * testing::noise_at(x);
  }
  return values;
}

/// Central differences at h, h/2, h/4, ... extrapolated to h = 0 (Richardson 1911).
/// @param unit at least `step` away from the walls
Points richardson_gradient(Points (*function)(const Points&), std::span<const double> unit, double step,
                           int levels) {
  std::vector<std::vector<std::vector<double>>> table;
  for (int level = 0; level < levels; ++level) {
    const double h = std::ldexp(step, -level);
    const auto points = difference_points(unit, h, Differences::central);
    table.push_back(difference_quotients(points, function(points), Differences::central));
  }
  // Errors go with h^2, h^4, ...: each pass removes one of them.
  for (int pass = 1; pass < levels; ++pass) {
    const double factor = std::ldexp(1.0, 2 * pass);
    for (int level = levels - 1; level >= pass; --level) {
      auto& fine = table[static_cast<std::size_t>(level)];
      const auto& coarse = table[static_cast<std::size_t>(level - 1)];
      for (std::size_t i = 0; i < fine.size(); ++i) {
        for (std::size_t k = 0; k < fine[i].size(); ++k) {
          fine[i][k] += (fine[i][k] - coarse[i][k]) / (factor - 1.0);
        }
      }
    }
  }
  return table.back();
}

double largest_difference(const Points& a, const Points& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
  }
  return largest;
}

struct Way {
  double step;
  Differences differences;
};

double error_at(const std::vector<double>& x, Way way, double noise) {
  const Points points = difference_points(x, way.step, way.differences);
  return largest_difference(difference_quotients(points, values_at(points, noise), way.differences),
                            exact_gradient(x));
}

std::vector<double> random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> inside(0.0, 1.0);
  std::uniform_int_distribution<int> where(0, 3);
  std::vector<double> x(3);
  for (double& value : x) {
    const int place = where(random);
    value = place == 0 ? 0.0 : place == 1 ? 1.0 : inside(random);
  }
  return x;
}

TEST(Gradient, AsksForThePointAndItsNeighboursInsideTheCube) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 500; ++trial) {
    const std::vector<double> x = random_point(random);
    for (const Way way :
         {Way{1e-4, Differences::forward}, Way{1e-3, Differences::central}, Way{0.25, Differences::central}}) {
      const Points points = difference_points(x, way.step, way.differences);
      ASSERT_EQ(points.size(), way.differences == Differences::central ? 7U : 4U);
      EXPECT_EQ(points[0], x);
      for (const std::vector<double>& point : points) {
        for (const double value : point) EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value << " trial " << trial;
      }
    }
  }
}

TEST(Gradient, OfAParabolaIsExactByCentralDifferencesEvenAtTheWalls) {
  for (const double at : {0.0, 0.3, 1.0}) {
    const Points points = difference_points(std::vector<double>{at}, 0.125, Differences::central);
    Points values;
    for (const auto& x : points) values.push_back({3.0 * x[0] * x[0] - 2.0 * x[0] + 1.0});
    // Rounding of values of order one over a step of 1/8.
    EXPECT_NEAR(difference_quotients(points, values, Differences::central)[0][0], 6.0 * at - 2.0, 1e-14) << at;
  }
}

TEST(Gradient, HasTheOrderOfItsFormulaInsideAndAtTheWalls) {
  for (const std::vector<double>& x : Points{{0.3, 0.4, 0.6}, {0.0, 1.0, 1.0}, {1.0, 0.0, 0.0}}) {
    for (const Differences differences : {Differences::forward, Differences::central}) {
      const double coarse = error_at(x, {1.0 / 128.0, differences}, 0.0);
      const double fine = error_at(x, {1.0 / 1024.0, differences}, 0.0);
      // Eight times finer: 8 and 64 times better, up to the next term, about step x derivatives (below 10) / 128.
      EXPECT_NEAR(std::log2(coarse / fine) / 3.0, differences == Differences::central ? 2.0 : 1.0, 0.05);
    }
  }
}

TEST(Gradient, ByRichardsonIsExactToRounding) {
  const std::vector<double> x = {0.3, 0.4, 0.6};
  const auto function = [](const Points& points) { return values_at(points, 0.0); };
  // Steps 1/8 ... 1/128: the first term left, h^10 f''' ''' ..., is below 1e-13; rounding is 2e-16 / (1/128).
  EXPECT_LT(largest_difference(richardson_gradient(function, x, 0.125, 5), exact_gradient(x)), 1e-12);
}

TEST(Gradient, IsBestAtTheStepsTheHeaderNames) {
  const double noise = 1e-9;
  // Second and third derivatives here are at most 4 and 8 times e: the error is below the two terms of the header.
  const double second = 4.0 * std::exp(1.0);
  const double third = 8.0 * std::exp(1.0);
  std::mt19937_64 random(11);
  double worst_forward = 0.0;
  double worst_central = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<double> x = random_point(random);
    const double h = 1e-4;
    const double forward = error_at(x, {h, Differences::forward}, noise);
    EXPECT_LT(forward, 0.5 * h * second + 2.0 * noise / h) << "trial " << trial;
    worst_forward = std::max(worst_forward, forward);
    const double k = 1e-3;
    const double central = error_at(x, {k, Differences::central}, noise);
    // At a wall both terms are larger: k^2 / 3 f''' and (3 + 4 + 1) / 2 noise / k.
    EXPECT_LT(central, k * k / 3.0 * third + 4.0 * noise / k) << "trial " << trial;
    worst_central = std::max(worst_central, central);
  }
  // A hundredth of those steps drowns in the noise, a hundred times of them in the truncation.
  const std::vector<double> x = {0.3, 0.4, 0.6};
  EXPECT_GT(error_at(x, {1e-6, Differences::forward}, noise), worst_forward);
  EXPECT_GT(error_at(x, {1e-2, Differences::forward}, noise), worst_forward);
  EXPECT_GT(error_at(x, {1e-5, Differences::central}, noise), worst_central);
  EXPECT_GT(error_at(x, {1e-1, Differences::central}, noise), worst_central);
}

}  // namespace
}  // namespace unbruised::optimizer
