#pragma once

/// @file
/// Products of a block matrix, shared by all lanes, with lane vectors of shape [3 x particles, kLanes].

#include "core/lanes/lane.hpp"
#include "core/product/block_matrix.hpp"

namespace unbruised {

/// y = A x.
void multiply(const BlockMatrix& A, const LaneArray& x, LaneArray& y);

/// y1 = A x1 and y2 = A x2, reading A once.
void multiply_two(const BlockMatrix& A, const LaneArray& x1, const LaneArray& x2, LaneArray& y1, LaneArray& y2);

}  // namespace unbruised
