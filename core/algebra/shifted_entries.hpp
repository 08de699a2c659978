#pragma once

/// @file
/// A block matrix and the masses, as entries of the matrix that is factored.

#include <span>
#include <vector>

#include "core/algebra/block_matrix.hpp"
#include "core/algebra/sparse_cholesky.hpp"

namespace unbruised {

/// Lower entries of K + mass_factor M; `freedom` numbers the free freedoms (3 per particle, -1: left out).
std::vector<MatrixEntry> shifted_entries(const BlockMatrix& K, std::span<const double> mass_kg, double mass_factor,
                                         std::span<const int> freedom);

}  // namespace unbruised
