#pragma once

/// @file
/// (|x/a|^p + |y/b|^p)^(q/p) + |z/c|^q <= 1: an ellipsoid for p = q = 2, nearer to a box for more.

#include "core/scenario/solid.hpp"

namespace unbruised {

class Superellipsoid final : public Solid {
 public:
  explicit Superellipsoid(const LatticeParameters& parameters);

  [[nodiscard]] double volume_m3() const override;
  [[nodiscard]] std::array<double, 3> center_of_mass_m() const override { return {}; }
  [[nodiscard]] double mean_square_m2(std::size_t axis) const override;
  [[nodiscard]] double section_m2(std::size_t axis) const override;
  [[nodiscard]] bool contains(const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::optional<double> column_m(std::size_t side,
                                               const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::array<double, 3> outward(std::size_t side,
                                              const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::array<double, 3> pole_m(std::size_t side) const override;
  [[nodiscard]] double pole_curvature_1_m(std::size_t side, std::size_t along) const override;
  [[nodiscard]] double flat_end_m2(std::size_t) const override { return 0.0; }
  [[nodiscard]] bool is_mirrored(std::size_t) const override { return true; }
  [[nodiscard]] double reach_m(const std::array<double, 3>& direction) const override;
  [[nodiscard]] NearestSurface nearest(const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::optional<ShapeHit> first_hit(const std::array<double, 3>& place_m,
                                                  const std::array<double, 3>& direction) const override;

 private:
  /// 1 on the surface, less inside, of degree one: how far out a place is.
  [[nodiscard]] double gauge(const std::array<double, 3>& place_m) const;
  [[nodiscard]] std::array<double, 3> slope(const std::array<double, 3>& place_m) const;

  std::array<double, 3> half_m_;
  double p_, q_;
};

}  // namespace unbruised
