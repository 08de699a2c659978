#include "core/contact/contact_register.hpp"

#include "core/contact/layer_law.hpp"
#include "core/door/require.hpp"

namespace unbruised {

ContactRegister::ContactRegister(const ContactModel& model) : model_(model) {
  const std::size_t n = model.candidate.size();
  for (LaneArray* rows : {&normal,           &tangent[0],  &tangent[1],        &normal_theta,   &tangent_theta[0],
                          &tangent_theta[1], &penetration, &penetration_theta, &viscous,        &stretch[0],
                          &stretch[1],       &anchor[0],   &anchor[1],         &share,          &edge_compliance,
                          &mean[0],          &mean[1],     &mean_square[0],    &mean_square[1], &gap_now,
                          &gap_free}) {
    *rows = LaneArray(n);
  }
  for (LaneArray& rows : before_theta) rows = LaneArray(n);
  for (LaneArray& rows : place_weight) {
    rows = LaneArray(n * kReliefSide);
    rows.fill(1.0);
  }
  cut.assign(n, 0);
  for (MaskArray* rows : {&sliding, &near, &was_closed, &was_sliding}) *rows = MaskArray(n);
  if (!model.shaped_pads) return;
  relief = LaneArray(n * kReliefPlaces);
  foremost = LaneArray(n);
}

void ContactRegister::clear(int lane) {
  for (LaneArray* rows :
       {&normal, &tangent[0], &tangent[1], &normal_theta, &tangent_theta[0], &tangent_theta[1], &penetration,
        &penetration_theta, &viscous, &stretch[0], &stretch[1], &anchor[0], &anchor[1], &share, &edge_compliance,
        &mean[0], &mean[1], &mean_square[0], &mean_square[1]}) {
    rows->clear_lane(lane);
  }
  forget_trend(lane);
  for (LaneArray& weights : place_weight) {
    for (std::size_t row = 0; row < weights.rows(); ++row) weights.at(row, lane) = 1.0;
  }
  for (MaskArray* rows : {&sliding, &near, &was_closed, &was_sliding}) rows->clear_lane(lane);
}

void ContactRegister::archive(LaneArchive& lane) {
  lane(normal, tangent, normal_theta, tangent_theta, before_theta, penetration, penetration_theta, viscous,
       stretch, anchor);
  lane(share, edge_compliance, mean, mean_square, place_weight, relief, foremost);
  lane(sliding, near, was_closed, was_sliding, gap_now, gap_free);
  for (std::size_t c = 0; lane.arrives() && c < cut.size(); ++c) {
    for (const LaneArray& weight : place_weight) {
      for (std::size_t k = 0; k < kReliefSide; ++k) {
        if (weight.at(c * kReliefSide + k, lane.lane()) != 1.0) cut[c] = 1;
      }
    }
  }
}

void ContactRegister::open(std::size_t c, int lane) {
  for (LaneArray* rows : {&normal, &tangent[0], &tangent[1], &normal_theta, &tangent_theta[0], &tangent_theta[1],
                          &penetration, &penetration_theta, &viscous, &stretch[0], &stretch[1]}) {
    rows->at(c, lane) = 0.0;
  }
  for (LaneArray& rows : before_theta) rows.at(c, lane) = 0.0;
}

void ContactRegister::start_solve(std::size_t c, const Mask& takes_part, const Lane& friction) {
  const std::array<LaneArray*, 3> theta = {&normal_theta, &tangent_theta[0], &tangent_theta[1]};
  const Mask leads = (normal_theta.get(c) > Lane(0.0)) & (before_theta[0].get(c) > Lane(0.0));
  std::array<Lane, 3> start;
  for (std::size_t i = 0; i < 3; ++i) {
    const Lane last = theta[i]->get(c);
    start[i] = select(leads, last + (last - before_theta[i].get(c)), last);
    before_theta[i].put(c, last);
  }
  start[0] = max0(start[0]);
  const Lane cone = friction * start[0], size2 = start[1] * start[1] + start[2] * start[2];
  const Lane scale = select(leads & (size2 > cone * cone), cone / sqrt(max(size2, Lane(1e-300))), Lane(1.0));
  for (std::size_t i = 0; i < 3; ++i) {
    theta[i]->put(c, select(takes_part, i == 0 ? start[i] : scale * start[i], Lane(0.0)));
  }
}

void ContactRegister::set_rest(int lane, const StaticRest& rest) {
  require(is_lane(lane), "ContactRegister::set_rest: there is no such lane");
  require(rest.normal_force_N.size() == model_.candidate.size() &&
              rest.penetration_m.size() == model_.candidate.size(),
          "ContactRegister::set_rest: the rest of another product");
  for (std::size_t c = 0; c < rest.normal_force_N.size(); ++c) {
    if (!(rest.normal_force_N[c] > 0.0)) continue;  // the support has no edge
    penetration.at(c, lane) = rest.penetration_m[c];
    normal.at(c, lane) = normal_theta.at(c, lane) = rest.normal_force_N[c];
    share.at(c, lane) = upright_share(model_, model_.candidate[c]);
  }
}

void ContactRegister::set_anchors(int lane, const LaneArray& u) {
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    const auto tangents = tangent_axes(model_.candidate[c].surface);
    const auto node = 3 * static_cast<std::size_t>(model_.candidate[c].node);
    for (std::size_t t = 0; t < 2; ++t) {
      anchor[t].at(c, lane) = u.at(node + static_cast<std::size_t>(tangents[t]), lane);
    }
  }
}

Lane ContactRegister::layer_stiffness(std::size_t c, const SurfaceLane& surface) const {
  const ContactCandidate& candidate = model_.candidate[c];
  if (candidate.stiffness_N_m > 0.0) return Lane(candidate.stiffness_N_m);
  return surface.springs_N_m3 * Lane(candidate.area_m2) * share.get(c);
}

Lane ContactRegister::normal_stiffness(std::size_t c, const SurfaceLane& surface) const {
  const ContactCandidate& candidate = model_.candidate[c];
  if (candidate.stiffness_N_m > 0.0) return Lane(candidate.stiffness_N_m);
  return Lane(candidate.area_m2) * share.get(c) /
         (Lane(1.0) / surface.stiffness_N_m3 + body_compliance(c, surface));
}

Lane ContactRegister::elastic_force(std::size_t c, const SurfaceLane& surface, const Lane& p) const {
  if (surface.curve.any()) {
    const LayerLaw law = curved_layer_law(model_.candidate[c], p, Lane(0.0), Lane(0.0), cover(c), surface.curve);
    return normal_stiffness(c, surface) * law.force;
  }
  return normal_stiffness(c, surface) * layer_law(model_.candidate[c], p, Lane(0.0), Lane(0.0), cover(c)).force;
}

PlaceCover ContactRegister::cover(std::size_t c) const {
  const bool shaped = model_.is_shaped(c);
  if (cut[c] == 0 && !shaped) return {};
  return {place_weight[0].row(c * kReliefSide), place_weight[1].row(c * kReliefSide),
          shaped ? relief.row(c * kReliefPlaces) : nullptr};
}

void ContactRegister::set_cover(std::size_t c, const std::array<CoveredPiece, 2>& piece, const Mask& lanes,
                                const Lane& wider) {
  share.put(c, select(lanes, piece[0].share * piece[1].share * wider, share.get(c)));
  const std::array<double, 2>& unit = model_.candidate[c].edge_compliance_m_Pa;
  const Lane softer = Lane(unit[0]) * piece[0].softness + Lane(unit[1]) * piece[1].softness;
  edge_compliance.put(c, select(lanes, softer, edge_compliance.get(c)));
  bool whole = true;
  for (std::size_t t = 0; t < 2; ++t) {
    const Tributary& along = model_.candidate[c].tributary[t];
    if (!along.curved) {
      mean[t].put(c, select(lanes, piece[t].mean_m, mean[t].get(c)));
      mean_square[t].put(c, select(lanes, piece[t].mean_square_m2, mean_square[t].get(c)));
    }
    if (!along.has_places()) continue;
    const Lane inverse = along.sampled ? Lane(1.0) : Lane(1.0) / max(piece[t].share, Lane(1e-300));
    for (std::size_t k = 0; k < kReliefSide; ++k) {
      const std::size_t row = c * kReliefSide + k;
      const Lane weight = select(lanes, piece[t].place[k] * inverse, place_weight[t].get(row));
      place_weight[t].put(row, weight);
      whole = whole && none(weight < Lane(1.0)) && none(weight > Lane(1.0));
    }
  }
  cut[c] = whole ? 0 : 1;
}

LayerEnergy ContactRegister::stored_energy(std::size_t c, const SurfaceLane& surface) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const Mask closed = is_closed(c);
  // A viscous layer that recovers more slowly than the particle leaves is still pressed when it carries nothing.
  const Mask pressed = (surface.relaxation_s > Lane(0.0)) & (penetration.get(c) > Lane(0.0));
  if (none(closed | pressed)) return {};
  const Lane press = normal_stiffness(c, surface);
  const Lane s1 = stretch[0].get(c), s2 = stretch[1].get(c);
  const Lane depth2 = squared_depth(candidate, penetration.get(c), cover(c), surface.curve);
  const Lane stored = press * depth2 * Lane(0.5);
  const Lane sheared = layer_stiffness(c, surface) * (s1 * s1 + s2 * s2) * Lane(0.5 / 3.0);
  return {select(closed | pressed, stored, Lane(0.0)), select(closed, sheared, Lane(0.0))};
}

}  // namespace unbruised
