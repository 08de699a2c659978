#include "core/algebra/lane_matrix.hpp"

#include <algorithm>

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

/// How many rows of blocks have their sums in registers at once, beside one x and one entry of a block.
template <class P>
constexpr std::size_t rows_at_once() {
  constexpr int kRegisters = sizeof(typename P::Native) == 64 ? 32 : 16;
  return (3 * 4 + 1) * P::kParts + 1 <= kRegisters ? 4 : 2;
}

/// sums += the blocks of `Rows` rows over the listed columns times x, a pack of lanes. Each x is loaded once.
template <std::size_t Rows, class P>
void add_rows(const double* const* rows, std::span<const int> columns, const LaneArray& x, int lane,
              std::array<Lane, 3>* sums) {
  P acc[Rows][3];
#pragma GCC unroll 4  // so that they stay in registers
  for (std::size_t r = 0; r < Rows; ++r) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) acc[r][i] = pack_of<P>(sums[r][i], lane);
  }
  for (const int j : columns) {
    const auto at = static_cast<std::size_t>(j);
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
      const P xk = P::load(x.row(3 * at + k) + lane);
#pragma GCC unroll 4
      for (std::size_t r = 0; r < Rows; ++r) {
        const double* block = rows[r] + 9 * at + k;
#pragma GCC unroll 3
        for (std::size_t i = 0; i < 3; ++i) acc[r][i] += P(block[3 * i]) * xk;
      }
    }
  }
#pragma GCC unroll 4
  for (std::size_t r = 0; r < Rows; ++r) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) put_pack_of(sums[r][i], acc[r][i], lane);
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

/// One row of blocks of A x1, a pack of lanes, and its share of x2' A x2: what lies right of the diagonal counts
/// twice.
template <class P>
void multiply_row_and_form(const BlockMatrix& A, int row, const double* x1, const double* x2, double* y, P& form) {
  P acc[3] = {0.0, 0.0, 0.0}, own[3] = {0.0, 0.0, 0.0}, right[3] = {0.0, 0.0, 0.0};
  const auto column_of = [&](int p) { return 3 * kLanes * static_cast<std::size_t>(A.column[p]); };
  const auto block_of = [&](int p) { return A.value.data() + 9 * static_cast<std::size_t>(p); };
  int p = A.row_start[row];
  for (; A.column[p] < row; ++p) add_block(block_of(p), x1 + column_of(p), acc);
  add_block(block_of(p), x1 + column_of(p), acc);
  add_block(block_of(p), x2 + column_of(p), own);
  for (++p; p < A.row_start[row + 1]; ++p) {
    add_block(block_of(p), x1 + column_of(p), acc);
    add_block(block_of(p), x2 + column_of(p), right);
  }
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = kLanes * (3 * static_cast<std::size_t>(row) + i);
    acc[i].store(y + at);
    form += P::load(x2 + at) * (own[i] + (right[i] + right[i]));
  }
}

/// Does a lane vector have the freedoms of the matrix?
bool fits(const BlockMatrix& A, const LaneArray& x) {
  return x.rows() == 3 * static_cast<std::size_t>(A.particle_count);
}

}  // namespace

void add_blocks(std::span<const double* const> rows, std::span<const int> columns, const LaneArray& x,
                const BusyPacks& lanes, std::span<std::array<Lane, 3>> sums) {
  require(rows.size() == sums.size(), "add_blocks: a sum for each row");
  lanes.with([&]<class P>(const Packs<P, kLanes>& packs) {
    constexpr std::size_t kAtOnce = rows_at_once<P>();
    for (std::size_t done = 0; done < rows.size();) {
      const std::size_t left = rows.size() - done;
      packs.each([&](int lane) {
        const double* const* from = rows.data() + done;
        std::array<Lane, 3>* to = sums.data() + done;
        if (left >= kAtOnce) return add_rows<kAtOnce, P>(from, columns, x, lane, to);
        if constexpr (kAtOnce == 4) {
          if (left == 3) return add_rows<3, P>(from, columns, x, lane, to);
          if (left == 2) return add_rows<2, P>(from, columns, x, lane, to);
        }
        add_rows<1, P>(from, columns, x, lane, to);
      });
      done += std::min<std::size_t>(left, kAtOnce);
    }
  });
}

void subtract_product(std::span<const double> A, std::size_t n, std::span<const int> rows,
                      std::span<const int> columns, const LaneArray& x, const Mask& lanes, LaneArray& y) {
  constexpr std::size_t kAtOnce = 4;  // which one pass over x serves
  require(A.size() == 9 * n * n && x.rows() == 3 * n && y.rows() == 3 * n,
          "subtract_product: vectors of another size than the matrix");
  const BusyPacks busy(lanes);
  for (std::size_t done = 0; done < rows.size(); done += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, rows.size() - done);
    std::array<const double*, kAtOnce> row{};
    std::array<std::array<Lane, 3>, kAtOnce> sum;
    for (std::size_t r = 0; r < count; ++r) {
      row[r] = A.data() + 9 * static_cast<std::size_t>(rows[done + r]) * n;
      sum[r].fill(Lane(0.0));
    }
    add_blocks({row.data(), count}, columns, x, busy, {sum.data(), count});
    for (std::size_t r = 0; r < count; ++r) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = 3 * static_cast<std::size_t>(rows[done + r]) + axis;
        y.put(at, select(lanes, y.get(at) - sum[r][axis], y.get(at)));
      }
    }
  }
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

void multiply_and_form(const BlockMatrix& A, const LaneArray& x1, const LaneArray& x2, LaneArray& y, Lane& form,
                       const Mask& lanes) {
  require(fits(A, x1) && fits(A, x2) && fits(A, y), "multiply_and_form: vectors of another size than the matrix");
  form = Lane(0.0);
  with_packs(lanes, [&]<class P>(const Packs<P, kLanes>& packs) {
    for (int row = 0; row < A.particle_count; ++row) {
      packs.each([&](int lane) {
        P sum = pack_of<P>(form, lane);
        multiply_row_and_form<P>(A, row, x1.data() + lane, x2.data() + lane, y.data() + lane, sum);
        put_pack_of(form, sum, lane);
      });
    }
  });
}

}  // namespace unbruised
