#pragma once

/// @file
/// The piece of a face that a particle stands for, along one axis of the face's plane, and how much of it lies
/// under a surface that ends (docs/theory.md, "Areas of contact").
///
/// Along a flat direction the piece is weighted by the hat function of the cells beside the particle: 1 at the
/// particle, 0 at its neighbours, so that a uniform pressure on any part of the face acts with its force and its
/// moment, whatever the cell size. Where the surface ends within the face, the particles beside its edge have a
/// softness of their own: the body sags there within a cell, which its particles cannot. Along a curved direction
/// the piece is one cell wide and cut into places that each have a depth of their own.

#include <array>
#include <cstddef>

#include "core/lanes/lane.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

/// A curved direction is sampled at this many places of a cell, so that a curved contact grows smoothly and not
/// particle by particle.
inline constexpr int kReliefSide = 4;

/// What of a piece lies within a stretch.
struct CoveredPiece {
  Lane share{1.0};  ///< of its weight
  Lane mean_m{0.0},
      mean_square_m2{0.0};  ///< offset from the particle, over the covered weight of a flat direction
  /// Of the body beside an edge of the surface: compliance per pressure x E / (1 - nu^2) / extent of a cell; flat
  /// directions.
  Lane softness{0.0};
  std::array<Lane, kReliefSide> place;  ///< share of each place of a curved direction; of a sampled one mean 1
};

struct Tributary {
  double place_m = 0;   ///< of the particle at rest
  double extent_m = 0;  ///< of a cell
  bool curved = false;
  std::array<int, 2> cells{2,
                           2};  ///< of the face beside the particle, below and above; more than two count as two
  bool sampled = false;         ///< a flat direction under a shaped pad: cut into places as well

  /// Is each of its places as deep as it is?
  [[nodiscard]] bool has_places() const { return curved || sampled; }
  /// Of place `k` from the particle [m]; those of a flat direction lie over both cells beside it.
  [[nodiscard]] double offset_m(int k) const {
    return ((k + 0.5) / kReliefSide - 0.5) * (sampled ? 2.0 : 1.0) * extent_m;
  }

  /// The weight within a window [m]. @param moved of the particle from its place
  [[nodiscard]] Lane weight_m(const Stretch& window, const Lane& moved) const;
  [[nodiscard]] CoveredPiece covered_by(const Stretch& covered, const Lane& moved) const;
};

/// Weight of both pieces beside a particle.
inline double full_weight_m(const Tributary& piece) {
  if (piece.curved) return piece.extent_m;
  return piece.extent_m * 0.5 * ((piece.cells[0] > 0 ? 1 : 0) + (piece.cells[1] > 0 ? 1 : 0));
}

}  // namespace unbruised
