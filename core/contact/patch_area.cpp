#include "core/contact/patch_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scenario/relaxation.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {

double PatchArea::ellipse_m2(double force_N, double layer_N_m3) const {
  const double root = std::cbrt(force_N), hertz = body * root * root;
  return std::sqrt(hertz * hertz + layer * force_N / layer_N_m3);
}

double PatchArea::half_width_m(double line_N_m, double layer_N_m3) const {
  const double hertz = body * line_N_m;
  return std::cbrt(hertz * std::sqrt(hertz) + layer * line_N_m / layer_N_m3);
}

double plane_strain_modulus_Pa(const LatticeParameters& product) {
  return instantaneous_modulus_Pa(product) / (1.0 - product.poisson_ratio * product.poisson_ratio);
}

PatchArea ellipse_area(const std::array<double, 2>& radius_m, double plane_strain_modulus_Pa) {
  const double flatter = std::max(radius_m[0], radius_m[1]), sharper = std::min(radius_m[0], radius_m[1]);
  // Axis ratio q = b / a <= 1 from sharper / flatter = (K - E) / (E / q^2 - K), eccentricity e = sqrt(1 - q^2).
  const auto K = [](double q) { return std::comp_ellint_1(std::sqrt(1.0 - q * q)); };
  const auto E = [](double q) { return std::comp_ellint_2(std::sqrt(1.0 - q * q)); };
  double q = 1.0, shape = 1.0;  // shape: sqrt(a b)^3 / (3 F sqrt(R' R'') / (4 E*))
  if (flatter > 1.0001 * sharper) {
    double low = 1e-3, high = 1.0 - 1e-6;
    for (int i = 0; i < 60; ++i) {
      q = 0.5 * (low + high);
      ((K(q) - E(q)) / (E(q) / (q * q) - K(q)) < sharper / flatter ? low : high) = q;
    }
    shape = 4.0 / (std::numbers::pi * (1.0 - q * q)) * std::pow(q, 1.5) *
            std::sqrt((E(q) / (q * q) - K(q)) * (K(q) - E(q)));
  }
  const double mean_radius = std::sqrt(flatter * sharper);
  PatchArea area;
  area.kind = PatchKind::ellipse;
  area.body = std::numbers::pi * std::pow(0.75 * mean_radius / plane_strain_modulus_Pa * shape, 2.0 / 3.0);
  // Solved ring by ring for a body with a layer: the peak stress below is that of a Hertz patch of this area,
  // within 1 % while the layer gives less than the body, within 8 % for any layer (docs/theory.md, "First yield").
  area.layer = 0.9 * std::numbers::pi * std::numbers::pi * mean_radius;
  const bool first_flatter = radius_m[0] >= radius_m[1];
  area.semi_axis = {std::sqrt((first_flatter ? 1.0 / q : q) / std::numbers::pi),
                    std::sqrt((first_flatter ? q : 1.0 / q) / std::numbers::pi)};
  return area;
}

PatchArea strip_area(double radius_m, double plane_strain_modulus_Pa, std::size_t straight) {
  PatchArea area;
  area.kind = PatchKind::strip;
  area.body = 4.0 * radius_m / (std::numbers::pi * plane_strain_modulus_Pa);  // b^2 = h F/L
  // Of a parabolic pressure of springs, b^3 = 3/2 R (F/L) / k. Solved as a plane problem, the peak stress below is
  // that of a Hertz strip of this width, within 1 % from k R = 1.8 E* on and within 4 % for any softer layer.
  area.layer = 1.5 * radius_m;
  area.straight = straight;
  return area;
}

std::array<double, 2> relative_curvature_1_m(const LatticeParameters& product, const PadFace& pad) {
  const TrueShape shape(product);
  std::array<double, 2> curvature = pad.curvature_1_m();
  for (std::size_t t = 0; t < 2; ++t) {
    if (shape.curves(0, 1 + t)) curvature[t] += 1.0 / shape.pole_radius_m(0, 1 + t);
    // Both fit each other: the patch ends where the pad does.
    constexpr double kFlat = 0.02;
    if (curvature[t] * pad.half_size_m()[t] < kFlat) curvature[t] = 0.0;
  }
  return curvature;
}

PatchArea pad_patch_area(const LatticeParameters& product, const PadFace& pad) {
  const std::array<double, 2> curvature = relative_curvature_1_m(product, pad);
  const double modulus = plane_strain_modulus_Pa(product);
  if (curvature[0] == 0.0 && curvature[1] == 0.0) return {};
  if (curvature[0] == 0.0) return strip_area(1.0 / curvature[1], modulus, 0);
  if (curvature[1] == 0.0) return strip_area(1.0 / curvature[0], modulus, 1);
  return ellipse_area({1.0 / curvature[0], 1.0 / curvature[1]}, modulus);
}

PatchArea patch_area(const LatticeParameters& product, std::size_t side,
                     const std::array<std::size_t, 2>& tangent) {
  const TrueShape shape(product);
  const double modulus = plane_strain_modulus_Pa(product);
  switch (shape.curvatures(side)) {
    case 0:
      return {};
    case 1: {
      const std::size_t straight = shape.curves(side, tangent[0]) ? 1 : 0;
      return strip_area(shape.pole_radius_m(side, tangent[1 - straight]), modulus, straight);
    }
    default:
      return ellipse_area({shape.pole_radius_m(side, tangent[0]), shape.pole_radius_m(side, tangent[1])}, modulus);
  }
}

}  // namespace unbruised
