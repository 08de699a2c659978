#pragma once

/// @file
/// How far some particles of a factored body move, within a step, under forces on each other: J A^-1 J'.

#include <span>
#include <vector>

#include "core/algebra/lane_dense.hpp"
#include "core/algebra/supernodes.hpp"

namespace unbruised {

struct NodeCompliance {
  std::vector<double> block;  ///< 3x3 blocks, row-major, block (i, j) at 9 (i m + j) for m particles [m/N]
  std::vector<int> reach;     ///< supernodes their freedoms touch
  /// A^-1 J' in elimination order, [factor.size, 3m; m/N]; empty where a solve takes less time than a product.
  SingleMatrix columns;
};

/// Particles that contact forces may act on within a step, and how they answer.
struct Touchable {
  std::span<const int> particle;
  std::span<const int> reach;          ///< supernodes they touch
  std::span<const double> compliance;  ///< 3x3 blocks, row-major, block (i, j) at 9 (i m + j) [m/N]
  /// How all of the body answers (NodeCompliance::columns); null or empty: it is solved for.
  const SingleMatrix* columns = nullptr;
};

/// @param slot elimination position of each freedom (3 per particle), -1 where it is fixed
NodeCompliance node_compliance(const SupernodalFactor& factor, const std::vector<int>& slot,
                               const std::vector<int>& node);

}  // namespace unbruised
