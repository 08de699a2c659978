#pragma once

/// @file
/// Static answers to the columns of a dense matrix; inside the body's own sources, which know Eigen.

#include "core/body/static_solver.hpp"
#include "core/door/eigen.hpp"

namespace unbruised {

/// (K + shift M)^-1 on up to kLanes columns of [3n] forces.
Eigen::MatrixXd shifted_columns(const StaticSolver& statics, const Eigen::MatrixXd& force_N);

}  // namespace unbruised
