#pragma once

/// @file
/// Dense copies of block matrices, for tests.

#include "core/algebra/block_matrix.hpp"
#include "core/door/eigen.hpp"

namespace unbruised::testing {

inline Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * matrix.particle_count, 3 * matrix.particle_count);
  for (int i = 0; i < matrix.particle_count; ++i) {
    for (int block = matrix.row_start[i]; block < matrix.row_start[i + 1]; ++block) {
      for (int r = 0; r < 3; ++r) {
        for (int s = 0; s < 3; ++s)
          full(3 * i + r, 3 * matrix.column[block] + s) += matrix.value[9 * block + 3 * r + s];
      }
    }
  }
  return full;
}

inline bool is_symmetric_to_the_bit(const Eigen::MatrixXd& matrix) {
  return (matrix.array() == matrix.transpose().array()).all();
}

}  // namespace unbruised::testing
