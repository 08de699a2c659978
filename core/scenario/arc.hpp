#pragma once

/// @file
/// The arc of a circle from one place to another through a third.

#include <array>
#include <optional>

namespace unbruised {

struct Arc {
  std::array<double, 3> center_m{};
  std::array<double, 3> from_center_m{};  ///< to where it begins
  std::array<double, 3> axis{};           ///< of length 1; it turns about it by angle_rad
  double angle_rad = 0.0;                 ///< > 0, < 2 pi

  [[nodiscard]] double radius_m() const;
  [[nodiscard]] double length_m() const { return radius_m() * angle_rad; }
};

/// None: two of the places are one, or all lie in a line, within 1e-6 of their distances.
std::optional<Arc> arc_through(const std::array<double, 3>& from_m, const std::array<double, 3>& via_m,
                               const std::array<double, 3>& to_m);

}  // namespace unbruised
