#pragma once

/// @file
/// The piece of a face that a particle stands for, along one axis of the face's plane, and how much of it lies
/// under a surface that ends (docs/theory.md, "Areas of contact").
///
/// Along a flat direction the piece is weighted by the hat function of the cells beside the particle: 1 at the
/// particle, 0 at its neighbours. A uniform pressure on any part of the face then acts with its force and its
/// moment, whatever the cell size. Along a curved direction the piece is one cell wide and cut into places that
/// each have a depth of their own.

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
      mean_square_m2{0.0};              ///< offset from the particle, over the covered weight of a flat direction
  std::array<Lane, kReliefSide> place;  ///< share of each place of a curved direction
};

struct Tributary {
  double place_m = 0;   ///< of the particle at rest
  double extent_m = 0;  ///< of a cell
  bool curved = false;
  std::array<bool, 2> cell{true, true};  ///< has the face a cell on the lower, on the upper side?

  /// The weight within a stretch [m]. @param moved of the particle from its place
  [[nodiscard]] Lane weight_m(const Stretch& stretch, const Lane& moved) const;
  [[nodiscard]] CoveredPiece covered_by(const Stretch& stretch, const Lane& moved) const;

 private:
  /// The stretch in cells from the particle, within the piece.
  [[nodiscard]] Stretch in_cells(const Stretch& stretch, const Lane& moved) const;
  /// Integrals of weight x s^power from the lower end of a flat piece to s, in cells.
  [[nodiscard]] std::array<Lane, 3> integrals(const Lane& s) const;
};

/// Weight of both pieces beside a particle.
inline double full_weight_m(const Tributary& piece) {
  return piece.curved ? piece.extent_m : piece.extent_m * 0.5 * (int{piece.cell[0]} + int{piece.cell[1]});
}

inline Stretch Tributary::in_cells(const Stretch& stretch, const Lane& moved) const {
  const Lane reach(curved ? 0.5 : 1.0), place = Lane(place_m) + moved, inverse(1.0 / extent_m);
  return {min(max((stretch.low - place) * inverse, -reach), reach),
          min(max((stretch.high - place) * inverse, -reach), reach)};
}

inline std::array<Lane, 3> Tributary::integrals(const Lane& s) const {
  const Lane below(cell[0] ? 1.0 : 0.0), above(cell[1] ? 1.0 : 0.0);
  const Lane a = min(s, Lane(0.0)), b = max0(s);  // weight 1 + a over [-1, 0], 1 - b over [0, 1]
  const Lane a2 = a * a, b2 = b * b;
  return {below * (Lane(0.5) + a + Lane(0.5) * a2) + above * (b - Lane(0.5) * b2),
          below * (a2 * (Lane(0.5) + a * Lane(1.0 / 3.0)) - Lane(1.0 / 6.0)) +
              above * b2 * (Lane(0.5) - b * Lane(1.0 / 3.0)),
          below * (a * a2 * (Lane(1.0 / 3.0) + Lane(0.25) * a) + Lane(1.0 / 12.0)) +
              above * b * b2 * (Lane(1.0 / 3.0) - Lane(0.25) * b)};
}

inline Lane Tributary::weight_m(const Stretch& stretch, const Lane& moved) const {
  const Stretch s = in_cells(stretch, moved);
  if (curved) return max0(s.high - s.low) * Lane(extent_m);
  return max0(integrals(s.high)[0] - integrals(s.low)[0]) * Lane(extent_m);
}

inline CoveredPiece Tributary::covered_by(const Stretch& stretch, const Lane& moved) const {
  const Stretch s = in_cells(stretch, moved);
  CoveredPiece piece;
  if (curved) {
    const Lane low = (s.low + Lane(0.5)) * Lane(kReliefSide), high = (s.high + Lane(0.5)) * Lane(kReliefSide);
    Lane sum(0.0);
    for (int k = 0; k < kReliefSide; ++k) {
      const Lane up_to = min(max0(high - Lane(k)), Lane(1.0)), from = min(max0(low - Lane(k)), Lane(1.0));
      sum += piece.place[static_cast<std::size_t>(k)] = max0(up_to - from);
    }
    piece.share = sum * Lane(1.0 / kReliefSide);
    return piece;
  }
  piece.place.fill(Lane(1.0));
  const auto low = integrals(s.low), high = integrals(s.high);
  const Lane weight = max0(high[0] - low[0]);
  const Lane inverse = Lane(1.0) / max(weight, Lane(1e-300));
  piece.share = weight * Lane(extent_m / full_weight_m(*this));
  piece.mean_m = (high[1] - low[1]) * inverse * Lane(extent_m);
  piece.mean_square_m2 = (high[2] - low[2]) * inverse * Lane(extent_m * extent_m);
  return piece;
}

}  // namespace unbruised
