#include "core/algebra/supernodal_cholesky.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/algebra/lane_solve.hpp"
#include "core/door/eigen.hpp"
#include "core/lanes/lane.hpp"
#include "tests/core/algebra/random_matrix.hpp"

namespace unbruised {
namespace {

using testing::random_matrix;
using testing::RandomMatrix;

TEST(SupernodalCholesky, SolvesLikeDenseEigen) {
  // From one column to fronts of more rows than are eliminated at a time.
  for (const int size : {1, 2, 5, 17, 120, 400}) {
    const RandomMatrix made = random_matrix(size, static_cast<unsigned>(size));
    std::string error;
    const auto factor = factor_supernodes(made.sparse, error);
    ASSERT_TRUE(factor) << error;
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0);
    LaneArray x(static_cast<std::size_t>(size));
    for (int k = 0; k < size; ++k) x.at(static_cast<std::size_t>(k), 0) = b[factor->permutation[k]];
    solve_forward(*factor, x.data());
    solve_backward(*factor, x.data());
    const Eigen::VectorXd wanted = made.dense.llt().solve(b);
    for (int k = 0; k < size; ++k) {
      EXPECT_NEAR(x.at(static_cast<std::size_t>(k), 0), wanted[factor->permutation[k]],
                  1e-12 * wanted.cwiseAbs().maxCoeff())
          << size;
    }
  }
}

TEST(SupernodalCholesky, HasTheOrderAndTheEntriesOfCholmod) {
  const RandomMatrix made = random_matrix(200, 11);
  std::string error;
  const CholeskyFactor L = SparseCholesky::factor(made.sparse, error)->extract();
  const auto factor = factor_supernodes(made.sparse, error);
  ASSERT_TRUE(factor) << error;
  EXPECT_EQ(factor->permutation, L.permutation);
  EXPECT_EQ(factor->entry_count, L.value.size());
  EXPECT_EQ(factor->value, factor_supernodes(made.sparse, error)->value) << "the same bits twice";
}

TEST(SupernodalCholesky, RefusesAMatrixThatIsNotPositiveDefinite) {
  const auto error_of = [](double coupling) {
    std::string error;
    EXPECT_FALSE(
        factor_supernodes(symmetric_from_entries(2, {{0, 0, 1.0}, {1, 0, coupling}, {1, 1, 1.0}}), error));
    return error;
  };
  const std::string wanted = "the matrix is not positive definite (column 1 of 2 of the elimination order)";
  EXPECT_EQ(error_of(2.0), wanted);
  EXPECT_EQ(error_of(1.0), wanted) << "singular";
  EXPECT_EQ(error_of(std::numeric_limits<double>::quiet_NaN()), wanted);
}

}  // namespace
}  // namespace unbruised
