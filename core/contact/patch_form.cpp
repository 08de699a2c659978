#include "core/contact/patch_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contact/half_space.hpp"
#include "core/contact/linear_table.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// Of the pressure of Hertz's patch.
constexpr double kHertzPeakOverMean = 1.5;

constexpr double kStripStep = 0.05;  ///< of half width over half thickness

/// Von Mises stress below the middle of a strip of Hertz over its mean pressure (Johnson 1985, 4.2), in a plane
/// body that a second strip presses from the other side: it counts as a line, and a round body between two lines
/// is pulled evenly by P / (pi R) across them and along them (Timoshenko and Goodier, disc between two forces).
/// @param depth over the half width @param width half width over half the thickness
double stress_below_strip(double depth, double width, double nu) {
  constexpr double pi = std::numbers::pi;
  const double peak = 4.0 / pi, root = std::sqrt(1.0 + depth * depth), pulled = 2.0 * width / pi;
  const double across = pulled - peak * ((1.0 + 2.0 * depth * depth) / root - 2.0 * depth);
  const double down = pulled - peak / root - 4.0 * width / (pi * (2.0 - depth * width));
  return von_mises({across, nu * (across + down), down, 0.0, 0.0, 0.0});
}

}  // namespace

StripPeak::StripPeak(double poisson_ratio) {
  constexpr double kLeast = 0.1, kStep = 0.01, kDeepest = 1.5;  // half widths below the skin; the peak lies at 0.7
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double width = kStripStep * static_cast<double>(i);
    for (double depth = kLeast; depth < kDeepest; depth += kStep) {
      peak_[i] = std::max(peak_[i], stress_below_strip(depth, width, poisson_ratio));
    }
  }
}

double StripPeak::at(double half_width_over_half_thickness) const {
  return BetweenEntries(half_width_over_half_thickness, kStripStep, kSteps).in(peak_);
}

namespace {

/// Of a patch of this area.
PatchForm form_of(const PatchArea& area, const LatticeParameters& product, std::size_t side,
                  const std::array<std::size_t, 2>& tangent, const std::array<double, 3>& center_m) {
  const TrueShape shape(product);
  const std::array<double, 3> pole_m = shape.pole_m(side);
  const std::array<double, 2> face_m = shape.face_extents_m(side);
  PatchForm form;
  form.area = area;
  form.plane_strain_modulus_Pa = plane_strain_modulus_Pa(product);
  for (std::size_t t = 0; t < 2; ++t) {
    form.middle_m[t] = center_m[tangent[t]] + pole_m[tangent[t]];
    form.half_face_m[t] = 0.5 * face_m[t];
  }
  // Second moments of a uniform rectangle L^2/12, of a Hertz ellipse a^2/5, of a Hertz strip a^2/4 across.
  switch (form.area.kind) {
    case PatchKind::flat:
      form.edge = PadEdge::of_flat(product.poisson_ratio);
      return form;
    case PatchKind::strip:
      form.area_factor = 4.0 * std::sqrt(12.0);
      form.edge = PadEdge::of_strip();
      form.strip_peak = StripPeak(product.poisson_ratio);
      form.half_thickness_m = 0.5 * product.size_m[side / 2];
      form.traction = TractionFactor::of_curved(product.poisson_ratio);
      return form;
    case PatchKind::ellipse:
      break;
  }
  const EllipticPatch patch{form.area.semi_axis[0], form.area.semi_axis[1], product.poisson_ratio};
  form.area_factor = 5.0 * std::numbers::pi;
  form.yield_factor = 1.0 / (kHertzPeakOverMean * peak_stress_below(patch));
  form.traction = TractionFactor::of_curved(product.poisson_ratio);
  form.field = PatchField(product.poisson_ratio);
  form.cross_section_m2 = shape.section_m2(side / 2);
  return form;
}

}  // namespace

PatchForm patch_form(const LatticeParameters& product, std::size_t side, const std::array<std::size_t, 2>& tangent,
                     const std::array<double, 3>& center_m) {
  return form_of(patch_area(product, side, tangent), product, side, tangent, center_m);
}

namespace {

PatchForm under_pad(const NetworkParameters& /*product*/, const ParallelJawParameters& /*jaw*/,
                    const PatchForm& before_plane) {
  return before_plane;
}

PatchForm under_pad(const LatticeParameters& product, const ParallelJawParameters& jaw,
                    const PatchForm& before_plane) {
  const PadFace face(jaw);
  PatchForm form = form_of(pad_patch_area(product, face), product, 0, {1, 2}, {});
  form.middle_m = before_plane.middle_m;
  form.bounded = true;
  if (jaw.pad.shape == PadShape::v_groove) {
    form.patches = 2.0;
    form.share = 0.5 / face.groove_cosine();
  }
  return form;
}

}  // namespace

PatchForm form_under_pad(const Scenario& scenario, const PatchForm& before_plane) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return before_plane;
  return std::visit([&](const auto& product) { return under_pad(product, *jaw, before_plane); }, scenario.product);
}

}  // namespace unbruised
