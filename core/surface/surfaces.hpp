#pragma once

/// @file
/// What a product can touch. The list of surfaces and the geometry of each stand here and nowhere else: by whom it
/// is carried, along which axis its normal points, to which side it pushes.

#include <array>
#include <string>
#include <string_view>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Numbers of the surfaces, as in traces and contact events. The pads come first: pad f belongs to finger f. The
/// surfaces that a cell lists follow the support.
inline constexpr int kLeftPad = 0, kRightPad = 1, kSupport = 2, kFirstCellSurface = 3;
inline constexpr int kSurfaceCount = kFirstCellSurface + kMostCellSurfaces;
/// Fingers of a parallel jaw, and so pads.
inline constexpr int kFingerCount = 2;

/// Who moves a surface.
enum class Carrier {
  finger,  ///< of the same number as the surface, on top of the palm's motion
  cell,
};

struct SurfaceGeometry {
  std::string_view name;
  Carrier carrier;
  int normal_axis;
  /// Of the force it can exert on the product along its normal axis; a finger closes in this direction.
  double normal_sign;
  std::array<int, 2> tangent_axes;
};

inline constexpr std::array<SurfaceGeometry, kFirstCellSurface> kSurfaces = {{
    {"left pad", Carrier::finger, 0, 1.0, {1, 2}},
    {"right pad", Carrier::finger, 0, -1.0, {1, 2}},
    {"support", Carrier::cell, 2, 1.0, {0, 1}},
}};

/// A surface that the cell lists is, in its own axes, what the support is in those of the cell.
constexpr const SurfaceGeometry& geometry_of(int surface) {
  return kSurfaces[static_cast<std::size_t>(surface < kSupport ? surface : kSupport)];
}
/// Is it a pad?
constexpr bool is_pad(int surface) { return geometry_of(surface).carrier == Carrier::finger; }
constexpr int normal_axis(int surface) { return geometry_of(surface).normal_axis; }
constexpr double normal_sign(int surface) { return geometry_of(surface).normal_sign; }
constexpr std::array<int, 2> tangent_axes(int surface) { return geometry_of(surface).tangent_axes; }

/// Pads, support, and what the cell lists.
inline int surface_count(const Scenario& scenario) {
  return kFirstCellSurface + static_cast<int>(scenario.cell.surface.size());
}

/// "left pad", "right pad", "support", "cell.surface.0" and so on.
inline std::string surface_name(int surface) {
  if (surface >= kFirstCellSurface) return "cell.surface." + std::to_string(surface - kFirstCellSurface);
  return std::string(geometry_of(surface).name);
}

/// The numbers and names of the first `count`: "0 left pad, 1 right pad, 2 support".
inline std::string surface_codes(int count) {
  std::string text;
  for (int surface = 0; surface < count; ++surface) {
    text += (surface == 0 ? "" : ", ") + std::to_string(surface) + " " + surface_name(surface);
  }
  return text;
}

}  // namespace unbruised
