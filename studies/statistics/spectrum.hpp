#pragma once

/// @file
/// Eigenvalues and eigenvectors of small symmetric matrices.

#include <cstddef>
#include <vector>

namespace unbruised::studies {

/// A symmetric matrix as V diag(values) V'.
struct Spectrum {
  std::vector<double> values;   ///< in no order
  std::vector<double> vectors;  ///< V, [row][column]; column k belongs to value k
};

/// By Jacobi's rotations. @param A [size][size], symmetric
Spectrum symmetric_spectrum(std::vector<double> A, std::size_t size);

}  // namespace unbruised::studies
