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

}  // namespace

DenseMatrix::DenseMatrix(std::size_t rows, std::size_t columns,
                         const std::function<double(std::size_t, std::size_t)>& entry)
    : rows_(rows), columns_(columns) {
  value_.reserve(rows * columns);
  for (std::size_t first = 0; first < rows; first += kRows) {
    const std::size_t end = std::min(rows, first + kRows);
    for (std::size_t k = 0; k < columns; ++k) {
      for (std::size_t r = first; r < end; ++r) value_.push_back(entry(r, k));
    }
  }
}

double DenseMatrix::at(std::size_t row, std::size_t column) const {
  const std::size_t first = row / kRows * kRows, height = std::min(kRows, rows_ - first);
  return panel(first)[column * height + row - first];
}

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

}  // namespace unbruised
