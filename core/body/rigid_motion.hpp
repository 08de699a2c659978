#pragma once

/// @file
/// The rigid part of a displacement field: what is left of a deformation after it is taken away is shape change.

#include <array>
#include <span>

namespace unbruised {

/// Small motion of a body, u(x) = translation + rotation x (x - centroid).
struct RigidMotion {
  /// Of the centroid [m].
  std::array<double, 3> translation{0.0, 0.0, 0.0};
  /// Rotation vector [rad].
  std::array<double, 3> rotation{0.0, 0.0, 0.0};
};

/// The rigid motion nearest to a displacement field: min sum_i |u_i - t - w x (x_i - centroid)|^2, all
/// particles of equal weight. Rotations that leave the points in place (about the line of collinear points,
/// any rotation of a single point) are zero.
/// @param position_m n places
/// @param displacement_m 3 n values, freedom 3 i + axis
/// @throws std::invalid_argument when the sizes do not fit.
RigidMotion best_fit_rigid_motion(std::span<const std::array<double, 3>> position_m,
                                  std::span<const double> displacement_m);

/// Subtracts the best-fit rigid motion from a displacement field in place; sizes as above.
void remove_rigid_motion(std::span<const std::array<double, 3>> position_m, std::span<double> displacement_m);

}  // namespace unbruised
