#include "core/algebra/lane_matrix.hpp"

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// acc += block x for one 3x3 block, all lanes.
inline void add_block(const double* block, const double* x, Lane (&acc)[3]) {
  const Lane x0 = load(x);
  const Lane x1 = load(x + kLanes);
  const Lane x2 = load(x + 2 * kLanes);
  for (int i = 0; i < 3; ++i) {
    acc[i] += Lane(block[3 * i]) * x0;
    acc[i] += Lane(block[3 * i + 1]) * x1;
    acc[i] += Lane(block[3 * i + 2]) * x2;
  }
}

/// Does a lane vector have the freedoms of the matrix?
bool fits(const BlockMatrix& A, const LaneArray& x) {
  return x.rows() == 3 * static_cast<std::size_t>(A.particle_count);
}

}  // namespace

void add_blocks(const double* row, std::span<const int> columns, const LaneArray& x, std::array<Lane, 3>& sum) {
  Lane acc[3] = {sum[0], sum[1], sum[2]};
  for (int j : columns) {
    const auto at = static_cast<std::size_t>(j);
    add_block(row + 9 * at, x.row(3 * at), acc);
  }
  for (std::size_t i = 0; i < 3; ++i) sum[i] = acc[i];
}

void multiply(const BlockMatrix& A, const LaneArray& x, LaneArray& y) {
  require(fits(A, x) && fits(A, y), "multiply: vectors of another size than the matrix");
  for (int row = 0; row < A.particle_count; ++row) {
    Lane acc[3] = {0.0, 0.0, 0.0};
    for (int p = A.row_start[row]; p < A.row_start[row + 1]; ++p) {
      add_block(A.value.data() + 9 * static_cast<std::size_t>(p), x.row(3 * static_cast<std::size_t>(A.column[p])),
                acc);
    }
    for (int i = 0; i < 3; ++i) y.put(3 * static_cast<std::size_t>(row) + i, acc[i]);
  }
}

void multiply_two(const BlockMatrix& A, const LaneArray& x1, const LaneArray& x2, LaneArray& y1, LaneArray& y2) {
  require(fits(A, x1) && fits(A, x2) && fits(A, y1) && fits(A, y2),
          "multiply_two: vectors of another size than the matrix");
  for (int row = 0; row < A.particle_count; ++row) {
    Lane acc1[3] = {0.0, 0.0, 0.0};
    Lane acc2[3] = {0.0, 0.0, 0.0};
    for (int p = A.row_start[row]; p < A.row_start[row + 1]; ++p) {
      const double* block = A.value.data() + 9 * static_cast<std::size_t>(p);
      const std::size_t column = 3 * static_cast<std::size_t>(A.column[p]);
      add_block(block, x1.row(column), acc1);
      add_block(block, x2.row(column), acc2);
    }
    for (int i = 0; i < 3; ++i) {
      y1.put(3 * static_cast<std::size_t>(row) + i, acc1[i]);
      y2.put(3 * static_cast<std::size_t>(row) + i, acc2[i]);
    }
  }
}

}  // namespace unbruised
