#pragma once

/// @file
/// How far some particles of a factored body move, within a step, under forces on each other: J A^-1 J'.

#include <vector>

#include "core/algebra/supernodes.hpp"

namespace unbruised {

struct NodeCompliance {
  std::vector<double> block;  ///< 3x3 blocks, row-major, block (i, j) at 9 (i m + j) for m particles [m/N]
  std::vector<int> reach;     ///< supernodes their freedoms touch
};

/// @param slot elimination position of each freedom (3 per particle), -1 where it is fixed
NodeCompliance node_compliance(const SupernodalFactor& factor, const std::vector<int>& slot,
                               const std::vector<int>& node);

}  // namespace unbruised
