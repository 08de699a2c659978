#pragma once

/// @file
/// The true shape of a lattice product: its one definition, asked by the lattice for its cells and by contact for
/// the surface. With q the place from the centre over the half extents, a place of a box, an ellipsoid or a
/// cylinder is inside where the sum of q^2 over the round axes is at most 1, and each other |q|; other shapes are
/// `Solid`s.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "core/scenario/scenario.hpp"
#include "core/scenario/solid.hpp"

namespace unbruised {

/// Places are relative to the centre of the shape, that of its bounding box. Sides are -x, +x, -y, +y, -z, +z.
class TrueShape {
 public:
  explicit TrueShape(const LatticeParameters& parameters);

  /// What kind of solid it is; null: a box, an ellipsoid or a cylinder.
  [[nodiscard]] const Solid* solid() const { return solid_.get(); }
  /// Does the surface curve along this axis?
  [[nodiscard]] bool is_round(std::size_t axis) const { return round_[axis]; }
  /// Are the sides across `axis` planes?
  [[nodiscard]] bool is_plane(std::size_t axis) const;
  /// Does the pole of a side curve along an axis?
  [[nodiscard]] bool curves(std::size_t side, std::size_t along) const;
  /// Along how many of the two directions across it does the pole of a side curve?
  [[nodiscard]] int curvatures(std::size_t side) const;
  [[nodiscard]] double volume_m3() const;
  [[nodiscard]] std::array<double, 3> center_of_mass_m() const;
  /// Mean square of the places along `axis` over the square of the extent.
  [[nodiscard]] double mean_square_share(std::size_t axis) const;
  /// Mean product of the places along two axes over that of the extents.
  [[nodiscard]] double mean_product_share(std::size_t a, std::size_t b) const;
  /// Of the widest cut across `axis` [m2].
  [[nodiscard]] double section_m2(std::size_t axis) const;
  /// Area of the sides that are planes across `axis` [m2].
  [[nodiscard]] double face_area_m2(std::size_t axis) const;
  /// Extents of the flat face of a side along the two axes across it, in the order of x, y, z [m]: of a round end
  /// the sides of a square as large, of a side without a plane those of the box.
  [[nodiscard]] std::array<double, 2> face_extents_m(std::size_t side) const;
  [[nodiscard]] bool contains(const std::array<double, 3>& place_m) const;
  /// How far outward from the centre a side's surface lies in the column along its axis through a place (whose own
  /// component along the axis does not count) [m]; none where the column passes beside round axes (flat ones are
  /// not asked).
  [[nodiscard]] std::optional<double> column_m(std::size_t side, const std::array<double, 3>& place_m) const;
  /// The normal at a place of the surface that faces a side, of length 1.
  [[nodiscard]] std::array<double, 3> outward(std::size_t side, const std::array<double, 3>& place_m) const;
  /// The outermost place of a side.
  [[nodiscard]] std::array<double, 3> pole_m(std::size_t side) const;
  /// Radius of curvature at the pole of a side along an axis where it curves [m].
  [[nodiscard]] double pole_radius_m(std::size_t side, std::size_t along) const;
  /// Are both sides across `axis` each other's mirror image?
  [[nodiscard]] bool is_mirrored(std::size_t axis) const { return !solid_ || solid_->is_mirrored(axis); }
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
  std::shared_ptr<const Solid> solid_;
};

}  // namespace unbruised
