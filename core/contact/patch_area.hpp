#pragma once

/// @file
/// The area of the patch that a face of an elastic body makes on a flat surface, in closed form (docs/theory.md,
/// "First yield").

#include <array>
#include <cstddef>

#include "core/scenario/pad_face.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// By along how many directions the face curves.
enum class PatchKind { flat, strip, ellipse };

/// How large a patch is at a force. Body and layer are the two parts of it: an ellipse A^2 = (h F^(2/3))^2 + l
/// F/k, a strip of length L and half width b: b^3 = (h F/L)^(3/2) + l (F/L)/k; the areas under which the peak
/// stress in the body is that of Hertz's pressure.
struct PatchArea {
  PatchKind kind = PatchKind::flat;
  double body = 0.0;                          ///< h
  double layer = 0.0;                         ///< l
  std::array<double, 2> semi_axis{0.0, 0.0};  ///< of an ellipse, along the tangents / sqrt(A)
  std::size_t straight = 0;                   ///< tangent along which a strip does not curve

  /// Of an ellipse [m2]. @param layer_N_m3 stiffness of the layer per area
  [[nodiscard]] double ellipse_m2(double force_N, double layer_N_m3) const;
  /// Of a strip [m]. @param line_N_m force per length
  [[nodiscard]] double half_width_m(double line_N_m, double layer_N_m3) const;
};

/// E / (1 - nu^2) [Pa].
double plane_strain_modulus_Pa(const LatticeParameters& product);

/// Of a side. @param tangent the two axes across it
PatchArea patch_area(const LatticeParameters& product, std::size_t side,
                     const std::array<std::size_t, 2>& tangent);

/// Of the face that meets the pads, by the relative curvature of both, 1 / R' + 1 / R'' along each tangent: kind
/// of a patch, an ellipse where both curve apart, a strip where one does, flat where the face of the pad fits the
/// product.
PatchArea pad_patch_area(const LatticeParameters& product, const PadFace& pad);
/// Relative curvatures along y and z, not negative [1/m]; less than a circle of fifty times the pad counts as
/// none.
std::array<double, 2> relative_curvature_1_m(const LatticeParameters& product, const PadFace& pad);

/// Of an elastic ellipsoid of the given principal radii pressed against a plane (Johnson 1985, 4.2).
/// @param radius_m radii of curvature at the pole along the two tangents
PatchArea ellipse_area(const std::array<double, 2>& radius_m, double plane_strain_modulus_Pa);

/// Of an elastic cylinder (Johnson 1985, 4.2). @param straight tangent along its axis
PatchArea strip_area(double radius_m, double plane_strain_modulus_Pa, std::size_t straight);

}  // namespace unbruised
