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

namespace unbruised {

/// A dense matrix in panels of `kPanelRows` rows, the last one shorter; within a panel column by column.
class DenseMatrix {
 public:
  DenseMatrix() = default;
  /// @param entry gives the entry in (row, column)
  DenseMatrix(std::size_t rows, std::size_t columns, const std::function<double(std::size_t, std::size_t)>& entry);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const;
  /// Of the panel whose first row is `row`.
  [[nodiscard]] const double* panel(std::size_t row) const { return value_.data() + row * columns_; }

 private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> value_;
};

/// y = A x, with rows of x that are not listed taken as zero. @param columns of A and rows of x, ascending
/// @param lanes that are asked for; what becomes of the others is not said
void multiply(const DenseMatrix& A, std::span<const int> columns, const LaneArray& x, const BusyPacks& lanes,
              LaneArray& y);

}  // namespace unbruised
