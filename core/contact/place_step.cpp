#include <algorithm>

#include "core/contact/contact_lanes.hpp"

namespace unbruised {

// How the places of a product's true surface go through a step (docs/theory.md, "Places that touch").

namespace {

/// A tangential coordinate this far within a rectangle's edge, as a share of a place's extent, counts whole.
Lane share_within(const Lane& place, const Lane& size, double extent_m) {
  const Lane inside = (Lane(0.5) * size - abs(place)) * Lane(1.0 / extent_m) + Lane(0.5);
  return max0(min(inside, Lane(1.0)));
}

}  // namespace

/// The candidates of a node with one surface stand side by side. Those that sleep are looked at closely only when
/// they come near.
void ContactLanes::meet_places(std::size_t node, const ContactStart& start, const Mask& running) {
  const auto last = static_cast<std::size_t>(model_.first_candidate[node + 1]);
  auto c = static_cast<std::size_t>(model_.first_candidate[node]);
  while (c < last) {
    const int surface = model_.candidate[c].surface;
    std::size_t end = c + 1;
    while (end < last && model_.candidate[end].surface == surface) ++end;
    if (model_.candidate[c].place >= 0) {
      int& awake = awake_[node * kSurfaceCount + static_cast<std::size_t>(surface)];
      const bool all_far = is_far(node, surface, start);
      for (std::size_t k = c; (awake > 0 || !all_far) && k < end; ++k) {
        const bool far = all_far || is_far(k, start);
        if (far && asleep_[k] != 0) continue;
        meet_place(k, start, running);
        const bool sleeps = far && none(register_.normal.get(k) > Lane(0.0));
        awake += (asleep_[k] != 0 ? 1 : 0) - (sleeps ? 1 : 0);
        asleep_[k] = sleeps ? 1 : 0;
      }
    }
    c = end;
  }
}

/// Are all places of a node too far from a surface to come near it within the step, in every lane?
bool ContactLanes::is_far(std::size_t node, int surface, const ContactStart& start) const {
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const LaneVector u = get_vector(start.free.displacement, node);
  const LaneVector seen = places_->axes(surface).displacement(seen_->rest_place_m(*frame_, node), u);
  const Lane height = Lane(body_.position_m[static_cast<std::size_t>(model_.node[node])][axis]) + seen[axis] -
                      place_free_[surface];
  // A body that turns within the step turns the arms, by less than twice their length.
  return none(surfaces_[surface].present & (height < near_margin_ + Lane(2.0 * model_.place_radius_m[node])));
}

/// Is this place?
bool ContactLanes::is_far(std::size_t c, const ContactStart& start) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const LaneVector u = get_vector(start.free.displacement, static_cast<std::size_t>(candidate.contact_node));
  const Lane gap = places_->height(candidate, u, free_turn_) - place_free_[candidate.surface];
  return none(register_.is_closed(c) | (surfaces_[candidate.surface].present & (gap < near_margin_)));
}

void ContactLanes::meet_place(std::size_t c, const ContactStart& start, const Mask& running) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const auto node = static_cast<std::size_t>(candidate.node);
  const SeenPlaces::Start seen = places_->start(candidate, *frame_, get_vector(start.u, node),
                                                get_vector(start.v, node), get_vector(start.a, node));
  const LaneVector free = places_->displacement(
      candidate, get_vector(start.free.displacement, static_cast<std::size_t>(candidate.contact_node)),
      free_turn_);
  const Lane rest(candidate.surface_m);
  Meeting meeting{rest + seen.displacement[axis] - motion_[surface].place_m,
                  rest + free[axis] - place_free_[surface], motion_[surface].velocity_m_s - seen.velocity[axis],
                  motion_[surface].acceleration_m_s2 - seen.acceleration[axis]};
  if (start.mount != nullptr) {
    LaneVector place = seen.displacement;
    place[axis] += rest;
    for (std::size_t t = 0; t < 2; ++t) {
      place[static_cast<std::size_t>(tangent_axes(surface)[t])] += Lane(candidate.tributary[t].place_m);
    }
    for (std::size_t i = 0; i < 3; ++i) place[i] -= carrier_of(surface, start.now)[i].place_m;
    go_with_mount(c, place, *start.mount, meeting);
  }
  const Mask open = !register_.is_closed(c);
  const auto tangents = tangent_axes(surface);
  for (std::size_t t = 0; t < 2; ++t) {
    const auto along = static_cast<std::size_t>(tangents[t]);
    Lane place = seen.displacement[along] - carrier_of(surface, start.now)[along].place_m;
    if (start.mount != nullptr) place -= mounted_.along(c, along, start.mount->displacement());
    register_.anchor[t].put(c, select(running & open, place, register_.anchor[t].get(c)));
  }
  // What lies deeper than the layer is thick stands behind the surface.
  const Mask in_front = meeting.gap_now > -surfaces_[surface].thickness_m;
  const std::array<CoveredPiece, 2> piece = covered_place(candidate, seen.displacement, start.now);
  const Mask beside = comes_from_beside(c, meeting, piece) & running;
  const Mask meets = may_meet(c, meeting, running) & (in_front | !open) & !beside;
  const Mask moves = meets & (open | register_.sliding.get(c));
  if (any(moves)) set_cover(c, piece, moves);
  take_in(c, meeting, meets, running);
}

/// Is an open place behind a rectangle that it has not been over? Then it has come round the rim; where the middle
/// of the product stands before the surface, that is noted.
Mask ContactLanes::comes_from_beside(std::size_t c, const Meeting& meeting,
                                     const std::array<CoveredPiece, 2>& piece) {
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  if (none(surface.has_rim)) return Mask(false);
  const Mask within = piece[0].share * piece[1].share > Lane(0.0);
  const Mask behind = meeting.gap_now < -near_margin_;
  const Mask closed = register_.is_closed(c);
  const Mask over = closed | (within & !behind) | (over_.get(c) & behind);
  over_.put(c, over);
  const Mask beside = surface.present & surface.has_rim & behind & !over;
  const Mask before = places_->center_height(candidate.surface) > motion_[candidate.surface].place_m;
  meets_rim_ = meets_rim_ | (beside & before & within);
  return beside;
}

/// How much of the piece of surface around a place meets its surface now.
std::array<CoveredPiece, 2> ContactLanes::covered_place(const ContactCandidate& candidate,
                                                        const LaneVector& displacement,
                                                        const CarrierMotion& now) const {
  const SurfaceLane& surface = surfaces_[candidate.surface];
  std::array<CoveredPiece, 2> piece;
  piece[0].share = places_->facing(candidate);
  for (std::size_t t = 0; t < 2; ++t) {
    const auto along = static_cast<std::size_t>(tangent_axes(candidate.surface)[t]);
    const Lane there = Lane(candidate.tributary[t].place_m) + displacement[along] -
                       carrier_of(candidate.surface, now)[along].place_m;
    piece[t].share *= share_within(there, surface.size_m[t], candidate.tributary[t].extent_m);
  }
  return piece;
}

void ContactLanes::see_theta(const FrameLanes& frame, const LaneArray& u_theta) {
  seen_->see_theta(frame, u_theta);
  if (!places_) return;
  for (const int live : sweep_.live_candidates()) {
    const auto c = static_cast<std::size_t>(live);
    const ContactCandidate& candidate = model_.candidate[c];
    if (candidate.place < 0) continue;
    const LaneVector there = places_->displacement(
        candidate, get_vector(u_theta, static_cast<std::size_t>(candidate.node)), sweep_.levers().turn());
    for (std::size_t t = 0; t < 2; ++t) {
      place_theta_[t].put(c, there[static_cast<std::size_t>(tangent_axes(candidate.surface)[t])]);
    }
  }
}

void ContactLanes::add_arms(OuterForces& outer) const {
  if (!places_) return;
  for (const int live : sweep_.live_candidates()) {
    const auto c = static_cast<std::size_t>(live);
    const ContactCandidate& candidate = model_.candidate[c];
    if (candidate.place < 0) continue;
    const LaneVector arm = to_lanes(model_.place[static_cast<std::size_t>(candidate.place)].arm_m);
    outer.add_arm(arm + cross(sweep_.levers().turn(), arm), sweep_.force_in_frame(c));
  }
}

/// Takes in which face of the product each surface meets.
void ContactLanes::see_facing(const FrameLanes& frame) {
  places_->see(frame);
  for (int surface = kSupport; surface < model_.surface_count; ++surface) {
    const LaneVector n = places_->normal(surface);
    const Lane x = abs(n[0]), y = abs(n[1]), z = abs(n[2]);
    const Mask across_z = (z >= x) & (z >= y);
    faces_[static_cast<std::size_t>(surface)] = {(x >= y) & !across_z, across_z};
  }
}

/// Where on the face that its surface meets a place lies.
std::array<Lane, 2> ContactLanes::place_on_face(const ContactCandidate& candidate) const {
  const auto& [across_x, across_z] = faces_[static_cast<std::size_t>(candidate.surface)];
  const LaneVector place = to_lanes(body_.position_m[static_cast<std::size_t>(candidate.node)]) +
                           to_lanes(model_.place[static_cast<std::size_t>(candidate.place)].arm_m);
  return {select(across_x, place[1], place[0]), select(across_z, place[1], place[2])};
}

void ContactLanes::measure_place_windows(int surface, const Mask& running) {
  place_windows_.clear();
  for (const int live : sweep_.live_candidates()) {
    const auto c = static_cast<std::size_t>(live);
    const ContactCandidate& candidate = model_.candidate[c];
    if (candidate.surface != surface) continue;
    const Lane normal = select(running, max0(register_.normal.get(c)), Lane(0.0));
    if (any(normal > Lane(0.0))) place_windows_.add(place_on_face(candidate), normal);
  }
  patch_pressure_ = max(patch_pressure_, place_windows_.largest_Pa());
}

}  // namespace unbruised
