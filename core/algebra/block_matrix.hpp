#pragma once

/// @file
/// Symmetric sparse matrices of 3x3 blocks over particles, as K and C of the product are.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace unbruised {

/// A symmetric matrix of 3x3 blocks in compressed rows. Both triangles are stored, the columns of a row
/// ascend, and the diagonal block of every row is present even where it is zero.
struct BlockMatrix {
  int particle_count = 0;
  /// Size particle_count + 1; the blocks of row i are row_start[i] .. row_start[i + 1] - 1.
  std::vector<int> row_start;
  /// One column per block.
  std::vector<int> column;
  /// Nine values per block, row-major.
  std::vector<double> value;
};

/// Collects blocks in any order and sums those that meet in one place.
class BlockMatrixBuilder {
 public:
  explicit BlockMatrixBuilder(int particle_count);

  /// Adds `block` (row-major) in row i, column j. The mirror block (j, i) is the caller's to add.
  /// @throws std::out_of_range when i or j is not a particle.
  void add(int i, int j, const std::array<double, 9>& block);

  /// The matrix so far. Blocks of one place are summed in the order of their insertion, so that equal
  /// insertions give equal bits, and mirrored insertions a matrix that is symmetric to the bit.
  BlockMatrix build() const;

 private:
  struct Entry {
    int row;
    int column;
    std::array<double, 9> block;
  };

  /// Indices of the entries by row, then column, then insertion.
  std::vector<std::size_t> order_by_place() const;

  int particle_count_;
  std::vector<Entry> entry_;
};

/// y = A x for one vector, x and y of size 3 particle_count; the reference of the lane-parallel product.
/// @throws std::invalid_argument when a size does not fit.
void multiply(const BlockMatrix& matrix, std::span<const double> x, std::span<double> y);

}  // namespace unbruised
