#include "core/algebra/block_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace unbruised {

BlockMatrixBuilder::BlockMatrixBuilder(int particle_count) : particle_count_(particle_count) {
  if (particle_count < 0) throw std::invalid_argument("BlockMatrixBuilder: negative particle count");
  // The diagonal comes first: zero blocks, to which adding changes no bit.
  entry_.reserve(static_cast<std::size_t>(particle_count));
  for (int i = 0; i < particle_count; ++i) entry_.push_back({i, i, {}});
}

void BlockMatrixBuilder::add(int i, int j, const std::array<double, 9>& block) {
  if (i < 0 || j < 0 || i >= particle_count_ || j >= particle_count_) {
    throw std::out_of_range("BlockMatrixBuilder::add: no such particle");
  }
  entry_.push_back({i, j, block});
}

std::vector<std::size_t> BlockMatrixBuilder::order_by_place() const {
  std::vector<std::size_t> row_end(static_cast<std::size_t>(particle_count_) + 1, 0);
  for (const Entry& entry : entry_) ++row_end[static_cast<std::size_t>(entry.row) + 1];
  std::partial_sum(row_end.begin(), row_end.end(), row_end.begin());
  // row_end[i] is the start of row i until its entries have been dealt out.
  std::vector<std::size_t> order(entry_.size());
  for (std::size_t index = 0; index < entry_.size(); ++index) order[row_end[entry_[index].row]++] = index;

  std::size_t start = 0;
  for (int i = 0; i < particle_count_; ++i) {
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(start);
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(row_end[i]);
    std::stable_sort(begin, end,
                     [this](std::size_t p, std::size_t q) { return entry_[p].column < entry_[q].column; });
    start = row_end[i];
  }
  return order;
}

BlockMatrix BlockMatrixBuilder::build() const {
  BlockMatrix matrix;
  matrix.particle_count = particle_count_;
  matrix.row_start.assign(static_cast<std::size_t>(particle_count_) + 1, 0);
  const Entry* previous = nullptr;
  for (const std::size_t index : order_by_place()) {
    const Entry& entry = entry_[index];
    if (!previous || previous->row != entry.row || previous->column != entry.column) {
      matrix.column.push_back(entry.column);
      matrix.value.resize(matrix.value.size() + 9, 0.0);
      ++matrix.row_start[static_cast<std::size_t>(entry.row) + 1];
    }
    double* sum = matrix.value.data() + matrix.value.size() - 9;
    for (std::size_t k = 0; k < 9; ++k) sum[k] += entry.block[k];
    previous = &entry;
  }
  std::partial_sum(matrix.row_start.begin(), matrix.row_start.end(), matrix.row_start.begin());
  return matrix;
}

void multiply(const BlockMatrix& matrix, std::span<const double> x, std::span<double> y) {
  const std::size_t freedoms = 3 * static_cast<std::size_t>(matrix.particle_count);
  if (x.size() != freedoms || y.size() != freedoms) throw std::invalid_argument("multiply: vector size");
  for (int i = 0; i < matrix.particle_count; ++i) {
    std::array<double, 3> sum{};
    for (int block = matrix.row_start[i]; block < matrix.row_start[i + 1]; ++block) {
      const double* a = matrix.value.data() + 9 * static_cast<std::size_t>(block);
      const double* xj = x.data() + 3 * static_cast<std::size_t>(matrix.column[block]);
      for (std::size_t r = 0; r < 3; ++r) sum[r] += a[3 * r] * xj[0] + a[3 * r + 1] * xj[1] + a[3 * r + 2] * xj[2];
    }
    std::copy(sum.begin(), sum.end(), y.begin() + 3 * static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace unbruised
