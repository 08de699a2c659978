// The always-on checks at the doors of core/algebra: what does not fit together is refused in every build.

#include <stdexcept>

#include <gtest/gtest.h>

#include "core/algebra/lane_matrix.hpp"
#include "core/algebra/shifted_entries.hpp"
#include "core/algebra/supernodal_cholesky.hpp"

namespace unbruised {
namespace {

/// Two particles, each on springs of its own.
BlockMatrix two_particles() {
  BlockMatrixBuilder builder(2);
  for (int i = 0; i < 2; ++i) builder.add(i, i, {2, 0, 0, 0, 3, 0, 0, 0, 4});
  return builder.build();
}

SymmetricMatrix diagonal() { return symmetric_from_entries(2, {{0, 0, 2.0}, {1, 1, 3.0}}); }

TEST(AlgebraDoors, LaneProductsRefuseVectorsOfAnotherSize) {
  const BlockMatrix A = two_particles();
  LaneArray right(6), wrong(5), out(6), out_too(6);
  EXPECT_NO_THROW(multiply(A, right, out));
  EXPECT_THROW(multiply(A, wrong, out), std::logic_error);
  EXPECT_THROW(multiply(A, right, wrong), std::logic_error);
  EXPECT_THROW(multiply_two(A, right, wrong, out, out_too), std::logic_error);
}

TEST(AlgebraDoors, ShiftedEntriesRefuseMassesAndFreedomsOfOtherParticles) {
  const BlockMatrix K = two_particles();
  const std::vector<double> mass_kg = {1.0, 1.0};
  const std::vector<int> freedom = {0, 1, 2, 3, 4, 5};
  EXPECT_NO_THROW(shifted_entries(K, mass_kg, 1.0, freedom));
  EXPECT_THROW(shifted_entries(K, std::vector<double>{1.0}, 1.0, freedom), std::logic_error);
  EXPECT_THROW(shifted_entries(K, mass_kg, 1.0, std::vector<int>{0, 1, 2}), std::logic_error);
}

TEST(AlgebraDoors, FactorisationRefusesWhatIsNoMatrix) {
  std::string error;
  EXPECT_THROW(symmetric_from_entries(2, {{2, 0, 1.0}}), std::logic_error);
  EXPECT_THROW(symmetric_from_entries(2, {{0, -1, 1.0}}), std::logic_error);
  SymmetricMatrix torn = diagonal();
  torn.column_start.pop_back();
  EXPECT_THROW(SparseCholesky::factor(torn, error), std::logic_error);
  EXPECT_THROW(fill_reducing_order(torn), std::logic_error);
  EXPECT_THROW(factor_supernodes(torn, error), std::logic_error);
  EXPECT_THROW(supernodes_of({{0, 3, {}}}, {0, 1}), std::logic_error);
}

TEST(AlgebraDoors, SolutionsRefuseRightHandSidesOfAnotherSize) {
  std::string error;
  const auto factor = SparseCholesky::factor(diagonal(), error);
  EXPECT_THROW(factor->solve(std::vector<double>{1.0}), std::logic_error);
  EXPECT_THROW(factor->solve_many(std::vector<double>{1.0, 2.0, 3.0}, 2), std::logic_error);
}

TEST(AlgebraDoors, ReachAndPositionsRefuseFreedomsThatTheFactorHasNot) {
  std::string error;
  const SupernodalFactor factor = factor_supernodes(diagonal(), error).value();
  EXPECT_NO_THROW(elimination_positions(factor, {0, -1, 1}));
  EXPECT_THROW(elimination_positions(factor, {2}), std::logic_error);
  EXPECT_THROW((void)Reach(factor).of({2}), std::logic_error);
  EXPECT_THROW((void)Reach(factor).of({-1}), std::logic_error);
}

}  // namespace
}  // namespace unbruised
