#pragma once

/// @file
/// Triangular solves with a packed factor for all lanes at once. Vectors are in elimination order, shape
/// [factor.size, kLanes]. What becomes of x in lanes that are not asked for is not said.

#include <span>

#include "core/algebra/supernodes.hpp"
#include "core/lanes/lane.hpp"

namespace unbruised {

/// x = L^-1 x.
void solve_forward(const SupernodalFactor& factor, double* x, const Mask& lanes = Mask(true));
/// x = L^-T x.
void solve_backward(const SupernodalFactor& factor, double* x, const Mask& lanes = Mask(true));

/// The same on the supernodes of `reach` only (ascending): forwards for an x that is zero elsewhere, backwards for
/// those entries of the solution; other entries of x are neither read nor written.
void solve_forward(const SupernodalFactor& factor, std::span<const int> reach, double* x,
                   const Mask& lanes = Mask(true));
void solve_backward(const SupernodalFactor& factor, std::span<const int> reach, double* x,
                    const Mask& lanes = Mask(true));

// In single precision, with a factor whose values are rounded.
void solve_forward(const SupernodalFactor& factor, float* x, const Mask& lanes = Mask(true));
void solve_backward(const SupernodalFactor& factor, float* x, const Mask& lanes = Mask(true));
void solve_forward(const SupernodalFactor& factor, std::span<const int> reach, float* x,
                   const Mask& lanes = Mask(true));
void solve_backward(const SupernodalFactor& factor, std::span<const int> reach, float* x,
                    const Mask& lanes = Mask(true));

}  // namespace unbruised
