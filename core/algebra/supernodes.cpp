#include "core/algebra/supernodes.hpp"

#include <algorithm>
#include <utility>

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Merging is worth it while the zeros it stores stay below this share of the merged block; reading a few zeros is
/// cheaper than another short block. Measured with benchmarks/lane_solve (flat optimum between 0.1 and 0.25).
constexpr double kZeroShare = 0.15;
/// Blocks up to this many columns are merged up to a larger share of zeros.
constexpr int kSmallColumns = 12;
constexpr double kSmallZeroShare = 0.4;

struct Block {
  SupernodeRows rows;
  double zeros = 0;  ///< stored zeros so far
};

double block_entries(double columns, double rows) { return columns * (columns + 1) / 2 + columns * rows; }

/// Merges `child` into the block right behind it when that is its parent and few zeros result.
bool merge_if_cheap(const Block& child, Block& parent) {
  const SupernodeRows &below = child.rows, &above = parent.rows;
  const bool adjacent = !below.below.empty() && below.first_column + below.column_count == above.first_column &&
                        below.below.front() < above.first_column + above.column_count;
  if (!adjacent) return false;
  const double columns = below.column_count + above.column_count;
  const double rows = static_cast<double>(above.below.size());
  const double real = block_entries(below.column_count, static_cast<double>(below.below.size())) - child.zeros +
                      block_entries(above.column_count, rows) - parent.zeros;
  const double stored = block_entries(columns, rows);
  const double share = columns <= kSmallColumns ? kSmallZeroShare : kZeroShare;
  if (stored - real > share * stored) return false;
  parent.rows.first_column = below.first_column;
  parent.rows.column_count = static_cast<int>(columns);
  parent.zeros = stored - real;
  return true;
}

std::vector<Block> amalgamate(SupernodePattern pattern) {
  // From the root downwards: a block may take in the block before it again and again.
  std::vector<Block> merged;
  for (std::size_t i = pattern.size(); i-- > 0;) {
    Block block{std::move(pattern[i]), 0.0};
    if (merged.empty() || !merge_if_cheap(block, merged.back())) merged.push_back(std::move(block));
  }
  std::reverse(merged.begin(), merged.end());
  return merged;
}

/// Values of the panels of a triangle.
std::size_t triangle_values(int columns) {
  const int last = (columns - 1) / kPanelRows * kPanelRows;  // where the last panel begins
  return diagonal_panel_offset(last) +
         static_cast<std::size_t>(columns) * static_cast<std::size_t>(columns - last);
}

}  // namespace

double SupernodalFactor::solve_flops() const {
  double flops = 0;
  for (const Supernode& s : supernode) {
    flops += 4.0 * block_entries(s.column_count, s.row_count) - 2.0 * s.column_count;
  }
  return flops;
}

SupernodalFactor supernodes_of(SupernodePattern pattern, std::vector<int> permutation) {
  SupernodalFactor factor;
  factor.size = static_cast<int>(permutation.size());
  factor.permutation = std::move(permutation);
  for (const SupernodeRows& rows : pattern) {
    factor.entry_count +=
        static_cast<std::size_t>(block_entries(rows.column_count, static_cast<double>(rows.below.size())));
  }
  std::vector<int> owner(static_cast<std::size_t>(factor.size), -1);  // column -> supernode
  std::size_t values = 0;
  for (const Block& block : amalgamate(std::move(pattern))) {
    Supernode node;
    node.first_column = block.rows.first_column;
    node.column_count = block.rows.column_count;
    node.row_count = static_cast<int>(block.rows.below.size());
    node.row_offset = factor.row.size();
    factor.row.insert(factor.row.end(), block.rows.below.begin(), block.rows.below.end());
    require(node.first_column >= 0 && node.first_column + node.column_count <= factor.size,
            "supernodes_of: columns that the permutation has not");
    std::fill_n(owner.begin() + node.first_column, node.column_count, static_cast<int>(factor.supernode.size()));
    node.value_offset = values;
    node.below_offset = values + triangle_values(node.column_count);
    values =
        node.below_offset + static_cast<std::size_t>(node.row_count) * static_cast<std::size_t>(node.column_count);
    factor.supernode.push_back(node);
  }
  factor.value.assign(values, 0.0);
  for (Supernode& s : factor.supernode) {
    if (s.row_count > 0) s.parent = owner[factor.row[s.row_offset]];
  }
  return factor;
}

std::vector<int> elimination_positions(const SupernodalFactor& factor, const std::vector<int>& freedom) {
  for (int number : freedom)
    require(number < factor.size, "elimination_positions: the factor has no such freedom");
  std::vector<int> position(static_cast<std::size_t>(factor.size));
  for (int k = 0; k < factor.size; ++k) position[factor.permutation[k]] = k;
  std::vector<int> slot(freedom.size(), -1);
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    if (freedom[i] >= 0) slot[i] = position[freedom[i]];
  }
  return slot;
}

Reach::Reach(const SupernodalFactor& factor) : factor_(&factor), owner_(static_cast<std::size_t>(factor.size)) {
  for (std::size_t s = 0; s < factor.supernode.size(); ++s) {
    for (int c = 0; c < factor.supernode[s].column_count; ++c) {
      owner_[static_cast<std::size_t>(factor.supernode[s].first_column + c)] = static_cast<int>(s);
    }
  }
}

std::vector<int> Reach::of(const std::vector<int>& positions) const {
  std::vector<bool> visited(factor_->supernode.size(), false);
  for (const int position : positions) {
    require(position >= 0 && position < factor_->size, "Reach: the factor has no such position");
    for (int s = owner_[static_cast<std::size_t>(position)]; s >= 0 && !visited[static_cast<std::size_t>(s)];
         s = factor_->supernode[static_cast<std::size_t>(s)].parent) {
      visited[static_cast<std::size_t>(s)] = true;
    }
  }
  std::vector<int> result;
  for (std::size_t s = 0; s < visited.size(); ++s) {
    if (visited[s]) result.push_back(static_cast<int>(s));
  }
  return result;
}

}  // namespace unbruised
