#pragma once

/// @file
/// Tables over time as few bytes: each number as a multiple of a step, less the one that stood there a row before.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace unbruised::studies {

struct CodedTable {
  double step = 0;    ///< a number is read as a multiple of it, off by half of it at most
  std::string bytes;  ///< see `delta_coded`
};

/// Rows of `width` numbers, row by row. Of each the difference to the number above it (to 0 in the first row),
/// with its sign in the lowest bit (0, -1, 1, -2 ... as 0, 1, 2, 3 ...), seven bits to a byte, low ones first, the
/// highest bit of a byte saying that another follows. A 0 is followed by how many further zeros there are.
std::string delta_coded(std::span<const std::int32_t> values, std::size_t width);

/// In steps of 1 / `steps` of the largest size; what is not finite is 0.
CodedTable coded(std::span<const float> values, std::size_t width, int steps);

}  // namespace unbruised::studies
