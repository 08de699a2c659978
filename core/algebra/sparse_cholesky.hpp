#pragma once

/// @file
/// Sparse symmetric matrices, and the door to CHOLMOD: the order of elimination that fills L least, and its own
/// simplicial factorisation, with which tests and benchmarks compare ours (supernodal_cholesky.hpp).

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace unbruised {

/// Lower triangle of a symmetric matrix in compressed columns, rows sorted within a column.
struct SymmetricMatrix {
  int size = 0;
  std::vector<int> column_start;  ///< size + 1
  std::vector<int> row;
  std::vector<double> value;
};

/// One entry of a matrix under assembly.
struct MatrixEntry {
  int row;
  int column;
  double value;
};

/// Sums duplicates in the order given; entries above the diagonal are ignored.
SymmetricMatrix symmetric_from_entries(int size, const std::vector<MatrixEntry>& entries);

/// y = A x.
void multiply(const SymmetricMatrix& matrix, std::span<const double> x, std::span<double> y);

/// The factor L of P A P' = L L' in compressed columns, diagonal entry first in each column.
struct CholeskyFactor {
  int size = 0;
  std::vector<int> permutation;  ///< permutation[new] = old
  std::vector<int> column_start;
  std::vector<int> row;
  std::vector<double> value;
};

/// The library that orders, with its version: the bits of a factor depend on it.
std::string cholesky_library();

/// Nested dissection, postordered: permutation[new] = old; empty when memory is short. The same whatever other
/// threads order at the time.
std::vector<int> fill_reducing_order(const SymmetricMatrix& matrix);

/// CHOLMOD's own factorisation in that order.
class SparseCholesky {
 public:
  /// @return nullptr with `error` set when the matrix is not positive definite or memory is short.
  static std::unique_ptr<SparseCholesky> factor(const SymmetricMatrix& matrix, std::string& error);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Solves A x = b for one right-hand side, x of shape [size]; empty when memory is short. Not const: the backend
  /// writes into its workspace. What threads share is the packed factor (supernodes.hpp).
  [[nodiscard]] std::vector<double> solve(std::span<const double> right_hand_side);

  /// Solves A X = B for `count` right-hand sides, column-major [size, count]; empty when memory is short.
  [[nodiscard]] std::vector<double> solve_many(std::span<const double> right_hand_sides, int count);

  /// A copy of L and its ordering.
  [[nodiscard]] CholeskyFactor extract() const;

 private:
  SparseCholesky();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unbruised
