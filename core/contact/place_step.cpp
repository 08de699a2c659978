#include <algorithm>
#include <limits>

#include "core/contact/contact_lanes.hpp"

namespace unbruised {

// How the places of a product's true surface go through a step (docs/theory.md, "Places that touch").

namespace {

/// Turned by more than this against a surface, the arms of a product are looked at again.
constexpr double kFacedAlike_rad = 0.03;
/// Of the length of an arm, for rounding.
constexpr double kArmRounding = 1e-9;

/// A tangential coordinate this far within a rectangle's edge, as a share of a place's extent, counts whole.
Lane share_within(const Lane& place, const Lane& size, double extent_m) {
  const Lane inside = (Lane(0.5) * size - abs(place)) * Lane(1.0 / extent_m) + Lane(0.5);
  return max0(min(inside, Lane(1.0)));
}

}  // namespace

/// The candidates of a node with one surface stand side by side.
void ContactLanes::group_candidates() {
  for (int c = 0; c < static_cast<int>(model_.candidate.size()); ++c) {
    awake_candidate_.push_back(c);
    const ContactCandidate& candidate = model_.candidate[static_cast<std::size_t>(c)];
    if (candidate.place < 0) {
      side_candidate_.push_back(c);
      continue;
    }
    const auto node = static_cast<std::size_t>(candidate.contact_node);
    if (place_group_.empty() || place_group_.back().node != node ||
        place_group_.back().surface != candidate.surface) {
      place_group_.push_back({node, candidate.surface, c, c, 0});
    }
    place_group_.back().end = c + 1;
  }
}

void ContactLanes::wake_all() {
  if (!places_) return;
  asleep_.assign(model_.candidate.size(), 0);
  for (PlaceGroup& group : place_group_) group.awake = group.end - group.first;
  list_awake();
}

void ContactLanes::list_awake() {
  if (!places_) return;  // nothing sleeps
  awake_candidate_.clear();
  auto side = side_candidate_.begin();
  for (const PlaceGroup& group : place_group_) {
    for (; side != side_candidate_.end() && *side < group.first; ++side) awake_candidate_.push_back(*side);
    for (int c = group.first; group.awake > 0 && c < group.end; ++c) {
      if (asleep_[static_cast<std::size_t>(c)] == 0) awake_candidate_.push_back(c);
    }
  }
  awake_candidate_.insert(awake_candidate_.end(), side, side_candidate_.end());
}

/// Places that sleep are looked at closely only when the lowest one of their node comes near.
void ContactLanes::meet_places(const ContactStart& start, const Mask& running) {
  free_turn_ = sweep_.levers().turn_by(start.free.moment_N_m);
  sway_m_ = start.mount == nullptr ? Lane(0.0) : sway_m(*start.mount);
  std::array<FacingPlane, kSurfaceCount> plane;
  for (const int surface : model_.surface) {
    if (model_.has_places(surface)) plane[static_cast<std::size_t>(surface)] = facing_plane(surface);
  }
  for (std::size_t g = 0; g < place_group_.size(); ++g) {
    PlaceGroup& group = place_group_[g];
    const FacingPlane& facing = plane[static_cast<std::size_t>(group.surface)];
    const LaneVector there =
        seen_->rest_place_m(*frame_, group.node) + get_vector(start.free.displacement, group.node);
    const Lane lowest = dot(facing.normal, there) + facing.center_m + lowest_arm_m_.get(g);
    const Lane near = near_m(group.surface) + Lane(model_.place_radius_m[group.node]) * facing.turned_rad;
    const bool all_far = none(surfaces_[group.surface].present & (lowest < near));
    if (group.awake > 0 || !all_far) meet_group(group, all_far, start, running);
  }
}

void ContactLanes::meet_group(PlaceGroup& group, bool all_far, const ContactStart& start, const Mask& running) {
  for (auto c = static_cast<std::size_t>(group.first); c < static_cast<std::size_t>(group.end); ++c) {
    const bool far = all_far || is_far(c, start);
    if (far && asleep_[c] != 0) continue;
    meet_place(c, start, running);
    // One that has just opened may still be pressed: its layer's energy counts until the next step sees it gone.
    const Mask pressed = running & (register_.penetration.get(c) > register_.least_relief(c));
    const bool sleeps = far && none((register_.normal.get(c) > Lane(0.0)) | register_.near.get(c) | pressed);
    group.awake += (asleep_[c] != 0 ? 1 : 0) - (sleeps ? 1 : 0);
    asleep_[c] = sleeps ? 1 : 0;
  }
}

/// n . (arm + w x arm) >= n0 . arm - (|n - n0| + |w|) |arm|, w the turn of the body within the step.
ContactLanes::FacingPlane ContactLanes::facing_plane(int surface) {
  LaneVector& from = arms_faced_[static_cast<std::size_t>(surface)];
  const LaneVector normal = places_->normal(surface);
  LaneVector change = normal - from;
  if (any(surfaces_[surface].present & (dot(change, change) > Lane(kFacedAlike_rad * kFacedAlike_rad)))) {
    from = normal;
    change = LaneVector{};
    find_lowest_arms(surface);
  }
  return {normal, places_->center_height(surface) - place_free_[surface],
          sqrt(dot(change, change)) + sqrt(dot(free_turn_, free_turn_)) + Lane(kArmRounding)};
}

void ContactLanes::find_lowest_arms(int surface) {
  const LaneVector& normal = arms_faced_[static_cast<std::size_t>(surface)];
  for (std::size_t g = 0; g < place_group_.size(); ++g) {
    const PlaceGroup& group = place_group_[g];
    if (group.surface != surface) continue;
    Lane lowest(std::numeric_limits<double>::infinity());
    for (auto c = static_cast<std::size_t>(group.first); c < static_cast<std::size_t>(group.end); ++c) {
      const auto place = static_cast<std::size_t>(model_.candidate[c].place);
      lowest = min(lowest, dot(normal, to_lanes(model_.place[place].arm_m)));
    }
    lowest_arm_m_.put(g, lowest);
  }
}

/// Is this place?
bool ContactLanes::is_far(std::size_t c, const ContactStart& start) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const LaneVector u = get_vector(start.free.displacement, static_cast<std::size_t>(candidate.contact_node));
  const Lane gap = places_->height(candidate, u, free_turn_) - place_free_[candidate.surface];
  return none(register_.is_closed(c) | (surfaces_[candidate.surface].present & (gap < near_m(candidate.surface))));
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

/// Adds the torque of a listed finger's contact about the palm centre, where its place was seen last.
void ContactLanes::tally_place_torque(std::size_t c, const LaneVector& u, const Mask& running,
                                      const CandidateStep& step) {
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  LaneVector place = places_->displacement(candidate, u);
  const auto tangents = tangent_axes(candidate.surface);
  for (std::size_t t = 0; t < 2; ++t) {
    place[static_cast<std::size_t>(tangents[t])] += Lane(candidate.tributary[t].place_m);
  }
  place[static_cast<std::size_t>(normal_axis(candidate.surface))] += Lane(candidate.surface_m);
  const LaneMatrix back = transposed(surface.axes);
  const LaneVector arm = back * place + surface.origin_m;
  const LaneVector force =
      back * LaneVector{along_axes(candidate.surface, step.after[0], step.after[1], step.after[2])};
  tally_[candidate.surface].add_torque(arm.at, force.at, running);
}

/// Takes in which face of the product each surface meets.
void ContactLanes::see_facing(const FrameLanes& frame, const CarrierMotion& there) {
  places_->see(frame, there);
  for (const int surface : model_.surface) {
    if (!model_.has_places(surface)) continue;
    const LaneVector n = places_->normal(surface);
    const Lane x = abs(n[0]), y = abs(n[1]), z = abs(n[2]);
    const Mask across_z = (z >= x) & (z >= y), across_x = (x >= y) & !across_z;
    // The surface lies at the low end where its normal points up.
    const Mask at_low = select(across_x, n[0], select(across_z, n[2], n[1])) > Lane(0.0);
    faces_[static_cast<std::size_t>(surface)] = {across_x, across_z, at_low};
  }
}

/// Where on the face that its surface meets a place lies.
std::array<Lane, 2> ContactLanes::place_on_face(const ContactCandidate& candidate) const {
  const auto& [across_x, across_z, at_low] = faces_[static_cast<std::size_t>(candidate.surface)];
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
