#include "core/algebra/lane_dense.hpp"

#include <algorithm>

#include "core/algebra/lane_solve_kernels.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

constexpr auto kRows = static_cast<std::size_t>(kPanelRows);

/// The rows of one panel, a pack of lanes.
template <class P, int Height>
void multiply_panel(const double* A, std::span<const int> columns, const double* x, double* y) {
  P acc[Height];
  for (int r = 0; r < Height; ++r) acc[r] = P(0.0);
  for (const int k : columns) {
    const P xk = P::load(kernels::row_of<kLanes>(x, k));
    const double* a = A + static_cast<std::size_t>(k) * Height;
    for (int r = 0; r < Height; ++r) acc[r] += P(a[r]) * xk;
  }
  for (int r = 0; r < Height; ++r) acc[r].store(kernels::row_of<kLanes>(y, r));
}

/// y += A x for the rows of one panel, or of two neighbouring ones.
template <class P, int First, int Second>
void add_panels(const float* A, std::size_t column_count, std::span<const int> columns, const float* x, float* y) {
  constexpr int kTwo = First + Second;
  constexpr std::size_t kAhead = 2 * kRows;
  const float* const A2 = A + First * column_count;
  P acc[kTwo];
  for (int r = 0; r < kTwo; ++r) acc[r] = P(0.0F);
  for (const int k : columns) {
    const P xk = P::load(kernels::row_of<kLanes>(x, k));
    const float* const a = A + static_cast<std::size_t>(k) * First;
    __builtin_prefetch(a + kAhead * column_count);
    for (int r = 0; r < First; ++r) acc[r] += P(a[r]) * xk;
    const float* const a2 = A2 + static_cast<std::size_t>(k) * Second;
    if constexpr (Second > 0) __builtin_prefetch(a2 + kAhead * column_count);
    for (int r = 0; r < Second; ++r) acc[First + r] += P(a2[r]) * xk;
  }
  for (int r = 0; r < kTwo; ++r) {
    float* const row = kernels::row_of<kLanes>(y, r);
    P sum = P::load(row);
    sum += acc[r];
    sum.store(row);
  }
}

}  // namespace

template <class Number>
DenseMatrixOf<Number>::DenseMatrixOf(std::size_t rows, std::size_t columns,
                                     const std::function<double(std::size_t, std::size_t)>& entry)
    : rows_(rows), columns_(columns) {
  value_.reserve(rows * columns);
  for (std::size_t first = 0; first < rows; first += kRows) {
    const std::size_t end = std::min(rows, first + kRows);
    for (std::size_t k = 0; k < columns; ++k) {
      for (std::size_t r = first; r < end; ++r) value_.push_back(static_cast<Number>(entry(r, k)));
    }
  }
}

template <class Number>
double DenseMatrixOf<Number>::at(std::size_t row, std::size_t column) const {
  const std::size_t first = row / kRows * kRows, height = std::min(kRows, rows_ - first);
  return static_cast<double>(panel(first)[column * height + row - first]);
}

template <class Number>
void DenseMatrixOf<Number>::put_columns(std::size_t first_column, std::size_t count, const LaneArray& lanes) {
  require(lanes.rows() == rows_ && count <= kLanes && first_column + count <= columns_,
          "DenseMatrix: columns of another matrix");
  for (std::size_t first = 0; first < rows_; first += kRows) {
    const std::size_t height = std::min(kRows, rows_ - first);
    Number* to = value_.data() + first * columns_ + first_column * height;
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t r = 0; r < height; ++r) *to++ = static_cast<Number>(lanes.row(first + r)[k]);
    }
  }
}

template class DenseMatrixOf<double>;
template class DenseMatrixOf<float>;

void multiply(const DenseMatrix& A, std::span<const int> columns, const LaneArray& x, const BusyPacks& lanes,
              LaneArray& y) {
  require(x.rows() == A.columns() && y.rows() == A.rows(), "multiply: vectors of another size than the matrix");
  lanes.with([&]<class P>(const Packs<P, kLanes>& packs) {
    for (std::size_t first = 0; first < A.rows(); first += kRows) {
      const std::size_t height = std::min(kRows, A.rows() - first);
      kernels::with_height(static_cast<int>(height), [&]<int H>() {
        packs.each([&](int lane) {
          multiply_panel<P, H>(A.panel(first), columns, x.data() + lane, y.row(first) + lane);
        });
      });
    }
  });
}

void add_product(const SingleMatrix& A, std::span<const int> columns, const SingleArray& x, const Mask& lanes,
                 SingleArray& y) {
  require(x.rows() == A.columns() && y.rows() == A.rows(), "add_product: vectors of another size than the matrix");
  with_single_packs(lanes, [&]<class P>(const Packs<P, kLanes>& packs) {
    kernels::each_panel<P>(
        static_cast<int>(A.rows()),
        [&]<int H>(int first) {
          packs.each([&](int lane) {
            add_panels<P, H, 0>(A.panel(static_cast<std::size_t>(first)), A.columns(), columns, x.row(0) + lane,
                                y.row(static_cast<std::size_t>(first)) + lane);
          });
        },
        [&]<int H>(int first) {
          packs.each([&](int lane) {
            add_panels<P, kPanelRows, H>(A.panel(static_cast<std::size_t>(first)), A.columns(), columns,
                                         x.row(0) + lane, y.row(static_cast<std::size_t>(first)) + lane);
          });
        });
  });
}

}  // namespace unbruised
