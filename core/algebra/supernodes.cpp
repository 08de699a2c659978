#include "core/algebra/supernodes.hpp"

#include <algorithm>
#include <cassert>

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
  int first = 0;
  int count = 0;
  std::vector<int> below;
  double zeros = 0;  ///< stored zeros so far
};

double block_entries(double columns, double rows) { return columns * (columns + 1) / 2 + columns * rows; }

/// Fundamental supernodes: runs of columns whose patterns nest exactly.
std::vector<Block> fundamental_blocks(const CholeskyFactor& L) {
  std::vector<Block> blocks;
  auto count = [&](int column) { return L.column_start[column + 1] - L.column_start[column]; };
  for (int column = 0; column < L.size; ++column) {
    const bool continues = !blocks.empty() && count(column - 1) == count(column) + 1 &&
                           L.row[L.column_start[column - 1] + 1] == column;
    if (!continues) blocks.push_back({column, 0, {}, 0});
    ++blocks.back().count;
    blocks.back().below.assign(L.row.begin() + L.column_start[column] + 1,
                               L.row.begin() + L.column_start[column + 1]);
  }
  return blocks;
}

/// Merges `child` into the block right behind it when that is its parent and few zeros result.
bool merge_if_cheap(const Block& child, Block& parent) {
  const bool adjacent = !child.below.empty() && child.first + child.count == parent.first &&
                        child.below.front() < parent.first + parent.count;
  if (!adjacent) return false;
  const double columns = child.count + parent.count;
  const double rows = static_cast<double>(parent.below.size());
  const double real = block_entries(child.count, static_cast<double>(child.below.size())) - child.zeros +
                      block_entries(parent.count, rows) - parent.zeros;
  const double stored = block_entries(columns, rows);
  const double share = columns <= kSmallColumns ? kSmallZeroShare : kZeroShare;
  if (stored - real > share * stored) return false;
  parent.first = child.first;
  parent.count = static_cast<int>(columns);
  parent.zeros = stored - real;
  return true;
}

std::vector<Block> amalgamate(std::vector<Block> blocks) {
  // From the root downwards: a block may take in the block before it again and again.
  std::vector<Block> merged;
  for (std::size_t i = blocks.size(); i-- > 0;) {
    if (merged.empty() || !merge_if_cheap(blocks[i], merged.back())) merged.push_back(std::move(blocks[i]));
  }
  std::reverse(merged.begin(), merged.end());
  return merged;
}

/// Where the panels of a block end.
enum class BlockShape {
  triangle,   ///< at its diagonal
  rectangle,  ///< at its last column
};

/// Writes a block's dense rows, `dense` row-major [rows, columns], as panels.
void pack_panels(const std::vector<double>& dense, int rows, int columns, BlockShape shape,
                 std::vector<double>& out) {
  for (int first = 0; first < rows; first += kPanelRows) {
    const int height = std::min(kPanelRows, rows - first);
    const int width = shape == BlockShape::triangle ? first + height : columns;
    for (int column = 0; column < width; ++column) {
      for (int row = 0; row < height; ++row) {
        out.push_back(dense[static_cast<std::size_t>(first + row) * columns + column]);
      }
    }
  }
}

}  // namespace

double SupernodalFactor::solve_flops() const {
  double flops = 0;
  for (const Supernode& s : supernode) {
    flops += 4.0 * block_entries(s.column_count, s.row_count) - 2.0 * s.column_count;
  }
  return flops;
}

SupernodalFactor pack_supernodes(const CholeskyFactor& L) {
  const auto size = static_cast<std::size_t>(L.size);
  require(L.permutation.size() == size && L.column_start.size() == size + 1 && L.row.size() == L.value.size(),
          "pack_supernodes: the columns are not those of such a factor");
  SupernodalFactor packed;
  packed.size = L.size;
  packed.permutation = L.permutation;
  packed.entry_count = L.value.size();
  std::vector<int> place(static_cast<std::size_t>(L.size), -1);  // row -> position in the block
  std::vector<int> owner(static_cast<std::size_t>(L.size), -1);  // column -> supernode
  for (const Block& block : amalgamate(fundamental_blocks(L))) {
    Supernode node;
    node.first_column = block.first;
    node.column_count = block.count;
    node.row_count = static_cast<int>(block.below.size());
    node.row_offset = packed.row.size();
    packed.row.insert(packed.row.end(), block.below.begin(), block.below.end());
    for (int c = 0; c < block.count; ++c) {
      place[block.first + c] = c;
      owner[block.first + c] = static_cast<int>(packed.supernode.size());
    }
    for (int r = 0; r < node.row_count; ++r) place[block.below[r]] = block.count + r;
    const auto columns = static_cast<std::size_t>(block.count);
    std::vector<double> diagonal(columns * columns, 0.0);
    std::vector<double> below(static_cast<std::size_t>(node.row_count) * columns, 0.0);
    for (int c = 0; c < block.count; ++c) {
      const int column = block.first + c;
      for (int p = L.column_start[column]; p < L.column_start[column + 1]; ++p) {
        const int at = place[L.row[p]];
        assert(at >= c);
        if (at < block.count) {
          diagonal[at * columns + c] = at == c ? 1.0 / L.value[p] : L.value[p];
        } else {
          below[(at - block.count) * columns + c] = L.value[p];
        }
      }
    }
    node.value_offset = packed.value.size();
    pack_panels(diagonal, block.count, block.count, BlockShape::triangle, packed.value);
    node.below_offset = packed.value.size();
    pack_panels(below, node.row_count, block.count, BlockShape::rectangle, packed.value);
    packed.supernode.push_back(node);
  }
  for (Supernode& s : packed.supernode) {
    if (s.row_count > 0) s.parent = owner[packed.row[s.row_offset]];
  }
  return packed;
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
