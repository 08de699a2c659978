#pragma once

/// @file
/// A solid of revolution about one of the axes, from its profile.

#include "core/scenario/profile_curve.hpp"
#include "core/scenario/solid.hpp"

namespace unbruised {

class Revolution final : public Solid {
 public:
  /// @param parameters of a sound profile
  explicit Revolution(const LatticeParameters& parameters);

  [[nodiscard]] double volume_m3() const override;
  [[nodiscard]] std::array<double, 3> center_of_mass_m() const override;
  [[nodiscard]] double mean_square_m2(std::size_t axis) const override;
  [[nodiscard]] double section_m2(std::size_t axis) const override;
  [[nodiscard]] bool contains(const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::optional<double> column_m(std::size_t side,
                                               const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::array<double, 3> outward(std::size_t side,
                                              const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::array<double, 3> pole_m(std::size_t side) const override;
  [[nodiscard]] double pole_curvature_1_m(std::size_t side, std::size_t along) const override;
  [[nodiscard]] double flat_end_m2(std::size_t side) const override;
  [[nodiscard]] bool is_mirrored(std::size_t axis) const override { return axis != axis_; }
  [[nodiscard]] double reach_m(const std::array<double, 3>& direction) const override;
  [[nodiscard]] NearestSurface nearest(const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::optional<ShapeHit> first_hit(const std::array<double, 3>& place_m,
                                                  const std::array<double, 3>& direction) const override;

 private:
  [[nodiscard]] double squared_radius(const std::array<double, 3>& place_m) const {
    return place_m[first_] * place_m[first_] + place_m[second_] * place_m[second_];
  }
  /// Integral of weight(height) over the height.
  template <class Weight>
  [[nodiscard]] double integral(const Weight& weight) const;
  /// The height at which some function of it is least.
  template <class Of>
  [[nodiscard]] double least_of(const Of& of) const;
  [[nodiscard]] ShapeHit hit_at(double distance_m, const std::array<double, 3>& place_m,
                                const std::array<double, 3>& direction) const;

  std::size_t axis_, first_, second_;
  ProfileCurve curve_;
  double widest_m_, length_m_;  ///< radius; from end to end
};

}  // namespace unbruised
