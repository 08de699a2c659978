#include "core/algebra/sparse_cholesky.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <mutex>

#include <cholmod.h>

#include "core/door/require.hpp"

namespace unbruised {

SymmetricMatrix symmetric_from_entries(int size, const std::vector<MatrixEntry>& entries) {
  for (const MatrixEntry& entry : entries) {
    require(entry.row >= 0 && entry.row < size && entry.column >= 0 && entry.column < size,
            "symmetric_from_entries: an entry outside the matrix");
  }
  SymmetricMatrix matrix;
  matrix.size = size;
  // Counting sort by column, then a stable sort by row: duplicates stay in the order given.
  std::vector<int> start(static_cast<std::size_t>(size) + 1, 0);
  for (const auto& entry : entries) {
    if (entry.row >= entry.column) ++start[static_cast<std::size_t>(entry.column) + 1];
  }
  for (int column = 0; column < size; ++column) start[column + 1] += start[column];
  std::vector<MatrixEntry> sorted(static_cast<std::size_t>(start[size]));
  std::vector<int> next(start.begin(), start.end() - 1);
  for (const auto& entry : entries) {
    if (entry.row >= entry.column) sorted[static_cast<std::size_t>(next[entry.column]++)] = entry;
  }
  matrix.column_start.assign(static_cast<std::size_t>(size) + 1, 0);
  for (int column = 0; column < size; ++column) {
    auto first = sorted.begin() + start[column];
    auto last = sorted.begin() + start[column + 1];
    std::stable_sort(first, last, [](const MatrixEntry& a, const MatrixEntry& b) { return a.row < b.row; });
    for (auto it = first; it != last; ++it) {
      const bool repeats =
          matrix.column_start[column] < static_cast<int>(matrix.row.size()) && matrix.row.back() == it->row;
      if (repeats) {
        matrix.value.back() += it->value;
      } else {
        matrix.row.push_back(it->row);
        matrix.value.push_back(it->value);
      }
    }
    matrix.column_start[column + 1] = static_cast<int>(matrix.row.size());
  }
  return matrix;
}

void multiply(const SymmetricMatrix& matrix, std::span<const double> x, std::span<double> y) {
  std::fill(y.begin(), y.end(), 0.0);
  for (int column = 0; column < matrix.size; ++column) {
    for (int p = matrix.column_start[column]; p < matrix.column_start[column + 1]; ++p) {
      const int row = matrix.row[p];
      y[row] += matrix.value[p] * x[column];
      if (row != column) y[column] += matrix.value[p] * x[row];
    }
  }
}

std::string cholesky_library() {
  int version[3] = {0, 0, 0};
  cholmod_version(version);
  return "CHOLMOD " + std::to_string(version[0]) + "." + std::to_string(version[1]) + "." +
         std::to_string(version[2]);
}

namespace {

/// CHOLMOD's state and what it has analysed or factored.
struct Backend {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;

  Backend() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.final_asis = 0;
    common.final_ll = 1;
    common.final_pack = 1;
    common.final_monotonic = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NESDIS;
    common.postorder = 1;
    common.quick_return_if_not_posdef = 1;
  }
  ~Backend() {
    if (factor != nullptr) cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;
};

/// CHOLMOD's view of our matrix; borrows the arrays, which CHOLMOD only reads.
cholmod_sparse borrow(const SymmetricMatrix& matrix) {
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(matrix.size);
  view.ncol = view.nrow;
  view.nzmax = matrix.row.size();
  view.p = const_cast<int*>(matrix.column_start.data());
  view.i = const_cast<int*>(matrix.row.data());
  view.x = const_cast<double*>(matrix.value.data());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

/// The ordering draws from METIS' random numbers, which are one state of the whole process: two orderings at a
/// time would mix their draws, and the order, so the bits of the factor, would depend on the timing of threads.
cholmod_factor* analyze_alone(cholmod_sparse& matrix, cholmod_common& common) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  return cholmod_analyze(&matrix, &common);
}

void require_columns(const SymmetricMatrix& matrix) {
  require(matrix.size >= 0 && matrix.column_start.size() == static_cast<std::size_t>(matrix.size) + 1 &&
              matrix.row.size() == matrix.value.size(),
          "SparseCholesky: the columns are not those of such a matrix");
}

}  // namespace

struct SparseCholesky::Impl : Backend {};

std::vector<int> fill_reducing_order(const SymmetricMatrix& matrix) {
  require_columns(matrix);
  Backend impl;
  cholmod_sparse view = borrow(matrix);
  impl.factor = analyze_alone(view, impl.common);
  if (impl.factor == nullptr) return {};
  const int* permutation = static_cast<const int*>(impl.factor->Perm);
  return {permutation, permutation + impl.factor->n};
}

SparseCholesky::SparseCholesky() : impl_(std::make_unique<Impl>()) {}
SparseCholesky::~SparseCholesky() = default;

std::unique_ptr<SparseCholesky> SparseCholesky::factor(const SymmetricMatrix& matrix, std::string& error) {
  require_columns(matrix);
  std::unique_ptr<SparseCholesky> self(new SparseCholesky());
  Impl& impl = *self->impl_;
  cholmod_sparse view = borrow(matrix);
  impl.factor = analyze_alone(view, impl.common);
  if (impl.factor == nullptr) {
    error = "the factorisation ran out of memory";
    return nullptr;
  }
  cholmod_factorize(&view, impl.factor, &impl.common);
  if (impl.common.status == CHOLMOD_NOT_POSDEF || impl.factor->minor < impl.factor->n) {
    error = "the matrix is not positive definite (column " + std::to_string(impl.factor->minor) + " of " +
            std::to_string(impl.factor->n) + " of the elimination order)";
    return nullptr;
  }
  if (impl.common.status < CHOLMOD_OK) {
    error = "the factorisation ran out of memory";
    return nullptr;
  }
  return self;
}

std::vector<double> SparseCholesky::solve(std::span<const double> right_hand_side) {
  return solve_many(right_hand_side, 1);
}

std::vector<double> SparseCholesky::solve_many(std::span<const double> right_hand_sides, int count) {
  cholmod_dense b{};
  b.nrow = impl_->factor->n;
  b.ncol = static_cast<std::size_t>(count);
  b.nzmax = b.nrow * b.ncol;
  require(count > 0 && right_hand_sides.size() == b.nzmax,
          "SparseCholesky::solve: right-hand sides of another size than the matrix");
  b.d = b.nrow;
  b.x = const_cast<double*>(right_hand_sides.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, impl_->factor, &b, &impl_->common);
  if (x == nullptr) return {};
  std::vector<double> solution(b.nzmax);
  std::memcpy(solution.data(), x->x, b.nzmax * sizeof(double));
  cholmod_free_dense(&x, &impl_->common);
  return solution;
}

CholeskyFactor SparseCholesky::extract() const {
  const cholmod_factor& L = *impl_->factor;
  CholeskyFactor factor;
  factor.size = static_cast<int>(L.n);
  const int* permutation = static_cast<const int*>(L.Perm);
  const int* start = static_cast<const int*>(L.p);
  const int* count = static_cast<const int*>(L.nz);
  const int* row = static_cast<const int*>(L.i);
  const double* value = static_cast<const double*>(L.x);
  factor.permutation.assign(permutation, permutation + L.n);
  factor.column_start.push_back(0);
  for (std::size_t column = 0; column < L.n; ++column) {
    factor.row.insert(factor.row.end(), row + start[column], row + start[column] + count[column]);
    factor.value.insert(factor.value.end(), value + start[column], value + start[column] + count[column]);
    factor.column_start.push_back(static_cast<int>(factor.row.size()));
  }
  return factor;
}

}  // namespace unbruised
