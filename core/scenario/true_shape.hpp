#pragma once

/// @file
/// The true shape of a lattice product: its one definition, asked by the lattice for its cells and by contact for
/// the surface. With q the place from the centre over the half extents, a place is inside where the sum of q^2
/// over the round axes is at most 1, and each other |q|.

#include <array>
#include <cstddef>
#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// The place of the surface that is nearest to some place.
struct NearestSurface {
  double distance_m = 0;                  ///< negative inside
  std::array<double, 3> normal{0, 0, 1};  ///< outward, of length 1
};

/// Where a ray meets the surface.
struct ShapeHit {
  double distance_m = 0;           ///< along the ray; 0 where it starts inside
  std::array<double, 3> normal{};  ///< outward, of any length; against the ray where it starts inside
};

/// Places are relative to the centre of the shape.
class TrueShape {
 public:
  explicit TrueShape(const LatticeParameters& parameters);

  /// Does the surface curve along this axis?
  [[nodiscard]] bool is_round(std::size_t axis) const { return round_[axis]; }
  /// Along how many of the two directions across it does the side that faces `axis` curve?
  [[nodiscard]] int curvatures(std::size_t axis) const;
  [[nodiscard]] double volume_m3() const;
  /// Area of the flat side that faces `axis` [m2].
  [[nodiscard]] double face_area_m2(std::size_t axis) const;
  [[nodiscard]] bool contains(const std::array<double, 3>& place_m) const;
  /// Half the chord along `axis` through a place (its own component along the axis does not count) [m]; negative
  /// where the line passes beside its round axes (flat ones are not asked).
  [[nodiscard]] double half_chord_m(std::size_t axis, const std::array<double, 3>& place_m) const;
  /// Radius of curvature at the pole of `axis` along another, round one [m].
  [[nodiscard]] double pole_radius_m(std::size_t axis, std::size_t along) const {
    return 0.5 * size_m_[along] * size_m_[along] / size_m_[axis];
  }
  /// How far it reaches from its centre along a unit vector: its support function [m].
  [[nodiscard]] double reach_m(const std::array<double, 3>& direction) const;
  /// Distance and normal at a place; where several places are nearest, as in the middle, one of them.
  [[nodiscard]] NearestSurface nearest(const std::array<double, 3>& place_m) const;
  /// Where a ray from a place along a unit vector first meets the shape; none: it passes.
  [[nodiscard]] std::optional<ShapeHit> first_hit(const std::array<double, 3>& place_m,
                                                  const std::array<double, 3>& direction) const;

 private:
  /// A stretch of a ray, and what bounds it where the ray comes in.
  struct Chord;
  [[nodiscard]] Chord round_chord(const std::array<double, 3>& place_m,
                                  const std::array<double, 3>& direction) const;
  [[nodiscard]] Chord flat_chord(std::size_t axis, double place_m, double direction) const;
  [[nodiscard]] NearestSurface nearest_round(const std::array<double, 3>& place_m) const;

  std::array<double, 3> size_m_;
  std::array<bool, 3> round_{};
};

}  // namespace unbruised
