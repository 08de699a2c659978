#include "core/contact/contact_lanes.hpp"

#include "core/door/require.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// A contact joins the solve when its free motion brings it this close to the surface, as a share of the body's
/// smallest extent: far more than the contact forces of one step move an open contact.
constexpr double kNearShare = 0.005;
/// Forces below this are numerical dust of a contact that has opened [N].
constexpr double kDust = 1e-12;

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
  const auto at = static_cast<std::size_t>(lane);
  pad_layer_[at] = layer_at_pad(scenario);
  support_layer_[at] = layer_at_support(scenario);
  const double of_pads = pad_layer_N_m3(scenario, pad_layer_[at]);
  surfaces_.load(lane, scenario, {body_.center_m(), model_.pole_m},
                 {of_pads, of_pads, support_layer_N_m3(scenario, support_layer_[at])});
  if (shaped_) {
    shaped_->load(lane);
    shaped_form_[at] =
        form_under_pad(scenario, model_.patch_form[static_cast<std::size_t>(normal_axis(kLeftPad))]);
  }
  if (seen_) load_seen(lane);
  wake_all();
  if (places_) over_.clear_lane(lane);
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
  register_.normal_theta.put(c, select(near, register_.normal_theta.get(c), Lane(0.0)));
  for (LaneArray& tangent : register_.tangent_theta) tangent.put(c, select(near, tangent.get(c), Lane(0.0)));
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

void ContactLanes::end_step(const ContactEnd& end, const FrameLanes* frame, const Mask& running) {
  const Ends ends = seen_end(end, frame);
  if (pads_) pads_->end_step(*end.pads);
  ended_ = &end.u;
  if (places_) see_facing(*frame, end.next);
  tally_.fill(SurfaceTally{});
  patch_pressure_ = layer_strain_ = Lane(0.0);
  touched_.fill(Lane(2.0));
  left_.fill(Lane(-1.0));
  for (PadSlip& pad : slip_) pad.begin_step();
  carry_open_anchors(ends, running);
  for (int live : sweep_.live_candidates()) {
    const auto c = static_cast<std::size_t>(live);
    end_candidate(c, ends[carrier_number(model_.candidate[c].surface)], running);
  }
  for (const int surface : model_.surface) {
    measure_windows(surface, ends[carrier_number(surface)], running);
    if (is_pad(surface)) slip_[finger_of(surface)].end_step(least_turning_radius_m(), running);
  }
}

/// Anchors of open contacts go with the particle, so that a contact closes where it touches.
void ContactLanes::carry_open_anchors(const Ends& ends, const Mask& running) {
  for (const int side : side_candidate_) {  // those of places go with them as they meet
    const auto c = static_cast<std::size_t>(side);
    const int surface = model_.candidate[c].surface;
    const ContactEnd& end = ends[carrier_number(surface)];
    const auto tangents = tangent_axes(surface);
    const auto node = 3 * static_cast<std::size_t>(model_.candidate[c].node);
    const Mask open = running & !register_.is_closed(c);
    std::array<Lane, 2> way;
    for (std::size_t t = 0; t < 2; ++t) {
      const auto axis = static_cast<std::size_t>(tangents[t]);
      Lane place = end.u.get(node + axis) - carrier_of(surface, end.next)[axis].place_m;
      if (end.mount != nullptr) place -= mounted_.along(c, axis, end.mount->displacement());
      if (model_.is_shaped(c)) {  // its anchor goes with the particle as it meets
        way[t] = place - shaped_place_[t].get(c);
        continue;
      }
      if (pads_ && pads_->has(c)) place -= pads_->next_m(c, axis);
      const Lane before = register_.anchor[t].get(c);
      register_.anchor[t].put(c, select(open, place, before));
      way[t] = place - before;
    }
    if (is_pad(surface)) slip_[finger_of(surface)].add_open(way, open);
  }
}

void ContactLanes::forget_slip(int lane) {
  for (PadSlip& pad : slip_) pad.forget(lane);
}

void ContactLanes::end_candidate(std::size_t c, const ContactEnd& end, const Mask& running) {
  CandidateStep step;
  step.closed = running & register_.is_closed(c);
  step.sliding = step.closed & register_.sliding.get(c);
  advance_forces(c, running, step);
  advance_anchors(c, end, step);
  advance_penetration(c, running, step);
  book_viscous(c, running, step);
  const Lane slid =
      (step.before[1] + step.after[1]) * step.moved[0] + (step.before[2] + step.after[2]) * step.moved[1];
  dissipated_ += select(running, -Lane(0.5) * slid, Lane(0.0));
  losses_.friction += select(running, -Lane(0.5) * slid, Lane(0.0));
  tally_candidate(c, running, step);
  note_layer_strain(c, step);
  if (any(events_.lanes() & running)) note_changes(c, step);
  if (!is_pad(model_.candidate[c].surface)) return;
  tally_torque(c, end, running, step);
  note_touch(c, step);
}

void ContactLanes::advance_forces(std::size_t c, const Mask& running, CandidateStep& step) {
  const std::array<LaneArray*, 3> now = {&register_.normal, &register_.tangent[0], &register_.tangent[1]};
  const std::array<const LaneArray*, 3> theta = {&register_.normal_theta, &register_.tangent_theta[0],
                                                 &register_.tangent_theta[1]};
  for (std::size_t i = 0; i < 3; ++i) {
    step.before[i] = now[i]->get(c);
    step.after[i] = w_.at_end(step.before[i], theta[i]->get(c));
  }
  const Mask dust = (!step.closed) & (step.after[0] < Lane(kDust));
  for (std::size_t i = 0; i < 3; ++i) {
    step.after[i] = select(running, select(dust, Lane(0.0), step.after[i]), step.before[i]);
    now[i]->put(c, step.after[i]);
  }
}

/// Where a contact slides, its anchor follows so that the spring stays on the cone.
void ContactLanes::advance_anchors(std::size_t c, const ContactEnd& end, CandidateStep& step) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const auto tangents = tangent_axes(surface);
  const auto node = 3 * static_cast<std::size_t>(candidate.node);
  const Lane shear = max(register_.layer_stiffness(c, surfaces_[surface]) * Lane(1.0 / 3.0), Lane(1e-300));
  const bool shaped = model_.is_shaped(c);
  const LaneVector there = shaped ? shaped_place_theta(c, end) : LaneVector{};
  for (std::size_t t = 0; t < 2; ++t) {
    const auto along = static_cast<std::size_t>(tangents[t]);
    const Lane seen = candidate.place < 0 ? end.u_theta.get(node + along) : place_theta_[t].get(c);
    Lane place = seen - carrier_of(surface, end.theta)[along].place_m;
    if (end.mount != nullptr) place -= mounted_.along(c, along);
    if (shaped) place = there[1 + t];
    if (pads_ && pads_->has(c)) place -= pads_->theta_m(c, along);
    const Lane before = register_.anchor[t].get(c);
    const Lane stretch = register_.tangent_theta[t].get(c) / shear;
    const Lane after = w_.at_end(before, place + stretch);
    const Lane stretched = w_.at_end(register_.stretch[t].get(c), stretch);
    register_.stretch[t].put(c, select(step.closed, stretched, Lane(0.0)));
    step.moved[t] = select(step.sliding, after - before, Lane(0.0));
    register_.anchor[t].put(c, before + step.moved[t]);
  }
}

void ContactLanes::advance_penetration(std::size_t c, const Mask& running, CandidateStep& step) {
  const Mask near = running & register_.near.get(c);
  step.penetration_before = register_.penetration.get(c);
  const Lane after = w_.at_end(step.penetration_before, register_.penetration_theta.get(c));
  step.penetration = select(near, after, step.penetration_before);
  register_.penetration.put(c, step.penetration);
}

/// Books what a viscous layer dissipates.
void ContactLanes::book_viscous(std::size_t c, const Mask& running, const CandidateStep& step) {
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  const Mask viscous = running & register_.near.get(c) & (surface.relaxation_s > Lane(0.0));
  if (none(viscous)) return;
  // Trapezoid rule over the way of the penetration, as forces and places are linear over the step. An open
  // layer that is still pressed carries nothing: its viscosity holds what its elasticity would push with.
  const Lane before = select(register_.was_closed.get(c), register_.viscous.get(c),
                             -register_.elastic_force(c, surface, step.penetration_before));
  const Lane elastic = register_.elastic_force(c, surface, register_.penetration_theta.get(c));
  const Lane after = w_.at_end(before, register_.normal_theta.get(c) - elastic);
  register_.viscous.put(c, select(viscous, after, register_.viscous.get(c)));
  // Only the way within the layer counts: beyond it there is no force.
  const Lane least = register_.least_relief(c);
  const Lane way = max0(step.penetration - least) - max0(step.penetration_before - least);
  dissipated_ += select(viscous, Lane(0.5) * (before + after) * way, Lane(0.0));
  losses_.viscous += select(viscous, Lane(0.5) * (before + after) * way, Lane(0.0));
}

void ContactLanes::tally_candidate(std::size_t c, const Mask& running, const CandidateStep& step) {
  SurfaceTally& sums = tally_[model_.candidate[c].surface];
  const Lane closed = select(step.closed, Lane(1.0), Lane(0.0));
  const std::array<Lane, 3> force = of_carrier(c, step.after);
  sums.normal += select(running, force[0], Lane(0.0));
  sums.tangent[0] += select(running, force[1], Lane(0.0));
  sums.tangent[1] += select(running, force[2], Lane(0.0));
  sums.closed += closed;
  sums.sliding += select(step.sliding, Lane(1.0), Lane(0.0));
  if (is_pad(model_.candidate[c].surface)) {
    const auto& piece = model_.candidate[c].tributary;
    std::array<Lane, 2> place = {Lane(piece[0].place_m), Lane(piece[1].place_m)};
    for (std::size_t t = 0; seen_ && t < 2; ++t) place[t] += register_.anchor[t].get(c);  // it may turn far
    slip_[finger_of(model_.candidate[c].surface)].add_closed(
        place, select(step.closed, register_.normal_theta.get(c), Lane(0.0)), step.moved);
  }
  if (model_.candidate[c].place >= 0) {
    sums.add_place(step.after[0], place_on_face(model_.candidate[c]), model_.candidate[c].tributary[0].extent_m);
    return;
  }
  sums.add_moments(model_.candidate[c], force[0],
                   {register_.penetration_theta.get(c),
                    register_.cover(c),
                    {register_.mean[0].get(c), register_.mean[1].get(c)},
                    {register_.mean_square[0].get(c), register_.mean_square[1].get(c)}});
}

/// Adds the torque of a pad's contact about the palm centre.
void ContactLanes::tally_torque(std::size_t c, const ContactEnd& end, const Mask& running,
                                const CandidateStep& step) {
  const int surface = model_.candidate[c].surface;
  const auto node = static_cast<std::size_t>(model_.candidate[c].node);
  if (is_listed_pad(surface)) return tally_place_torque(c, get_vector(*ended_, node), running, step);
  const auto tangents = tangent_axes(surface);
  const auto& carrier = carrier_of(surface, end.next);
  std::array<Lane, 3> arm;
  for (std::size_t i = 0; i < 3; ++i) {
    arm[i] = Lane(body_.position_m[node][i]) + end.u.get(3 * node + i) - carrier[i].place_m;
  }
  for (std::size_t t = 0; t < 2; ++t) arm[tangents[t]] -= surfaces_[surface].center_m[t];
  const std::array<Lane, 3> force = of_carrier(c, step.after);
  tally_[surface].add_torque(arm, along_axes(surface, force[0], force[1], force[2]), running);
}

}  // namespace unbruised
