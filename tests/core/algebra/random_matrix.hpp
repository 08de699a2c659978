#pragma once

/// @file
/// Matrices to factor.

#include <algorithm>
#include <random>
#include <vector>

#include "core/algebra/sparse_cholesky.hpp"
#include "core/door/eigen.hpp"

namespace unbruised::testing {

/// A random sparse symmetric matrix that diagonal dominance makes positive definite, and its dense copy.
struct RandomMatrix {
  SymmetricMatrix sparse;
  Eigen::MatrixXd dense;
};

inline RandomMatrix random_matrix(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::uniform_int_distribution<int> place(0, size - 1);
  std::vector<MatrixEntry> entries;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  for (int k = 0; k < 4 * size; ++k) {
    const int i = place(random), j = place(random);
    if (i == j) continue;
    const double x = value(random);
    entries.push_back({std::max(i, j), std::min(i, j), x});
    dense(i, j) += x;
    dense(j, i) += x;
  }
  for (int i = 0; i < size; ++i) {
    const double diagonal = dense.row(i).cwiseAbs().sum() + 0.1 + value(random) * 0.05;
    // In two parts: duplicates are summed.
    entries.push_back({i, i, 0.25 * diagonal});
    entries.push_back({i, i, 0.75 * diagonal});
    dense(i, i) = 0.25 * diagonal + 0.75 * diagonal;
  }
  return {symmetric_from_entries(size, entries), dense};
}

}  // namespace unbruised::testing
