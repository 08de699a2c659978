#pragma once

/// @file
/// Products of a block matrix, shared by all lanes, with lane vectors of shape [3 x particles, kLanes].

#include <array>
#include <span>

#include "core/algebra/block_matrix.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_packs.hpp"

namespace unbruised {

/// y = A x.
void multiply(const BlockMatrix& A, const LaneArray& x, LaneArray& y);

/// y1 = A x1 and y2 = A x2, reading A once. @param lanes that are asked for; what the others become is not said
void multiply_two(const BlockMatrix& A, const LaneArray& x1, const LaneArray& x2, LaneArray& y1, LaneArray& y2,
                  const Mask& lanes = Mask(true));

/// y = A x1 and form = x2' A x2, for which half of A is enough. @param lanes that are asked for; what the others
/// become is not said
void multiply_and_form(const BlockMatrix& A, const LaneArray& x1, const LaneArray& x2, LaneArray& y, Lane& form,
                       const Mask& lanes = Mask(true));

/// sums[r] += sum_j block_j x_j over the 3x3 blocks `rows[r] + 9 j` of some rows and rows 3 j.. of x, for the
/// listed j. The bits of a sum do not depend on the rows beside it.
/// @param lanes that are asked for; what becomes of the others' sums is not said
void add_blocks(std::span<const double* const> rows, std::span<const int> columns, const LaneArray& x,
                const BusyPacks& lanes, std::span<std::array<Lane, 3>> sums);

/// y_i -= sum_j A_ij x_j over the listed rows and columns of a square of 3x3 blocks, block (i, j) at 9 (i n + j).
/// @param n rows of blocks @param y rows 3 i.. @param lanes that change
void subtract_product(std::span<const double> A, std::size_t n, std::span<const int> rows,
                      std::span<const int> columns, const LaneArray& x, const Mask& lanes, LaneArray& y);

}  // namespace unbruised
