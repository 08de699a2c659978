#include <limits>

#include "core/contact/contact_lanes.hpp"
#include "core/contact/first_yield.hpp"

namespace unbruised {

// What a contact shows beside its forces.

namespace {

/// Of a cell's face that a contact must cover for its depth to count; a corner of a face covers a quarter.
constexpr double kLeastCover = 0.2;

}  // namespace

/// Notes how far the layer is pressed in at the deepest place, of which the cell takes its part.
void ContactLanes::note_layer_strain(std::size_t c, const CandidateStep& step) {
  const ContactCandidate& candidate = model_.candidate[c];
  if (candidate.area_m2 == 0.0) return;  // a particle's own layer has no thickness
  const SurfaceLane& surface = surfaces_[candidate.surface];
  const double cell_m2 = candidate.tributary[0].extent_m * candidate.tributary[1].extent_m;
  // A sliver of a cell under a pad's edge is measured at its particle, which stands beside the pad.
  const Mask measures =
      step.closed & (register_.share.get(c) * Lane(candidate.area_m2) > Lane(kLeastCover * cell_m2));
  const Lane depth = max0(step.penetration - Lane(candidate.least_relief_m));
  const Lane of_layer =
      Lane(1.0) / (Lane(1.0) + surface.stiffness_N_m3 * register_.body_compliance(c, surface.stiffness_N_m3));
  layer_strain_ = max(layer_strain_, select(measures, depth * of_layer / surface.thickness_m, Lane(0.0)));
}

Lane ContactLanes::lowest_place_m(int surface, const LaneArray& given) const {
  const LaneArray& u = seen_ ? seen_->from(carrier_number(surface)).u : given;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const Lane sign(normal_sign(surface));
  Lane lowest(std::numeric_limits<double>::infinity());
  for (const ContactCandidate& candidate : model_.candidate) {
    if (candidate.surface != surface) continue;
    const Lane place = Lane(candidate.surface_m) + u.get(3 * static_cast<std::size_t>(candidate.node) + axis);
    lowest = min(lowest, sign * place + Lane(candidate.least_relief_m));
  }
  return lowest;
}

Lane ContactLanes::layer_under_force_N_m3(int surface) const {
  Lane stiffness = surfaces_[surface].stiffness_N_m3;
  for (int lane = 0; lane < kLanes; ++lane) {
    const FaceLayer& layer = (is_pad(surface) ? pad_layer_ : support_layer_)[static_cast<std::size_t>(lane)];
    const double force_N = tally_[surface].normal[lane];
    if (layer.layer.is_springs() || !(force_N > 0.0)) continue;
    stiffness.set(lane, layer.stiffness_N_m3(force_N));
  }
  return stiffness;
}

Lane ContactLanes::yield_ratio(int surface, const Lane& yield_stress) const {
  const auto at = static_cast<std::size_t>(surface);
  return unbruised::yield_ratio(tally_[at], model_.patch_form[at], model_.cell_extent_m[at], surfaces_[surface],
                                layer_under_force_N_m3(surface), yield_stress);
}

std::array<double, 3> ContactLanes::surface_force(int surface, int lane) const {
  const std::array<Lane, 3> force = tally_[surface].force(surface);
  return {force[0][lane], force[1][lane], force[2][lane]};
}

}  // namespace unbruised
