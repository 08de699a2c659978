#include "core/contact/first_yield.hpp"

#include <cmath>

namespace unbruised {
namespace {

/// Forces below this have no patch [N].
constexpr double kLeastForce = 1e-9;

/// Area of the patch from the second moments of its pressure.
Lane lattice_patch_area(const SurfaceTally& t, const PatchForm& form, const std::array<double, 2>& extent_m) {
  const Lane force = max(t.normal, Lane(kLeastForce));
  const Lane y = t.first[0] / force, z = t.first[1] / force;
  // The moments of one loaded particle vanish; its force still spreads over its tributary rectangle.
  const Lane least_y(extent_m[0] * extent_m[0] / 12.0);
  const Lane least_z(extent_m[1] * extent_m[1] / 12.0);
  const Lane yy = max(t.second[0] / force - y * y, least_y);
  const Lane zz = max(t.second[1] / force - z * z, least_z);
  const Lane yz = t.second[2] / force - y * z;
  return Lane(form.area_factor) * sqrt(max(yy * zz - yz * yz, least_y * least_z));
}

/// Area that an elastic body makes at a pole, with the surface's layer.
Lane elastic_patch_area(const Lane& force, const PatchForm& form, const SurfaceLane& surface) {
  Lane hertz(0.0);
  for (int lane = 0; lane < kLanes; ++lane) {
    const double root = std::cbrt(force[lane]);
    hertz.set(lane, form.hertz_area_m2_N23 * root * root);
  }
  return sqrt(hertz * hertz + Lane(form.layer_area_m) * force / surface.stiffness_N_m3);
}

Lane patch_area(const SurfaceTally& tally, const PatchForm& form, const std::array<double, 2>& extent_m,
                const SurfaceLane& surface) {
  const Lane lattice = lattice_patch_area(tally, form, extent_m);
  if (form.hertz_area_m2_N23 == 0.0) return lattice;
  // A patch about as large as a cell is not resolved by the lattice: elasticity gives its area at the measured
  // force. Where it reaches past a pad the lattice takes over, in proportion: by then it spans the pad's many
  // cells.
  const Lane elastic = elastic_patch_area(max(tally.normal, Lane(kLeastForce)), form, surface);
  Lane under_pad(1.0);
  for (std::size_t i = 0; i < 2; ++i) {
    const Lane half = Lane(form.semi_axis[i]) * sqrt(elastic);
    const Lane place = Lane(form.pole_m[i]) - surface.center_m[i];
    under_pad *= overlap(place, half, Lane(0.5) * surface.size_m[i]) / (Lane(2.0) * half);
  }
  return under_pad * elastic + (Lane(1.0) - under_pad) * lattice;
}

}  // namespace

Lane yield_ratio(const SurfaceTally& tally, const PatchForm& form, const std::array<double, 2>& extent_m,
                 const SurfaceLane& surface, const Lane& yield_stress) {
  const Lane area = max(patch_area(tally, form, extent_m, surface), Lane(1e-30));
  const Lane strength = Lane(form.yield_factor) * yield_stress;
  const Lane traction = sqrt(tally.tangent[0] * tally.tangent[0] + tally.tangent[1] * tally.tangent[1]);
  const Lane factor = form.traction.at(traction / max(tally.normal, Lane(kLeastForce)));
  return select(tally.normal > Lane(kLeastForce), factor * tally.normal / (area * strength), Lane(0.0));
}

}  // namespace unbruised
