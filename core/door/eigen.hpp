#pragma once

/// @file
/// The door to Eigen, without its own vector code: that sums as many terms at a time as a register holds, so that
/// last bits would be others with AVX-512 than with AVX2. Nobody includes Eigen but here: two ways to compile one
/// template in a program would leave it to the linker which of them all use.

#ifndef EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_VECTORIZE
#endif
#include <Eigen/Dense>  // IWYU pragma: export
