// Rank correlations, the copula that has them, and the nearest ones that can be drawn.

#include "studies/statistics/correlation.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "studies/statistics/design.hpp"
#include "studies/statistics/scores.hpp"

namespace unbruised::studies {
namespace {

CorrelationMatrix three(double ab, double ac, double bc) {
  CorrelationMatrix matrix(3);
  matrix.set(0, 1, ab);
  matrix.set(0, 2, ac);
  matrix.set(1, 2, bc);
  return matrix;
}

TEST(RankCorrelations, OfNormalNumbersFollowTheArcsine) {
  // Pearson 1907: rho_s = 6 asin(r / 2) / pi; at r = 1 both are one, and 2 sin(pi / 12) = (sqrt 6 - sqrt 2) / 2.
  EXPECT_NEAR(normal_correlation(1.0), 1.0, 1e-15);
  EXPECT_NEAR(normal_correlation(0.5), 0.5 * (std::sqrt(6.0) - std::sqrt(2.0)), 1e-15);
  for (const double rank : {-0.99, -0.3, 0.0, 0.79}) {
    EXPECT_NEAR(rank_correlation(normal_correlation(rank)), rank, 1e-14);
  }
}

TEST(RankCorrelations, OfSamplesShareTheRanksOfEqualValues) {
  EXPECT_DOUBLE_EQ(spearman(std::array{1.0, 2.0, 3.0, 4.0}, std::array{10.0, 100.0, 1e3, 1e4}), 1.0);
  EXPECT_DOUBLE_EQ(spearman(std::array{1.0, 2.0, 3.0}, std::array{3.0, 2.0, 1.0}), -1.0);
  // Ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3: sum of products 4.5 of 4.5 and 5.
  EXPECT_DOUBLE_EQ(spearman(std::array{1.0, 2.0, 2.0, 3.0}, std::array{1.0, 2.0, 3.0, 4.0}), std::sqrt(4.5 / 5.0));
  EXPECT_TRUE(std::isnan(spearman(std::array{1.0, 1.0}, std::array{1.0, 2.0})));
}

TEST(CorrelationMatrices, HaveTheEigenvaluesOfTheirClosedForm) {
  // All pairs r: 1 + 2r once and 1 - r twice.
  EXPECT_NEAR(least_eigenvalue(three(0.4, 0.4, 0.4)), 0.6, 1e-14);
  EXPECT_NEAR(least_eigenvalue(three(-0.6, -0.6, -0.6)), -0.2, 1e-14);
}

TEST(CorrelationMatrices, AreTheProductOfTheirTriangle) {
  const CorrelationMatrix matrix = three(0.7, -0.2, 0.3);
  const std::vector<double> L = cholesky(matrix);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) sum += L[3 * i + k] * L[3 * j + k];
      EXPECT_NEAR(sum, matrix.at(i, j), 1e-15);
    }
  }
}

TEST(CorrelationMatrices, ThatCannotBeDrawnHaveANearestOneThatCan) {
  const CorrelationMatrix wanted = three(0.9, 0.9, -0.9);
  EXPECT_LT(least_eigenvalue(normal_correlations(wanted)), 0.0);
  const CorrelationMatrix nearest = nearest_ranks(wanted);
  EXPECT_GT(least_eigenvalue(normal_correlations(nearest)), kLeastEigenvalue);
  // By symmetry |r| is one number x in all pairs, and the matrix is singular at x = 1/2: in ranks 6 asin(1/4) / pi
  // = 0.4826, less what keeps the least eigenvalue above 1e-3 and the thousandths.
  EXPECT_NEAR(nearest.at(0, 1), 0.4826, 2e-3);
  EXPECT_NEAR(nearest.at(0, 2), 0.4826, 2e-3);
  EXPECT_NEAR(nearest.at(1, 2), -0.4826, 2e-3);
}

TEST(CorrelationMatrices, NearestIsNoFartherThanOthersThatCanBeDrawn) {
  const CorrelationMatrix wanted = three(0.95, 0.2, 0.9);
  const auto distance = [&](const CorrelationMatrix& other) {
    const CorrelationMatrix a = normal_correlations(wanted);
    const CorrelationMatrix b = normal_correlations(other);
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < i; ++j) squares += (a.at(i, j) - b.at(i, j)) * (a.at(i, j) - b.at(i, j));
    }
    return std::sqrt(squares);
  };
  const double nearest = distance(nearest_ranks(wanted));
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const auto number = [i](std::uint64_t k) { return -1.0 + 2.0 * unit_random(7, i, k); };
    const CorrelationMatrix other = three(number(0), number(1), number(2));
    if (least_eigenvalue(normal_correlations(other)) < kLeastEigenvalue) continue;
    EXPECT_GT(distance(other), nearest - 3e-3);  // thousandths in three pairs
  }
}

TEST(NormalScores, AreInverseToEachOther) {
  for (const double u : {1e-9, 0.025, 0.5, 0.975})
    EXPECT_NEAR(normal_part(normal_quantile(u)), u, 1e-12 * u + 1e-16);
  EXPECT_NEAR(normal_quantile(0.975), normal_score(0.95), 1e-12);
}

}  // namespace
}  // namespace unbruised::studies
