#pragma once

/// @file
/// True shapes beyond boxes, ellipsoids and cylinders: what `TrueShape` asks of each kind. Places are relative to
/// the middle of the bounding box; sides are -x, +x, -y, +y, -z, +z, as those of a lattice.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Along which axis a side faces outward, and which way.
constexpr std::size_t side_axis(std::size_t side) { return side / 2; }
constexpr double side_sign(std::size_t side) { return side % 2 == 0 ? -1.0 : 1.0; }

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

class Solid {
 public:
  virtual ~Solid() = default;

  [[nodiscard]] virtual double volume_m3() const = 0;
  [[nodiscard]] virtual std::array<double, 3> center_of_mass_m() const = 0;
  /// Of the places along an axis, from the middle.
  [[nodiscard]] virtual double mean_square_m2(std::size_t axis) const = 0;
  /// Of the products of the places along two axes; 0: it is mirrored across one of them.
  [[nodiscard]] virtual double mean_product_m2(std::size_t /*a*/, std::size_t /*b*/) const { return 0.0; }
  /// Of the widest cut across an axis; what a side's outline encloses.
  [[nodiscard]] virtual double section_m2(std::size_t axis) const = 0;
  [[nodiscard]] virtual bool contains(const std::array<double, 3>& place_m) const = 0;
  /// As `TrueShape::column_m`.
  [[nodiscard]] virtual std::optional<double> column_m(std::size_t side,
                                                       const std::array<double, 3>& place_m) const = 0;
  /// Of length 1, at a place of the surface that faces the side.
  [[nodiscard]] virtual std::array<double, 3> outward(std::size_t side,
                                                      const std::array<double, 3>& place_m) const = 0;
  [[nodiscard]] virtual std::array<double, 3> pole_m(std::size_t side) const = 0;
  /// 0: straight or flat there.
  [[nodiscard]] virtual double pole_curvature_1_m(std::size_t side, std::size_t along) const = 0;
  /// 0: the side does not end in a plane.
  [[nodiscard]] virtual double flat_end_m2(std::size_t side) const = 0;
  /// Are both sides across an axis each other's mirror image?
  [[nodiscard]] virtual bool is_mirrored(std::size_t axis) const = 0;
  [[nodiscard]] virtual double reach_m(const std::array<double, 3>& direction) const = 0;
  [[nodiscard]] virtual NearestSurface nearest(const std::array<double, 3>& place_m) const = 0;
  [[nodiscard]] virtual std::optional<ShapeHit> first_hit(const std::array<double, 3>& place_m,
                                                          const std::array<double, 3>& direction) const = 0;
};

/// None: a box, an ellipsoid or a cylinder, or parameters that break the rules of their shape.
std::shared_ptr<const Solid> solid_of(const LatticeParameters& parameters);

}  // namespace unbruised
