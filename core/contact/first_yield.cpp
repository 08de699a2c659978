#include "core/contact/first_yield.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

/// Forces below this have no patch [N].
constexpr double kLeastForce = 1e-9;
/// Along half the pad's side: an edge that is farther than this from that of the face acts in full.
constexpr double kEdgeReach = 0.25;
/// Half a surface that ends nowhere near a face.
constexpr double kWithoutEnd_m = 1e6;

/// One lane's patch.
struct PressedPatch {
  double force_N, traction_N;
  std::array<double, 2> middle_m;   ///< of the pressure, along the tangents
  std::array<double, 3> spread_m2;  ///< its second moments: yy, zz, yz
  std::array<double, 2> offset_m;   ///< of the pad's middle from that of the face
  std::array<double, 2> half_pad_m;
  double edge_radius_m, layer_N_m3;
  double covered_m2;  ///< that bounds it, per patch of a shaped pad; 0: nothing does
};

PressedPatch pressed_patch(const PressedFace& face, int lane) {
  const auto& [t, form, extent_m, surface, ends_within] = face;
  PressedPatch patch{};
  patch.force_N = std::max(t.normal[lane], kLeastForce);
  patch.covered_m2 = 0.0;
  patch.traction_N = std::sqrt(t.tangent[0][lane] * t.tangent[0][lane] + t.tangent[1][lane] * t.tangent[1][lane]);
  for (std::size_t i = 0; i < 2; ++i) {
    patch.middle_m[i] = t.first[i][lane] / patch.force_N;
    // The moments of one loaded particle vanish; its force still spreads over its tributary rectangle.
    const double square = t.second[i][lane] / patch.force_N - patch.middle_m[i] * patch.middle_m[i];
    patch.spread_m2[i] = std::max(square, extent_m[i] * extent_m[i] / 12.0);
    patch.offset_m[i] = ends_within ? surface.center_m[i][lane] - form.middle_m[i] : 0.0;
    patch.half_pad_m[i] = ends_within ? 0.5 * surface.size_m[i][lane] : kWithoutEnd_m;
  }
  patch.spread_m2[2] = t.second[2][lane] / patch.force_N - patch.middle_m[0] * patch.middle_m[1];
  patch.edge_radius_m = surface.edge_radius_m[lane];
  return patch;
}

/// From the second moments of its pressure.
double lattice_area_m2(const PressedPatch& p, const PatchForm& form, const std::array<double, 2>& extent_m) {
  const double least = extent_m[0] * extent_m[0] / 12.0 * (extent_m[1] * extent_m[1] / 12.0);
  const double determinant = p.spread_m2[0] * p.spread_m2[1] - p.spread_m2[2] * p.spread_m2[2];
  return form.area_factor * std::sqrt(std::max(determinant, least));
}

/// Part of a stretch of this half length around the middle of the face that lies under the pad.
double part_under_pad(const PressedPatch& p, double half_m, std::size_t t) {
  const double low = std::max(-half_m, p.offset_m[t] - p.half_pad_m[t]);
  const double high = std::min(half_m, p.offset_m[t] + p.half_pad_m[t]);
  return std::max(0.0, high - low) / (2.0 * half_m);
}

/// Of the face [m].
double covered_m(const PressedPatch& p, const PatchForm& form, std::size_t t) {
  return 2.0 * form.half_face_m[t] * part_under_pad(p, form.half_face_m[t], t);
}

double bounded_m2(const PressedPatch& p, double area_m2) {
  return p.covered_m2 > 0.0 ? std::min(area_m2, p.covered_m2) : area_m2;
}

/// 0: the pad's edges lie at those of the face or beyond, 1: at least one well within it.
double edges_within(const PressedPatch& p, const PatchForm& form, std::size_t t) {
  const double room = form.half_face_m[t] + std::abs(p.offset_m[t]) - p.half_pad_m[t];
  return std::clamp(room / (kEdgeReach * p.half_pad_m[t]), 0.0, 1.0);
}

/// A rounded edge leaves the face where the layer is not pressed in as deep as it has receded: what is left of the
/// pad's half side carries more.
double rounded_edges(const PressedPatch& p, double mean_pressure_Pa) {
  if (!(p.edge_radius_m > 0.0)) return 1.0;
  const double depth = mean_pressure_Pa / p.layer_N_m3;
  const double receded = std::max(0.0, p.edge_radius_m - std::sqrt(2.0 * p.edge_radius_m * depth));
  double more = 1.0;
  for (const double half : p.half_pad_m) more *= std::sqrt(half / std::max(half - receded, 0.2 * half));
  return more;
}

double flat_stress_Pa(const PressedPatch& p, const PatchForm& form, const std::array<double, 2>& extent_m) {
  const double covered_m2 = covered_m(p, form, 0) * covered_m(p, form, 1);
  // Pressure that rises to an edge has larger moments than an even one: no patch is larger than what is covered.
  const double lattice = lattice_area_m2(p, form, extent_m);
  const double mean = p.force_N / (covered_m2 > 0.0 ? std::min(lattice, covered_m2) : lattice);
  const double within = edges_within(p, form, 0) * edges_within(p, form, 1);
  if (within == 0.0) return mean;
  const double half = std::min(p.half_pad_m[0], p.half_pad_m[1]);
  const double peak = form.edge.at(p.layer_N_m3 * half / form.plane_strain_modulus_Pa) * rounded_edges(p, mean);
  return mean * (1.0 + within * std::max(0.0, peak - 1.0));
}

double strip_stress_Pa(const PressedPatch& p, const PatchForm& form, const std::array<double, 2>& extent_m) {
  const std::size_t along = form.area.straight, across = 1 - along;
  const double even_m = std::sqrt(12.0 * p.spread_m2[along]);  // long, if it is evenly pressed
  const double length = std::max(std::min(covered_m(p, form, along), even_m), extent_m[along]);
  const double half_width = form.area.half_width_m(p.force_N / length, p.layer_N_m3);
  const double under_pad = part_under_pad(p, half_width, across);
  const double area = under_pad * bounded_m2(p, 2.0 * half_width * length) +
                      (1.0 - under_pad) * bounded_m2(p, lattice_area_m2(p, form, extent_m));
  const double within = edges_within(p, form, along);
  const double lambda = p.layer_N_m3 * p.half_pad_m[along] / form.plane_strain_modulus_Pa;
  const double middle =
      form.strip_peak.at(half_width / form.half_thickness_m) * (1.0 - (1.0 - PadEdge::kMiddleOfStrip) * within);
  const double mean = p.force_N / area;
  const double edge =
      form.strip_peak.at(0.0) * (1.0 + within * (form.edge.at(lambda) * rounded_edges(p, mean) - 1.0));
  return mean * std::max(middle, edge);
}

double ellipse_stress_Pa(const PressedPatch& p, const PatchForm& form, const std::array<double, 2>& extent_m) {
  // A patch about as large as a cell is not resolved by the lattice: elasticity gives its area at the measured
  // force. Where it reaches past a pad the lattice takes over, in proportion: by then it spans the pad's many
  // cells.
  const double elastic = form.area.ellipse_m2(p.force_N, p.layer_N_m3);
  double under_pad = 1.0;
  for (std::size_t t = 0; t < 2; ++t)
    under_pad *= part_under_pad(p, form.area.semi_axis[t] * std::sqrt(elastic), t);
  const double area =
      under_pad * bounded_m2(p, elastic) + (1.0 - under_pad) * bounded_m2(p, lattice_area_m2(p, form, extent_m));
  return p.force_N / (area * form.yield_factor);
}

double stress_Pa(const PressedPatch& p, const PatchForm& form, const std::array<double, 2>& extent_m) {
  switch (form.area.kind) {
    case PatchKind::flat:
      return flat_stress_Pa(p, form, extent_m);
    case PatchKind::strip:
      return strip_stress_Pa(p, form, extent_m);
    case PatchKind::ellipse:
      break;
  }
  return ellipse_stress_Pa(p, form, extent_m);
}

}  // namespace

double yield_ratio(const PressedFace& face, double layer_N_m3, double yield_stress_Pa, int lane) {
  if (!(face.tally.normal[lane] > kLeastForce)) return 0.0;
  PressedPatch patch = pressed_patch(face, lane);
  patch.layer_N_m3 = layer_N_m3;
  const double dragged = face.form.traction.at(patch.traction_N / patch.force_N);
  if (face.form.bounded) {
    patch.covered_m2 = covered_m(patch, face.form, 0) * covered_m(patch, face.form, 1) / face.form.patches;
    patch.force_N *= face.form.share;
  }
  return dragged * stress_Pa(patch, face.form, face.extent_m) / yield_stress_Pa;
}

}  // namespace unbruised
