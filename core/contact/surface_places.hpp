#pragma once

/// @file
/// The true surface of a lattice product as places that can touch anything: each belongs to one of the six sides
/// and to the particle that carries it (docs/theory.md, "Contact that turns").

#include <array>
#include <vector>

#include "core/body/lattice.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

struct SurfacePlace {
  int node = 0;  ///< the particle that carries it
  std::array<double, 3> place_m{};
  std::array<double, 3> outward{};  ///< of length 1
  double area_m2 = 0;
  bool curved = false;  ///< its side curves along both directions or one
};

/// Places over all sides, side by side. A side that curves gives way to its neighbour where the surface faces that
/// one more: each place belongs to exactly one side. The areas of a flat side add up to it.
/// @param set six_sides: of each side what lies within kDeepestMeeting of its pole
std::vector<SurfacePlace> surface_places(const LatticeParameters& parameters, const Lattice& lattice,
                                         ContactSet set);

}  // namespace unbruised
