#pragma once

/// @file
/// What a cell holds beside the support: planes and rectangles that the product can touch, as the bottom and the
/// walls of a tray. Plain data in SI, measured from where the support's plane lies under the product's middle at
/// the start.

#include <array>
#include <optional>
#include <vector>

namespace unbruised {

/// That a cell may list.
inline constexpr int kMostCellSurfaces = 8;

/// A plane or a rectangle that is touched on one side.
struct CellSurfaceParameters {
  /// Middle of the rectangle; any place of a plane.
  std::array<double, 3> center_m{0.0, 0.0, 0.0};
  /// Not zero; of any length, towards the side on which it is touched.
  std::array<double, 3> normal{0.0, 0.0, 1.0};
  /// > 0; extents of the rectangle: along the direction in its plane that is nearest to x (to y where the normal
  /// lies along x), and across that. None: a plane.
  std::optional<std::array<double, 2>> size_m;
  /// >= 0
  double friction = 0.5;
  /// > 0; Young's modulus of its compliant layer, springs as those of the support
  double modulus_Pa = 2e6;
  /// > 0; of that layer
  double thickness_m = 0.005;
  /// >= 0
  double relaxation_time_s = 0.0;
  /// Rising, >= 0, as long as path_m; from one place to the next by minimum jerk, at rest before and after.
  std::vector<double> path_time_s;
  /// Where it has moved to by then; the first is where it stands at the start.
  std::vector<std::array<double, 3>> path_m;
};

/// Its axes as rows: the two directions of its extents, and its normal.
std::array<std::array<double, 3>, 3> surface_axes(const CellSurfaceParameters& surface);

}  // namespace unbruised
