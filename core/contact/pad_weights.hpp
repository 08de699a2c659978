#pragma once

/// @file
/// How a pressure that the product's pieces of a face carry is passed to a pad with particles of its own, along
/// one direction (docs/theory.md, "Pads that are bodies").
///
/// A piece carries its force over a share of the face psi_k, and its weights on the pad's particles are the
/// integrals of psi_k times their hat functions N_j over that of psi_k. The shares add up to one, so that a
/// constant pressure is passed exactly whatever the two meshes are. Along a flat direction they are the duals of
/// the product's hat functions, integral psi_k H_l = 0 for k != l: a force is then passed in the middle of its
/// particle, and both bodies see the same moment.

#include <cstddef>
#include <vector>

#include "core/contact/tributary.hpp"

namespace unbruised {

/// Weights of one piece on neighbouring particles of the pad; their sum is 1.
struct PadWeights {
  std::size_t first = 0;
  std::vector<double> weight;
};

/// @param piece of the product's face, ascending @param pad_m places of the pad's particles, ascending, from the
/// middle of the pad @param middle_m of the pad, in the places of the pieces
std::vector<PadWeights> pad_weights(const std::vector<Tributary>& piece, const std::vector<double>& pad_m,
                                    double middle_m);

}  // namespace unbruised
