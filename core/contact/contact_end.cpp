#include "core/contact/contact_lanes.hpp"

namespace unbruised {

// The end of a step: forces, anchors and register go to t + dt, and are tallied.

namespace {

/// Forces below this are numerical dust of a contact that has opened [N].
constexpr double kDust = 1e-12;

}  // namespace

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
