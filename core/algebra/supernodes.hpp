#pragma once

/// @file
/// Supernodes of a Cholesky factor, packed for solves in which every entry of L is read once for all lanes.

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace unbruised {

/// Rows of L are packed in panels of this many: a panel's accumulators for all lanes fit the registers.
inline constexpr int kPanelRows = 6;

/// Columns [first_column, first_column + column_count) of L with one common row pattern. The
/// diagonal block is a dense lower triangle; `row_count` rows follow below.
/// Packed values: panels of `kPanelRows` rows (the last one of a block shorter), within a panel column by column:
/// value[(panel offset) + column * panel_height + row]. First the panels of the diagonal block (with the
/// reciprocal on the diagonal), then those of the rows below.
struct Supernode {
  int first_column = 0;
  int column_count = 0;
  int row_count = 0;
  std::size_t row_offset = 0;    ///< into SupernodalFactor::row
  std::size_t value_offset = 0;  ///< into SupernodalFactor::value, diagonal block
  std::size_t below_offset = 0;  ///< into SupernodalFactor::value, rows below
  int parent = -1;               ///< supernode that holds the first row below; -1: root
};

/// Where the panel whose first row is `first` (a multiple of kPanelRows) begins in a diagonal block.
constexpr std::size_t diagonal_panel_offset(int first) {
  const auto panels = static_cast<std::size_t>(first / kPanelRows);
  return static_cast<std::size_t>(kPanelRows) * kPanelRows * panels * (panels + 1) / 2;
}

/// L of P A P' = L L', as supernodes in elimination order.
struct SupernodalFactor {
  int size = 0;
  std::vector<int> permutation;  ///< permutation[new] = old
  std::vector<Supernode> supernode;
  std::vector<int> row;  ///< rows below the diagonal blocks, elimination order
  std::vector<double> value;
  std::vector<float> single_value;  ///< the same rounded, where it is asked for
  std::size_t entry_count = 0;      ///< of L itself, without the zeros that amalgamation stores

  /// Flops of one solve (forward and backward) per right-hand side: 4 per stored off-diagonal entry.
  [[nodiscard]] double solve_flops() const;
  /// Asks for the rounded values.
  void round_values() { single_value.assign(value.begin(), value.end()); }
  /// From here on nobody solves but with these.
  void keep_rounded_values_only() { value = std::vector<double>(); }
};

/// The packed values in double or in single precision.
template <class Number>
const Number* values_of(const SupernodalFactor& factor) {
  if constexpr (std::is_same_v<Number, float>) {
    return factor.single_value.data();
  } else {
    return factor.value.data();
  }
}

/// Neighbouring columns of L whose patterns nest.
struct SupernodeRows {
  int first_column = 0;
  int column_count = 0;
  std::vector<int> below;  ///< rows below the last of the columns, ascending
};
using SupernodePattern = std::vector<SupernodeRows>;  ///< in elimination order

/// Merges a child into its parent where that stores few zeros, and gives all a place; the values are zero.
SupernodalFactor supernodes_of(SupernodePattern pattern, std::vector<int> permutation);

/// Elimination position of each freedom, -1 where it is fixed.
/// @param freedom number of each freedom in the factored matrix, -1 where it is fixed
std::vector<int> elimination_positions(const SupernodalFactor& factor, const std::vector<int>& freedom);

/// Supernodes on the paths from some elimination positions to the root, in elimination order: all that a
/// right-hand side supported there touches, and all that its own solution entries depend on backwards.
class Reach {
 public:
  /// @param factor has to outlive this
  explicit Reach(const SupernodalFactor& factor);
  [[nodiscard]] std::vector<int> of(const std::vector<int>& positions) const;

 private:
  const SupernodalFactor* factor_;
  std::vector<int> owner_;  ///< position -> supernode
};

}  // namespace unbruised
