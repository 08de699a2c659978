#pragma once

/// @file
/// The elastic stress below a circular patch of Hertz, sorted by its size, in units of its peak and of the patch's
/// area (patch_damage.hpp says what it is for).

#include <array>
#include <cstddef>

namespace unbruised {

/// Volume, weight in the dent, width and depth of what lies below a circular patch, by the part of the peak stress
/// that is exceeded.
class PatchField {
 public:
  /// @param poisson_ratio 0 to 0.5
  explicit PatchField(double poisson_ratio);
  /// V(v): volume / A^1.5. @param part of the peak stress; below 0.3 that of 0.3
  [[nodiscard]] double volume_above(double part) const;
  /// W(v): dent at the pole / sqrt(A) per unit of plastic strain.
  [[nodiscard]] double dent_above(double part) const;
  /// Area of the circle as wide as that volume at its widest / A.
  [[nodiscard]] double area_above(double part) const;
  /// How deep it reaches below the surface / sqrt(A): at the peak itself where that lies.
  [[nodiscard]] double depth_above(double part) const;

  static constexpr std::size_t kParts = 15;
  static constexpr double kLeastPart = 0.3, kPartStep = 0.05;

 private:
  std::array<double, kParts> root_volume_{};  ///< V^(2/3): near the peak V falls as (1 - v)^1.5
  std::array<double, kParts> dent_{}, area_{}, depth_{};
};

}  // namespace unbruised
