#pragma once

/// @file
/// What a product can touch. The list of surfaces and the geometry of each stand here and nowhere else: by whom it
/// is carried, along which axis its normal points, to which side it pushes.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/finger_axes.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Numbers of the surfaces. The pads of a parallel jaw come first: pad f belongs to finger f. The surfaces that a
/// cell lists follow the support, and the pads of the fingers that a gripper lists follow them.
inline constexpr int kLeftPad = 0, kRightPad = 1, kSupport = 2, kFirstCellSurface = 3;
inline constexpr int kFirstListedPad = kFirstCellSurface + kMostCellSurfaces;
inline constexpr int kSurfaceCount = kFirstListedPad + kMostFingers;

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

/// A surface that is listed is, in its own axes, what the support is in those of the cell.
constexpr const SurfaceGeometry& geometry_of(int surface) {
  return kSurfaces[static_cast<std::size_t>(surface < kSupport ? surface : kSupport)];
}
/// Is it the pad of a finger that a gripper lists?
constexpr bool is_listed_pad(int surface) { return surface >= kFirstListedPad; }
/// Does the cell list it?
constexpr bool is_of_cell_list(int surface) { return surface >= kFirstCellSurface && !is_listed_pad(surface); }
/// Is it a pad?
constexpr bool is_pad(int surface) {
  return geometry_of(surface).carrier == Carrier::finger || is_listed_pad(surface);
}
/// Of a pad.
constexpr std::size_t finger_of(int surface) {
  return static_cast<std::size_t>(is_listed_pad(surface) ? surface - kFirstListedPad : surface);
}
/// Does it have axes of its own, other than those of its carrier?
constexpr bool has_own_axes(int surface) { return surface >= kFirstCellSurface; }
constexpr int normal_axis(int surface) { return geometry_of(surface).normal_axis; }
constexpr double normal_sign(int surface) { return geometry_of(surface).normal_sign; }
/// The side of a lattice (-x, +x, -y, +y, -z, +z) that faces a surface, which lies at the low end where its force
/// points up.
constexpr std::size_t facing_side(int surface) {
  return 2 * static_cast<std::size_t>(normal_axis(surface)) + (normal_sign(surface) > 0.0 ? 0 : 1);
}
constexpr std::array<int, 2> tangent_axes(int surface) { return geometry_of(surface).tangent_axes; }

/// Pads, support, and what the cell lists: in the order in which traces and contact events number them.
inline std::vector<int> surfaces_of(const Scenario& scenario) {
  std::vector<int> all = {kLeftPad, kRightPad};
  if (const auto* jaw = parallel_jaw(scenario); jaw != nullptr && !jaw->finger.empty()) {
    all.clear();
    for (int f = 0; f < static_cast<int>(jaw->finger.size()); ++f) all.push_back(kFirstListedPad + f);
  }
  all.push_back(kSupport);
  for (int i = 0; i < static_cast<int>(scenario.cell.surface.size()); ++i) all.push_back(kFirstCellSurface + i);
  return all;
}

/// "left pad", "right pad", "support", "cell.surface.0", "gripper.finger.0" and so on.
inline std::string surface_name(int surface) {
  if (is_listed_pad(surface)) return "gripper.finger." + std::to_string(finger_of(surface));
  if (surface >= kFirstCellSurface) return "cell.surface." + std::to_string(surface - kFirstCellSurface);
  return std::string(geometry_of(surface).name);
}

/// The numbers and names of these surfaces in a trace: "0 left pad, 1 right pad, 2 support".
inline std::string surface_codes(const std::vector<int>& surfaces) {
  std::string text;
  for (std::size_t at = 0; at < surfaces.size(); ++at) {
    text += (at == 0 ? "" : ", ") + std::to_string(at) + " " + surface_name(surfaces[at]);
  }
  return text;
}

}  // namespace unbruised
