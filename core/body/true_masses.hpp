#pragma once

/// @file
/// Masses of particles by which a lattice turns as its true shape does.

#include <vector>

#include "core/body/lattice.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Whose moments of inertia the particles have.
enum class MassSpread {
  cells,       ///< each cell gives its mass to its corners: as it is for a product that does not roll
  true_shape,  ///< of the true shape
};

/// The lattice's masses, moved between middle and rim as little as that takes, so that mass and moments of inertia
/// are those of the true shape; all stay positive. @return [particle], [kg]
std::vector<double> true_masses(const LatticeParameters& parameters, const Lattice& lattice);

}  // namespace unbruised
