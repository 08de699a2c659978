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

/// sum += sum_j block_j x_j over the 3x3 blocks `row + 9 j` of one row and rows 3 j.. of x, for the listed j.
/// @param lanes that are asked for; what becomes of the others' sums is not said
void add_blocks(const double* row, std::span<const int> columns, const LaneArray& x, const BusyPacks& lanes,
                std::array<Lane, 3>& sum);

}  // namespace unbruised
