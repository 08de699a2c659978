#include "core/algebra/supernodal_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Columns of a front that are eliminated before the rest of it hears of them.
constexpr int kFrontColumns = 8;

/// The lower triangle of P A P' by columns, rows in any order.
struct PermutedMatrix {
  std::vector<int> column_start, row;
  std::vector<double> value;
};

PermutedMatrix permuted(const SymmetricMatrix& matrix, const std::vector<int>& permutation) {
  const auto size = static_cast<std::size_t>(matrix.size);
  std::vector<int> position(size);
  for (std::size_t k = 0; k < size; ++k) position[static_cast<std::size_t>(permutation[k])] = static_cast<int>(k);
  PermutedMatrix out;
  out.column_start.assign(size + 1, 0);
  const auto each_entry = [&](auto&& take) {
    for (int column = 0; column < matrix.size; ++column) {
      for (int p = matrix.column_start[column]; p < matrix.column_start[column + 1]; ++p)
        take(std::minmax(position[matrix.row[p]], position[column]), matrix.value[p]);
    }
  };
  each_entry([&](std::pair<int, int> at, double) { ++out.column_start[at.first + 1]; });
  for (std::size_t column = 0; column < size; ++column) out.column_start[column + 1] += out.column_start[column];
  out.row.resize(matrix.row.size());
  out.value.resize(matrix.row.size());
  std::vector<int> next(out.column_start.begin(), out.column_start.end() - 1);
  each_entry([&](std::pair<int, int> at, double value) {
    const int to = next[at.first]++;
    out.row[to] = at.second;
    out.value[to] = value;
  });
  return out;
}

/// Patterns of L as supernodes: a column's rows are those of A and of the children whose first row below it is.
SupernodePattern pattern_of(const PermutedMatrix& A, int size) {
  SupernodePattern pattern;
  std::vector<std::vector<std::size_t>> children(
      static_cast<std::size_t>(size));  // blocks by their parent's column
  std::vector<int> seen(static_cast<std::size_t>(size), -1);
  std::vector<int> rows;
  for (int column = 0; column < size; ++column) {
    rows.clear();
    const auto take = [&](int row) {
      if (row > column && seen[row] != column) {
        seen[row] = column;
        rows.push_back(row);
      }
    };
    for (int p = A.column_start[column]; p < A.column_start[column + 1]; ++p) take(A.row[p]);
    for (const std::size_t child : children[column]) {
      for (const int row : pattern[child].below) take(row);
    }
    if (!pattern.empty()) {
      SupernodeRows& last = pattern.back();
      const bool continues =
          !last.below.empty() && last.below.front() == column && last.below.size() == rows.size() + 1;
      if (continues) {
        ++last.column_count;
        last.below.erase(last.below.begin());
        if (!last.below.empty()) children[last.below.front()].push_back(pattern.size() - 1);
        continue;
      }
    }
    std::ranges::sort(rows);
    if (!rows.empty()) children[rows.front()].push_back(pattern.size());
    pattern.push_back({column, 1, rows});
  }
  return pattern;
}

/// A supernode's columns and the rows below them as a dense lower triangle, column-major.
class Front {
 public:
  explicit Front(std::size_t size) : place_(size, 0) {}

  void begin(const Supernode& node, const int* rows) {
    node_ = &node;
    height_ = static_cast<std::size_t>(node.column_count + node.row_count);
    value_.assign(height_ * height_, 0.0);
    for (int c = 0; c < node.column_count; ++c) place_[node.first_column + c] = c;
    for (int r = 0; r < node.row_count; ++r) place_[rows[r]] = node.column_count + r;
  }
  void add(const PermutedMatrix& A) {
    for (int c = 0; c < node_->column_count; ++c) {
      double* to = column(static_cast<std::size_t>(c));
      for (int p = A.column_start[node_->first_column + c]; p < A.column_start[node_->first_column + c + 1]; ++p)
        to[place_[A.row[p]]] += A.value[p];
    }
  }
  /// What a child leaves for its rows.
  void add(const std::vector<double>& update, const int* rows, int count) {
    for (int c = 0; c < count; ++c) {
      double* to = column(static_cast<std::size_t>(place_[rows[c]]));
      const double* from = update.data() + static_cast<std::size_t>(c) * count;
      for (int r = c; r < count; ++r) to[place_[rows[r]]] += from[r];
    }
  }
  /// @return the column without a positive pivot; the number of columns: all have one
  int eliminate() {
    for (int first = 0; first < node_->column_count; first += kFrontColumns) {
      const int end = std::min(first + kFrontColumns, node_->column_count);
      for (int c = first; c < end; ++c) {
        for (int k = first; k < c; ++k) subtract<1>(k, c);
        double* own = column(static_cast<std::size_t>(c));
        if (!(own[c] > 0.0)) return c;
        const double root = std::sqrt(own[c]);
        own[c] = root;
        for (std::size_t r = static_cast<std::size_t>(c) + 1; r < height_; ++r) own[r] /= root;
      }
      const int columns = static_cast<int>(height_);
      if (end - first == kFrontColumns) {
        for (int c = end; c < columns; ++c) subtract<kFrontColumns>(first, c);
      } else {
        for (int k = first; k < end; ++k) {
          for (int c = end; c < columns; ++c) subtract<1>(k, c);
        }
      }
    }
    return node_->column_count;
  }
  /// Panels with the reciprocals of the diagonal.
  void pack(double* diagonal, double* below) const {
    const int columns = node_->column_count;
    for (int first = 0; first < columns; first += kPanelRows) {
      const int rows = std::min(kPanelRows, columns - first);
      for (int c = 0; c < first + rows; ++c) {
        for (int r = first; r < first + rows; ++r) *diagonal++ = r > c ? at(r, c) : r == c ? 1.0 / at(r, c) : 0.0;
      }
    }
    for (int first = 0; first < node_->row_count; first += kPanelRows) {
      const int rows = std::min(kPanelRows, node_->row_count - first);
      for (int c = 0; c < columns; ++c) {
        for (int r = first; r < first + rows; ++r) *below++ = at(columns + r, c);
      }
    }
  }
  /// What is left for the rows below, [rows, rows], lower triangle.
  [[nodiscard]] std::vector<double> rest() const {
    const auto rows = static_cast<std::size_t>(node_->row_count);
    const auto columns = static_cast<std::size_t>(node_->column_count);
    std::vector<double> out(rows * rows);
    for (std::size_t c = 0; c < rows; ++c) {
      const double* from = value_.data() + (columns + c) * height_ + columns;
      std::copy(from + c, from + rows, out.begin() + static_cast<std::ptrdiff_t>(c * rows + c));
    }
    return out;
  }

 private:
  [[nodiscard]] double* column(std::size_t c) { return value_.data() + c * height_; }
  [[nodiscard]] double at(int row, int c) const {
    return value_[static_cast<std::size_t>(c) * height_ + static_cast<std::size_t>(row)];
  }
  /// Column c loses what `Count` columns from k on have in its rows.
  template <int Count>
  void subtract(int k, int c) {
    const auto from_row = static_cast<std::size_t>(c);
    double* const to = column(from_row);
    const double* from[Count];
    double share[Count];
    for (int i = 0; i < Count; ++i) {
      from[i] = column(static_cast<std::size_t>(k + i));
      share[i] = from[i][c];
    }
#pragma omp simd
    for (std::size_t r = from_row; r < height_; ++r) {
      double x = to[r];
      for (int i = 0; i < Count; ++i) x -= from[i][r] * share[i];
      to[r] = x;
    }
  }

  const Supernode* node_ = nullptr;
  std::size_t height_ = 0;
  std::vector<double> value_;
  std::vector<int> place_;  ///< of a row in the front
};

/// @return the first column without a positive pivot; the size: L is there
int fill(const PermutedMatrix& A, SupernodalFactor& L) {
  Front front(static_cast<std::size_t>(L.size));
  std::vector<std::vector<double>> rest(L.supernode.size());
  std::vector<std::vector<std::size_t>> children(L.supernode.size());
  for (std::size_t s = 0; s < L.supernode.size(); ++s) {
    const Supernode& node = L.supernode[s];
    front.begin(node, L.row.data() + node.row_offset);
    front.add(A);
    for (const std::size_t child : children[s]) {
      front.add(rest[child], L.row.data() + L.supernode[child].row_offset, L.supernode[child].row_count);
      rest[child] = {};
    }
    const int column = front.eliminate();
    if (column < node.column_count) return node.first_column + column;
    front.pack(L.value.data() + node.value_offset, L.value.data() + node.below_offset);
    if (node.parent < 0) continue;
    rest[s] = front.rest();
    children[static_cast<std::size_t>(node.parent)].push_back(s);
  }
  return L.size;
}

std::optional<SupernodalFactor> factor_in_order(const SymmetricMatrix& matrix, const std::vector<int>& permutation,
                                                std::string& error) {
  const PermutedMatrix A = permuted(matrix, permutation);
  SupernodalFactor L = supernodes_of(pattern_of(A, matrix.size), permutation);
  const int column = fill(A, L);
  if (column < L.size) {
    error = "the matrix is not positive definite (column " + std::to_string(column) + " of " +
            std::to_string(L.size) + " of the elimination order)";
    return std::nullopt;
  }
  return L;
}

}  // namespace

std::optional<SupernodalFactor> factor_supernodes(const SymmetricMatrix& matrix, std::string& error) {
  const std::vector<int> permutation = fill_reducing_order(matrix);
  if (static_cast<int>(permutation.size()) != matrix.size) {
    error = "the factorisation ran out of memory";
    return std::nullopt;
  }
  return factor_in_order(matrix, permutation, error);
}

std::optional<SupernodalFactor> factor_as_it_stands(const SymmetricMatrix& matrix, std::string& error) {
  std::vector<int> permutation(static_cast<std::size_t>(matrix.size));
  std::iota(permutation.begin(), permutation.end(), 0);
  return factor_in_order(matrix, permutation, error);
}

}  // namespace unbruised
