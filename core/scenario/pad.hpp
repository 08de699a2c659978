#pragma once

/// @file
/// What the pads of a gripper are made of, and how their faces are shaped.

#include <optional>
#include <vector>

namespace unbruised {

enum class PadKind {
  layer,    ///< a rigid plate with a compliant layer
  lattice,  ///< a body of its own, bonded to the finger
};

/// The form of a pad's face.
enum class PadShape {
  flat,
  cylinder,  ///< convex, or a cradle where its radius is negative
  v_groove,
  sphere,
  profile,  ///< given heights over the place across it
};

/// In which direction a cylinder, a groove or a profile is straight.
enum class PadAlong { y, z };

/// Size, thickness, modulus, Poisson's ratio and relaxation time stand beside it in the gripper.
struct PadParameters {
  PadKind kind = PadKind::layer;
  PadShape shape = PadShape::flat;
  PadAlong along = PadAlong::z;
  /// > 0: the face bulges towards the product; < 0: it is hollow. Required of a cylinder and a sphere.
  std::optional<double> radius_m;
  /// > 0, < pi / 2; between a face of a V groove and the plane in its middle. Required of a V groove.
  std::optional<double> half_angle_rad;
  /// Ascending, as many as heights, two at least; required of a profile. Across the direction in which it is
  /// straight.
  std::vector<double> profile_place_m;
  /// Towards the product, linear between the places
  std::vector<double> profile_height_m;
  /// A measured law of the layer, its depth and force against a flat plate: ascending from 0, or
  std::vector<double> law_depth_m;
  std::vector<double> law_force_N;
  /// the coefficients of depth, depth^2 and so on [N/m, N/m2, ...]. Neither: the layer follows from its modulus.
  std::vector<double> law_coefficients;
  /// > 0; side of the cells of a lattice pad
  std::optional<double> cell_size_m;
  /// > 0; of a lattice pad
  double density_kg_m3 = 1100.0;
};

}  // namespace unbruised
