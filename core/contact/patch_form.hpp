#pragma once

/// @file
/// What all scenarios of a factor key share about the patch of one face, and how it yields first (docs/theory.md,
/// "First yield").

#include <array>
#include <cstddef>

#include "core/contact/pad_edge.hpp"
#include "core/contact/patch_area.hpp"
#include "core/contact/patch_field.hpp"
#include "core/contact/patch_traction.hpp"

namespace unbruised {

/// Peak stress of a strip over its mean pressure, by its half width over half the body's thickness: the body lies
/// between two of them, which pull it apart across.
class StripPeak {
 public:
  StripPeak() = default;
  explicit StripPeak(double poisson_ratio);
  [[nodiscard]] double at(double half_width_over_half_thickness) const;

 private:
  static constexpr std::size_t kSteps = 17;
  std::array<double, kSteps> peak_{};
};

/// How a patch pressed against a flat surface is shaped, and where it yields first.
struct PatchForm {
  PatchArea area;
  /// Area of the patch = area_factor x sqrt(det of the second moments of its pressure).
  double area_factor = 12.0;
  /// Mean pressure at first yield / yield stress, of a patch that carries no traction, where neither edge nor body
  /// ends near it.
  double yield_factor = 1.0;
  TractionFactor traction = TractionFactor::of_flat();
  PadEdge edge;
  double plane_strain_modulus_Pa = 0.0;
  /// The side's pole and half its face's extents, along the tangents.
  std::array<double, 2> middle_m{0.0, 0.0}, half_face_m{0.0, 0.0};
  /// Of a strip.
  StripPeak strip_peak;
  double half_thickness_m = 0.0;
  /// Stress around the pole of an ellipse, and the body's cross-section in its middle, along the face [m2]; 0: no
  /// such pole.
  PatchField field{0.3};
  double cross_section_m2 = 0.0;
  /// Of a shaped pad: bounded by what lies under it.
  bool bounded = false;
  /// Patches that share the force, in a groove two, and how much of it each carries.
  double patches = 1.0, share = 1.0;
};

/// Of the face under the pads of a scenario, from that before a plane.
PatchForm form_under_pad(const Scenario& scenario, const PatchForm& before_plane);

/// Of a side. @param tangent the two axes across it @param center_m of the product's true shape
PatchForm patch_form(const LatticeParameters& product, std::size_t side, const std::array<std::size_t, 2>& tangent,
                     const std::array<double, 3>& center_m);

}  // namespace unbruised
