#include <limits>

#include "core/contact/contact_lanes.hpp"
#include "core/contact/first_yield.hpp"

namespace unbruised {

// What a contact shows beside its forces.

namespace {

/// Of a cell's face that a contact must cover for its depth to count; a corner of a face covers a quarter.
constexpr double kLeastCover = 0.2;
/// Peak of a pressure over the yield stress where the body below it first yields, of Hertz's on a sphere (Johnson
/// 1985, section 6.1); flatter ones take a tenth more.
constexpr double kPeakAtFirstYield = 1.6;
/// A force that has no place [N].
constexpr double kLeastForce_N = 1e-12;

}  // namespace

double ContactLanes::least_gap_m(int surface, int lane) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int side : side_candidate_) {
    const auto c = static_cast<std::size_t>(side);
    if (model_.candidate[c].surface == surface) least = std::min(least, register_.gap_now.at(c, lane));
  }
  return least;
}

/// Notes how far the layer is pressed in at the deepest place, of which the cell takes its part.
void ContactLanes::note_layer_strain(std::size_t c, const CandidateStep& step) {
  const ContactCandidate& candidate = model_.candidate[c];
  if (candidate.area_m2 == 0.0) return;  // a particle's own layer has no thickness
  const SurfaceLane& surface = surfaces_[candidate.surface];
  const double cell_m2 = candidate.tributary[0].extent_m * candidate.tributary[1].extent_m;
  // A sliver of a cell under a pad's edge is measured at its particle, which stands beside the pad.
  const Mask measures =
      step.closed & (register_.share.get(c) * Lane(candidate.area_m2) > Lane(kLeastCover * cell_m2));
  const Lane depth = max0(step.penetration - register_.least_relief(c));
  const Lane of_layer = Lane(1.0) / (Lane(1.0) + surface.stiffness_N_m3 * register_.body_compliance(c, surface));
  Lane pressed = depth * of_layer;
  if (pads_ && pads_->has(c)) {
    const Lane back = -Lane(normal_sign(candidate.surface)) *
                      pads_->next_m(c, static_cast<std::size_t>(normal_axis(candidate.surface)));
    pressed += max0(back);
  }
  layer_strain_ = max(layer_strain_, select(measures, pressed / surface.thickness_m, Lane(0.0)));
  if (!surface.curve.any()) return;
  const Lane deepest_Pa = surface.stiffness_N_m3 * of_layer * surface.curve.at(depth);
  Lane& so_far = tally_[candidate.surface].deepest_Pa;
  so_far = max(so_far, select(measures & surface.curve.lanes(), deepest_Pa, Lane(0.0)));
}

/// Notes when within the step a pad's contact closed.
void ContactLanes::note_touch(std::size_t c, const CandidateStep& step) {
  const Mask touched = step.closed & !register_.was_closed.get(c);
  const Lane gap = max0(register_.gap_now.get(c));
  const Lane fraction = gap / max(gap - register_.gap_free.get(c), Lane(1e-300));
  const std::size_t pad = finger_of(model_.candidate[c].surface);
  touched_[pad] = min(touched_[pad], select(touched, min(fraction, Lane(1.0)), Lane(2.0)));
  const Mask opened = register_.was_closed.get(c) & !step.closed;
  if (none(opened)) return;
  const Lane least = register_.least_relief(c);
  const Lane before = max0(step.penetration_before - least), after = register_.penetration_theta.get(c) - least;
  const Lane way = before - after;
  const Lane left = select(after < Lane(0.0), before / max(way, Lane(1e-300)), Lane(1.0));
  left_[pad] = max(left_[pad], select(opened, left, Lane(-1.0)));
}

/// Measures the pressure in windows over one surface.
void ContactLanes::measure_windows(int surface, const ContactEnd& end, const Mask& running) {
  if (model_.has_places(surface)) {
    measure_place_windows(surface, running);
    return;
  }
  const auto at = static_cast<std::size_t>(surface);
  if (model_.face[at].candidate.empty() || none(running & (tally_[at].normal > Lane(0.0)))) return;
  // The face moves past the surface as the particles that carry force do.
  const auto tangents = tangent_axes(surface);
  Lane force(0.0);
  std::array<Lane, 2> moved{Lane(0.0), Lane(0.0)};
  for (const int c : sweep_.live_candidates()) {
    const auto k = static_cast<std::size_t>(c);
    if (model_.candidate[k].surface != surface) continue;
    const Lane normal = max0(register_.normal.get(k));
    const auto node = 3 * static_cast<std::size_t>(model_.candidate[k].node);
    force += normal;
    for (std::size_t t = 0; t < 2; ++t)
      moved[t] += normal * end.u.get(node + static_cast<std::size_t>(tangents[t]));
  }
  std::array<Stretch, 2> reach;
  for (std::size_t t = 0; t < 2; ++t) {
    const Lane mean = moved[t] / max(force, Lane(kLeastForce_N));
    const Stretch there = surfaces_.reach(surface, end.next, t);
    reach[t] = {there.low - mean, there.high - mean};
  }
  const Mask carrying = running & (force > Lane(0.0));
  const Lane largest = window_[at].largest_Pa(register_.normal, reach, carrying);
  patch_pressure_ = max(patch_pressure_, select(carrying, largest, Lane(0.0)));
}

Lane ContactLanes::lowest_place_m(int surface, const LaneArray& given) const {
  if (model_.has_places(surface)) return lowest_seen_place_m(surface, given);
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

/// In the frame that fits, which was seen last.
Lane ContactLanes::lowest_seen_place_m(int surface, const LaneArray& u) const {
  Lane lowest(std::numeric_limits<double>::infinity());
  for (const ContactCandidate& candidate : model_.candidate) {
    if (candidate.surface != surface) continue;
    const LaneVector there =
        places_->displacement(candidate, get_vector(u, static_cast<std::size_t>(candidate.node)));
    lowest = min(lowest, Lane(candidate.surface_m) + there[static_cast<std::size_t>(normal_axis(surface))]);
  }
  return lowest;
}

Lane ContactLanes::layer_under_force_N_m3(int surface) const {
  Lane stiffness = surfaces_[surface].backing_N_m3;
  if (is_of_cell_list(surface)) return stiffness;
  for (int lane = 0; lane < kLanes; ++lane) {
    const FaceLayer& layer = (is_pad(surface) ? pad_layer_ : support_layer_)[static_cast<std::size_t>(lane)];
    const double force_N = tally_[surface].normal[lane];
    if (layer.layer.is_springs() || !(force_N > 0.0)) continue;
    stiffness.set(lane, layer.stiffness_N_m3(force_N));
  }
  return stiffness;
}

std::size_t ContactLanes::face_side(int surface, int lane) const {
  if (!model_.has_places(surface)) return facing_side(surface);
  const auto& [across_x, across_z, at_low] = faces_[static_cast<std::size_t>(surface)];
  return (across_x[lane] ? 0 : across_z[lane] ? 4 : 2) + (at_low[lane] ? 0 : 1);
}

Lane ContactLanes::yield_ratio(int surface, const Lane& yield_stress) const {
  const Lane layer_N_m3 = layer_under_force_N_m3(surface);
  Lane ratio(0.0);
  for (int lane = 0; lane < kLanes; ++lane) {
    const std::size_t axis = face_side(surface, lane) / 2;
    const PressedFace face{tally_[surface], form_under(surface, lane), model_.cell_extent_m[axis],
                           surfaces_[surface], is_pad(surface) || !model_.has_places(surface)};
    ratio.set(lane, unbruised::yield_ratio(face, layer_N_m3[lane], yield_stress[lane], lane));
  }
  // Under a cushion that closes up the pressure has a peak which a mean over its patch does not show.
  if (surfaces_[surface].curve.any())
    ratio = max(ratio, tally_[surface].deepest_Pa / (Lane(kPeakAtFirstYield) * yield_stress));
  return ratio;
}

std::optional<FacedPlane> ContactLanes::faced_plane(int surface, int lane, const CarrierMotion& now) const {
  const SurfaceLane& lanes = surfaces_[surface];
  if (!model_.has_places(surface) || !lanes.present[lane] || lanes.has_rim[lane]) return std::nullopt;
  const double place_m = carrier_of(surface, now)[static_cast<std::size_t>(normal_axis(surface))].place_m[lane];
  return FacedPlane{of_lane(places_->normal(surface), lane), place_m,
                    places_->center_height(surface)[lane] - place_m};
}

const PatchForm& ContactLanes::patch_form(int surface, int lane) const { return form_under(surface, lane); }

LaneVector ContactLanes::carrier_force(int surface) const {
  const LaneVector force{tally_[surface].force(surface)};
  return has_own_axes(surface) ? transposed(surfaces_[surface].axes) * force : force;
}

std::array<double, 3> ContactLanes::surface_force(int surface, int lane) const {
  return of_lane(carrier_force(surface), lane);
}

Lane ContactLanes::first_touch() const {
  Lane first = touched_[0];
  for (std::size_t f = 1; f < model_.finger_count(); ++f) first = min(first, touched_[f]);
  return first;
}

}  // namespace unbruised
