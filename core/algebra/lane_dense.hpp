#pragma once

/// @file
/// Products of a dense matrix, shared by all lanes, with lane vectors.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/algebra/supernodes.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_packs.hpp"
#include "core/lanes/single_lanes.hpp"

namespace unbruised {

/// A dense matrix in panels of `kPanelRows` rows, the last one shorter; within a panel column by column.
/// @tparam Number double or float
template <class Number>
class DenseMatrixOf {
 public:
  DenseMatrixOf() = default;
  /// All zero.
  DenseMatrixOf(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), value_(rows * columns, Number(0)) {}
  /// @param entry gives the entry in (row, column)
  DenseMatrixOf(std::size_t rows, std::size_t columns,
                const std::function<double(std::size_t, std::size_t)>& entry);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] bool empty() const { return value_.empty(); }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const;
  /// Makes columns of the first lanes. @param first column @param count of columns, at most kLanes
  void put_columns(std::size_t first, std::size_t count, const LaneArray& lanes);
  /// Of the panel whose first row is `row`.
  [[nodiscard]] const Number* panel(std::size_t row) const { return value_.data() + row * columns_; }

 private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<Number> value_;
};
using DenseMatrix = DenseMatrixOf<double>;
using SingleMatrix = DenseMatrixOf<float>;

/// y = A x, with rows of x that are not listed taken as zero. @param columns of A and rows of x, ascending
/// @param lanes that are asked for; what becomes of the others is not said
void multiply(const DenseMatrix& A, std::span<const int> columns, const LaneArray& x, const BusyPacks& lanes,
              LaneArray& y);
/// y += A x, the sum over the columns first.
void add_product(const SingleMatrix& A, std::span<const int> columns, const SingleArray& x, const Mask& lanes,
                 SingleArray& y);

}  // namespace unbruised
