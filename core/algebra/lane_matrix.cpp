#include "core/algebra/lane_matrix.hpp"

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// acc += block x for one 3x3 block, a pack of lanes.
template <class P>
[[gnu::always_inline]] inline void add_block(const double* block, const double* x, P (&acc)[3]) {
  const P x0 = P::load(x);
  const P x1 = P::load(x + kLanes);
  const P x2 = P::load(x + 2 * kLanes);
  for (int i = 0; i < 3; ++i) {
    acc[i] += P(block[3 * i]) * x0;
    acc[i] += P(block[3 * i + 1]) * x1;
    acc[i] += P(block[3 * i + 2]) * x2;
  }
}

/// One row of blocks of both products, a pack of lanes.
template <class P>
void multiply_row(const BlockMatrix& A, int row, const double* x1, const double* x2, double* y1, double* y2) {
  P acc1[3] = {0.0, 0.0, 0.0};
  P acc2[3] = {0.0, 0.0, 0.0};
  for (int p = A.row_start[row]; p < A.row_start[row + 1]; ++p) {
    const double* block = A.value.data() + 9 * static_cast<std::size_t>(p);
    const std::size_t column = 3 * kLanes * static_cast<std::size_t>(A.column[p]);
    add_block(block, x1 + column, acc1);
    add_block(block, x2 + column, acc2);
  }
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = kLanes * (3 * static_cast<std::size_t>(row) + i);
    acc1[i].store(y1 + at);
    acc2[i].store(y2 + at);
  }
}

/// Does a lane vector have the freedoms of the matrix?
bool fits(const BlockMatrix& A, const LaneArray& x) {
  return x.rows() == 3 * static_cast<std::size_t>(A.particle_count);
}

}  // namespace

void add_blocks(const double* row, std::span<const int> columns, const LaneArray& x, const BusyPacks& lanes,
                std::array<Lane, 3>& sum) {
  alignas(kLaneAlignment) double sums[3 * kLanes];
  for (std::size_t i = 0; i < 3; ++i) sum[i].store(sums + i * kLanes);
  lanes.with([&]<class P>(const Packs<P, kLanes>& packs) {
    packs.each([&](int lane) {
      P acc[3];
      for (int i = 0; i < 3; ++i) acc[i] = P::load(sums + i * kLanes + lane);
      for (int j : columns) {
        const auto at = static_cast<std::size_t>(j);
        add_block(row + 9 * at, x.row(3 * at) + lane, acc);
      }
      for (int i = 0; i < 3; ++i) acc[i].store(sums + i * kLanes + lane);
    });
  });
  for (std::size_t i = 0; i < 3; ++i) sum[i] = Lane::load(sums + i * kLanes);
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

void multiply_two(const BlockMatrix& A, const LaneArray& x1, const LaneArray& x2, LaneArray& y1, LaneArray& y2,
                  const Mask& lanes) {
  require(fits(A, x1) && fits(A, x2) && fits(A, y1) && fits(A, y2),
          "multiply_two: vectors of another size than the matrix");
  with_packs(lanes, [&]<class P>(const Packs<P, kLanes>& packs) {
    for (int row = 0; row < A.particle_count; ++row) {
      packs.each([&](int lane) {
        multiply_row<P>(A, row, x1.data() + lane, x2.data() + lane, y1.data() + lane, y2.data() + lane);
      });
    }
  });
}

}  // namespace unbruised
