#include "core/contact/contact_lanes.hpp"

#include "core/door/require.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// A contact joins the solve when its free motion brings it this close to the surface, as a share of the body's
/// smallest extent: far more than the contact forces of one step move an open contact.
constexpr double kNearShare = 0.005;

std::vector<WindowPressure> windows_over(const ContactModel& model) {
  std::vector<WindowPressure> windows;
  for (const FaceGrid& face : model.face) windows.emplace_back(face, model.patch_side_m);
  return windows;
}

std::optional<ShapedPads> shaped_pads(const ContactModel& model, const SurfaceLanes& surfaces,
                                      ContactRegister& contacts) {
  if (!model.shaped_pads) return std::nullopt;
  return std::make_optional<ShapedPads>(model, surfaces, contacts);
}

}  // namespace

ContactLanes::ContactLanes(const ContactModel& model, const BodyModel& body, const WilsonTheta& wilson,
                           ProductFrame frame)
    : model_(model),
      body_(body),
      w_(wilson),
      near_margin_(kNearShare * body.smallest_extent_m()),
      register_(model),
      shaped_(shaped_pads(model, surfaces_, register_)),
      mounted_(model),
      sweep_(model, surfaces_, register_, shaped_ ? &*shaped_ : nullptr),
      window_(windows_over(model)),
      place_windows_(model.patch_side_m),
      events_(model.candidate.size(), wilson) {
  place_free_.fill(Lane(0.0));
  if (frame == ProductFrame::floating) seen_.emplace(model, body);
  for (LaneArray& rows : shaped_place_) rows = LaneArray(shaped_ ? model.candidate.size() : 0);
  if (model.pads) pads_.emplace(model);
  group_candidates();
  if (model.place.empty()) return;
  require(seen_.has_value(), "ContactLanes: places touch only where the product has a floating frame");
  places_.emplace(model, body, surfaces_);
  over_ = MaskArray(model.candidate.size());
  lowest_arm_m_ = LaneArray(place_group_.size());
  for (LaneArray& rows : place_theta_) rows = LaneArray(model.candidate.size());
  for (const PlaceArm& place : model.place) reach_m_ = std::max(reach_m_, length(place.from_mass_m));
}

void ContactLanes::load(int lane, const Scenario& scenario) {
  require(is_lane(lane), "ContactLanes::load: there is no such lane");
  register_.clear(lane);
  forget_slip(lane);
  for (WindowPressure& windows : window_) windows.clear(lane);
  for (SurfaceTally& tally : tally_) tally.clear_lane(lane);
  for (Lane* value :
       {&dissipated_, &losses_.friction, &losses_.viscous, &losses_.left, &patch_pressure_, &layer_strain_}) {
    value->set(lane, 0.0);
  }
  events_.stop(lane);
  sweep_.forget_effort(lane);
  const auto at = static_cast<std::size_t>(lane);
  pad_layer_[at] = layer_at_pad(scenario);
  support_layer_[at] = layer_at_support(scenario);
  const double of_pads = pad_layer_N_m3(scenario, pad_layer_[at]);
  surfaces_.load(lane, scenario, {body_.center_m(), model_.pole_m},
                 {of_pads, of_pads, support_layer_N_m3(scenario, support_layer_[at])});
  if (shaped_) {
    shaped_->load(lane);
    shaped_form_[at] = form_under_pad(scenario, model_.patch_form[facing_side(kLeftPad)]);
  }
  if (seen_) load_seen(lane);
  wake_all();
  if (places_) over_.clear_lane(lane);
}

void ContactLanes::archive(LaneArchive& lane) {
  surfaces_.archive(lane);
  register_.archive(lane);
  if (shaped_) shaped_->archive(lane);
  lane(over_, dissipated_, losses_.friction, losses_.viscous, losses_.left);
  for (WindowPressure& windows : window_) windows.archive(lane);
  for (SurfaceTally& tally : tally_) lane.members(tally);
  for (PadSlip& slip : slip_) lane.members(slip);
  for (LaneArray& rows : place_theta_) lane(rows);
  events_.archive(lane);
  sweep_.archive(lane);
}

Lane ContactLanes::stored_energy() const {
  Lane energy(0.0);
  for (const int awake : awake_candidate_) {
    const auto c = static_cast<std::size_t>(awake);
    const LayerEnergy stored = register_.stored_energy(c, surfaces_[model_.candidate[c].surface]);
    energy += stored.pressed + stored.sheared;
  }
  return energy;
}

void ContactLanes::set_rest(int lane, const StaticRest& rest) {
  register_.set_rest(lane, rest);
  SurfaceTally& support = tally_[kSupport];
  for (const double force_N : rest.normal_force_N) {
    if (!(force_N > 0.0)) continue;
    support.normal.set(lane, support.normal[lane] + force_N);
    support.closed.set(lane, support.closed[lane] + 1.0);
  }
}

void ContactLanes::leave(int surface, int lane) {
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    if (model_.candidate[c].surface != surface) continue;
    const LayerEnergy stored = register_.stored_energy(c, surfaces_[surface]);
    dissipated_.set(lane, dissipated_[lane] + stored.pressed[lane] + stored.sheared[lane]);
    losses_.left.set(lane, losses_.left[lane] + stored.pressed[lane] + stored.sheared[lane]);
    if (register_.is_closed(c)[lane]) {
      events_.note_left(
          static_cast<int>(c), lane,
          {register_.normal.at(c, lane), register_.tangent[0].at(c, lane), register_.tangent[1].at(c, lane)});
    }
    register_.open(c, lane);
  }
}

void ContactLanes::begin_step(const ContactStart& given, const Mask& running) {
  const Starts starts = seen_start(given);
  const ContactStart& start = starts.front();
  const PadForces no_force = without_force();
  for (const int s : model_.surface) {
    AxisMotion closing;
    Lane way_free(0.0);
    if (is_pad(s)) {
      const auto f = static_cast<int>(finger_of(s));
      closing = {start.gripper.way(f), start.gripper.speed(f), start.gripper.acceleration(f)};
      way_free = start.gripper.way_at_theta(f, no_force);
    }
    motion_[s] = surfaces_.motion(s, start.now, closing);
    place_free_[s] = surfaces_.place(s, start.theta, way_free);
  }
  frame_ = given.frame;
  const Eyes eyes = frame_ == nullptr ? Eyes{} : Eyes{frame_, &*seen_, places_ ? &*places_ : nullptr};
  begin_mounts(given.mount);
  if (pads_) pads_->begin_step(*given.pads, given.gripper);
  sweep_.begin_step(w_, start.theta, eyes, mounted_now_ ? &mounted_ : nullptr, pads_ ? &*pads_ : nullptr);
  for (const int side : side_candidate_) {
    const auto c = static_cast<std::size_t>(side);
    const ContactStart& from = starts[carrier_number(model_.candidate[c].surface)];
    model_.is_shaped(c) ? meet_shaped(c, from, running) : meet_side(c, from, running);
  }
  meets_rim_ = Mask(false);
  if (places_) {
    meet_places(
        {given.u, given.v, given.a, given.free, resting_[0], resting_[1], given.gripper, given.frame, given.mount},
        running);
  }
  list_awake();
  sweep_.list_active(running, awake_candidate_);
  sweep_.rebase(given.free, running);
}

/// How does a particle of the side that faces a surface meet it, and how much of it is covered?
void ContactLanes::meet_side(std::size_t c, const ContactStart& start, const Mask& running) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const auto node = 3 * static_cast<std::size_t>(candidate.node);
  const auto free = 3 * static_cast<std::size_t>(candidate.contact_node);
  const Lane sign(normal_sign(surface));
  const Lane rest(candidate.surface_m);
  Meeting meeting{sign * (rest + start.u.get(node + axis) - motion_[surface].place_m),
                  sign * (rest + start.free.displacement.get(free + axis) - place_free_[surface]),
                  -sign * (start.v.get(node + axis) - motion_[surface].velocity_m_s),
                  -sign * (start.a.get(node + axis) - motion_[surface].acceleration_m_s2)};
  if (start.mount != nullptr) {
    const auto at = static_cast<std::size_t>(candidate.node);
    LaneVector place = to_lanes(body_.position_m[at]);
    place[axis] = rest;
    for (std::size_t i = 0; i < 3; ++i) {
      place[i] += start.u.get(node + i) - carrier_of(surface, start.now)[i].place_m;
    }
    go_with_mount(c, place, *start.mount, meeting);
  }
  if (pads_ && pads_->has(c)) {
    meeting.gap_now -= sign * pads_->now_m(c);
    meeting.gap_free -= sign * pads_->free_m(c);
  }
  const Mask meets = may_meet(c, meeting, running);
  // A contact that sticks keeps what it closed with.
  const Mask moves = meets & !(register_.is_closed(c) & !register_.sliding.get(c));
  if (any(moves)) cover_again(c, start, moves);
  take_in(c, meeting, meets, running);
}

Mask ContactLanes::may_meet(std::size_t c, const Meeting& meeting, const Mask& running) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const Lane least = register_.least_relief(c);
  return running & surfaces_[candidate.surface].present &
         (register_.is_closed(c) | (meeting.gap_free + least < near_margin_));
}

/// Is the candidate near its surface, and what does its layer say? @param meets may be near, and is covered anew
void ContactLanes::take_in(std::size_t c, const Meeting& meeting, const Mask& meets, const Mask& running) {
  const ContactCandidate& candidate = model_.candidate[c];
  const Lane least = register_.least_relief(c);
  const Mask carrying = register_.is_closed(c);
  const Mask near = meets & (register_.share.get(c) > Lane(0.0));
  register_.near.put(c, near);
  register_.gap_now.put(c, meeting.gap_now + least);
  register_.gap_free.put(c, meeting.gap_free + least);
  register_.was_closed.put(c, carrying);
  register_.was_sliding.put(c, register_.sliding.get(c));
  register_.start_solve(c, near, surfaces_[candidate.surface].friction);
  // Where the contact is open its penetration is where the particle is, whatever it once was.
  register_.penetration.put(c, select(running & !carrying, -meeting.gap_now, register_.penetration.get(c)));
  // N = k (1 + tau a1) p - k tau (a1 p_n + 2 p'_n + a3 p''_n); penetration p = -gap.
  sweep_.prepare(c, surfaces_[candidate.surface].relaxation_s *
                        w_.viscous(-meeting.gap_now, meeting.rate, meeting.second_rate));
}

/// Takes in which part of a candidate's piece lies under its surface now.
void ContactLanes::cover_again(std::size_t c, const ContactStart& start, const Mask& lanes) {
  const ContactCandidate& candidate = model_.candidate[c];
  const auto tangents = tangent_axes(candidate.surface);
  const auto node = 3 * static_cast<std::size_t>(candidate.node);
  std::array<CoveredPiece, 2> piece;
  if (candidate.area_m2 > 0.0) {
    for (std::size_t t = 0; t < 2; ++t) {
      piece[t] = candidate.tributary[t].covered_by(surfaces_.reach(candidate.surface, start.now, t),
                                                   start.u.get(node + static_cast<std::size_t>(tangents[t])));
    }
  }
  set_cover(c, piece, lanes);
}

/// What the layer held beyond an edge is lost.
void ContactLanes::set_cover(std::size_t c, const std::array<CoveredPiece, 2>& piece, const Mask& lanes) {
  const SurfaceLane& surface = surfaces_[model_.candidate[c].surface];
  const LayerEnergy before = register_.stored_energy(c, surface);
  register_.set_cover(c, piece, lanes, model_.is_shaped(c) ? shaped_->wider(c) : Lane(1.0));
  const LayerEnergy after = register_.stored_energy(c, surface);
  const Lane lost = before.pressed - after.pressed + before.sheared - after.sheared;
  dissipated_ += select(lanes, lost, Lane(0.0));
  losses_.left += select(lanes, lost, Lane(0.0));
}

}  // namespace unbruised
