#include "core/algebra/block_matrix.hpp"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/core/algebra/dense.hpp"

namespace unbruised {
namespace {

std::array<double, 9> block_of(double first) {
  std::array<double, 9> block{};
  for (std::size_t k = 0; k < 9; ++k) block[k] = first + static_cast<double>(k);
  return block;
}

TEST(BlockMatrix, SortsColumnsAndKeepsEveryDiagonalBlock) {
  BlockMatrixBuilder builder(3);
  builder.add(0, 2, block_of(10.0));
  builder.add(2, 0, block_of(20.0));
  builder.add(0, 0, block_of(30.0));
  const BlockMatrix matrix = builder.build();
  EXPECT_EQ(matrix.row_start, (std::vector<int>{0, 2, 3, 5}));
  EXPECT_EQ(matrix.column, (std::vector<int>{0, 2, 1, 0, 2}));
  EXPECT_EQ(matrix.value.size(), 9u * 5u);
  EXPECT_EQ(matrix.value[0], 30.0);
  EXPECT_EQ(matrix.value[9 + 8], 18.0);
  EXPECT_EQ(matrix.value[2 * 9], 0.0);
}

TEST(BlockMatrix, SumsBlocksOfOnePlaceInTheOrderOfInsertion) {
  // (1e16 + 1) - 1e16 = 0 but (1e16 - 1e16) + 1 = 1 in double: the order is visible.
  const auto sum_of = [](double a, double b, double c) {
    BlockMatrixBuilder builder(1);
    for (const double value : {a, b, c}) {
      std::array<double, 9> block{};
      block[0] = value;
      builder.add(0, 0, block);
    }
    return builder.build().value[0];
  };
  EXPECT_EQ(sum_of(1e16, 1.0, -1e16), 0.0);
  EXPECT_EQ(sum_of(1e16, -1e16, 1.0), 1.0);
}

TEST(BlockMatrix, MultipliesAsTheDenseMatrixDoes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  BlockMatrixBuilder builder(6);
  for (int k = 0; k < 20; ++k) {
    std::array<double, 9> block{};
    for (double& value : block) value = uniform(random);
    builder.add(static_cast<int>(random() % 6), static_cast<int>(random() % 6), block);
  }
  const BlockMatrix matrix = builder.build();
  const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(18, [&] { return uniform(random); });
  Eigen::VectorXd y(18);
  multiply(matrix, {x.data(), 18}, {y.data(), 18});
  // 18 products of order one in another order of summation
  EXPECT_LT((y - testing::dense(matrix) * x).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(BlockMatrix, RefusesParticlesAndVectorsThatDoNotFit) {
  BlockMatrixBuilder builder(2);
  EXPECT_THROW(builder.add(0, 2, {}), std::out_of_range);
  EXPECT_THROW(builder.add(-1, 0, {}), std::out_of_range);
  std::vector<double> x(6);
  std::vector<double> y(5);
  EXPECT_THROW(multiply(builder.build(), x, y), std::invalid_argument);
}

}  // namespace
}  // namespace unbruised
