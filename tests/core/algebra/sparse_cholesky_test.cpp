#include "core/algebra/sparse_cholesky.hpp"

#include <thread>

#include <gtest/gtest.h>

#include "core/door/eigen.hpp"
#include "tests/core/algebra/random_matrix.hpp"

namespace unbruised {
namespace {

using testing::random_matrix;
using testing::RandomMatrix;

TEST(SparseCholesky, SolvesLikeDenseEigen) {
  for (int size : {1, 2, 17, 120}) {
    const RandomMatrix made = random_matrix(size, static_cast<unsigned>(size));
    std::string error;
    const auto factor = SparseCholesky::factor(made.sparse, error);
    ASSERT_NE(factor, nullptr) << error;
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0);
    const std::vector<double> x = factor->solve({b.data(), static_cast<std::size_t>(size)});
    const Eigen::VectorXd wanted = made.dense.llt().solve(b);
    for (int i = 0; i < size; ++i) {
      EXPECT_NEAR(x[static_cast<std::size_t>(i)], wanted[i], 1e-12 * wanted.cwiseAbs().maxCoeff()) << size;
    }
    std::vector<double> product(x.size());
    multiply(made.sparse, x, product);
    for (int i = 0; i < size; ++i) EXPECT_NEAR(product[static_cast<std::size_t>(i)], b[i], 1e-12) << size;
  }
}

TEST(SparseCholesky, SolvesManyRightHandSidesLikeOne) {
  const RandomMatrix made = random_matrix(60, 3);
  std::string error;
  const auto factor = SparseCholesky::factor(made.sparse, error);
  ASSERT_NE(factor, nullptr) << error;
  const Eigen::MatrixXd B = Eigen::MatrixXd::Random(60, 5);
  const std::vector<double> all = factor->solve_many({B.data(), 300}, 5);
  for (int j = 0; j < 5; ++j) {
    const std::vector<double> one = factor->solve({B.data() + 60 * j, 60});
    for (int i = 0; i < 60; ++i) {
      EXPECT_NEAR(all[static_cast<std::size_t>(60 * j + i)], one[static_cast<std::size_t>(i)], 1e-12);
    }
  }
}

TEST(SparseCholesky, HandsOutItsFactorAndOrdering) {
  const RandomMatrix made = random_matrix(40, 5);
  std::string error;
  const auto factor = SparseCholesky::factor(made.sparse, error);
  ASSERT_NE(factor, nullptr) << error;
  const CholeskyFactor L = factor->extract();
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(40, 40);
  for (int c = 0; c < 40; ++c) {
    EXPECT_EQ(L.row[static_cast<std::size_t>(L.column_start[static_cast<std::size_t>(c)])], c) << "diagonal first";
    for (int p = L.column_start[static_cast<std::size_t>(c)]; p < L.column_start[static_cast<std::size_t>(c) + 1];
         ++p) {
      full(L.row[static_cast<std::size_t>(p)], c) = L.value[static_cast<std::size_t>(p)];
    }
  }
  const Eigen::MatrixXd product = full * full.transpose();
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      EXPECT_NEAR(
          product(i, j),
          made.dense(L.permutation[static_cast<std::size_t>(i)], L.permutation[static_cast<std::size_t>(j)]),
          1e-13 * made.dense.cwiseAbs().maxCoeff());
    }
  }
}

TEST(SparseCholesky, GivesTheSameBitsTwice) {
  const RandomMatrix made = random_matrix(200, 11);
  std::string error;
  EXPECT_EQ(SparseCholesky::factor(made.sparse, error)->extract().value,
            SparseCholesky::factor(made.sparse, error)->extract().value);
}

TEST(SparseCholesky, RefusesAMatrixThatIsNotPositiveDefinite) {
  std::string error;
  EXPECT_EQ(SparseCholesky::factor(symmetric_from_entries(2, {{0, 0, 1.0}, {1, 0, 2.0}, {1, 1, 1.0}}), error),
            nullptr);
  EXPECT_FALSE(error.empty());
}

TEST(SparseCholesky, OrdersTheSameWhateverOtherThreadsFactorAtTheTime) {
  // A mesh large enough for nested dissection to draw random numbers.
  std::vector<MatrixEntry> entries;
  constexpr int kSide = 40;
  for (int i = 0; i < kSide * kSide; ++i) {
    entries.push_back({i, i, 4.1});
    if (i % kSide + 1 < kSide) entries.push_back({i + 1, i, -1.0});
    if (i + kSide < kSide * kSide) entries.push_back({i + kSide, i, -1.0});
  }
  const SymmetricMatrix mesh = symmetric_from_entries(kSide * kSide, entries);
  const auto order = [&mesh] {
    std::string error;
    return SparseCholesky::factor(mesh, error)->extract().permutation;
  };
  const std::vector<int> alone = order();
  std::vector<int> different(4, 0);
  std::vector<std::thread> threads;
  for (int& count : different) {
    threads.emplace_back([&count, &order, &alone] {
      for (int repeat = 0; repeat < 20; ++repeat) count += order() == alone ? 0 : 1;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const int count : different) EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace unbruised
