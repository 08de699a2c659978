#include "core/contact/contact_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "core/algebra/lane_matrix.hpp"
#include "core/contact/layer_law.hpp"
#include "core/scenario/opening.hpp"

namespace unbruised {
namespace {

/// A contact joins the solve when its free motion brings it this close to the surface, as a share of the body's
/// smallest extent: far more than the contact forces of one step move an open contact.
constexpr double kNearShare = 0.005;
/// Relative change of the forces in a sweep below which a lane is solved.
constexpr double kTolerance = 1e-8;
/// Forces below this are numerical dust of a contact that has opened [N].
constexpr double kDust = 1e-12;
/// Twenty suffice at steps that resolve the contact; long steps with light fingers need some hundred.
constexpr int kMaxSweeps = 1000;
/// After this many sweeps a lane that is still moving is solved carefully.
constexpr int kNewtonSweeps = 40;
/// Relative change in the last sweep above which forces must not be used.
constexpr double kUnsolved = 1e-4;

/// What carries a surface: the palm the fingers with their pads, the cell the support.
const std::array<AxisMotion, 3>& carriers_of(const CarrierMotion& carriers, int surface) {
  return is_pad(surface) ? carriers.palm : carriers.cell;
}

}  // namespace

ContactLanes::ContactLanes(const ContactModel& model, double smallest_extent_m)
    : model_(model), near_margin_(kNearShare * smallest_extent_m) {
  const std::size_t n = model.candidate.size();
  for (LaneArray* rows : {&normal_,         &tangent1_, &tangent2_, &normal_theta_, &tangent1_theta_,
                          &tangent2_theta_, &anchor1_,  &anchor2_,  &penetration_,  &penetration_theta_,
                          &travel1_,        &travel2_,  &share_,    &near_,         &offset_,
                          &viscous_,        &gap_now_,  &gap_free_, &previous_,     &sliding_,
                          &was_sliding_,    &layer_,    &shear_,    &shear_relaxed_}) {
    *rows = LaneArray(n);
  }
  base_ = LaneArray(3 * model.node_count());
  node_force_ = LaneArray(3 * model.node_count());
  for (int s = 0; s < kSurfaceCount; ++s) {
    friction_[s] = stiffness_[s] = Lane(1.0);
    relaxation_[s] = rest_place_[s] = Lane(0.0);
    present_[s] = Mask(false);
  }
  pad_size_ = {Lane(1.0), Lane(1.0)};
  pad_center_ = {Lane(0.0), Lane(0.0)};
}

void ContactLanes::load(int lane, const Scenario& scenario, const std::array<double, 3>& product_center_m) {
  for (LaneArray* rows : {&normal_, &tangent1_, &tangent2_, &normal_theta_, &tangent1_theta_, &tangent2_theta_,
                          &anchor1_, &anchor2_, &penetration_, &penetration_theta_, &viscous_, &travel1_,
                          &travel2_, &share_, &near_, &previous_, &sliding_, &was_sliding_}) {
    rows->clear_lane(lane);
  }
  for (Lane* value : {&dissipated_, &patch_pressure_}) value->set(lane, 0.0);
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  const double product_friction =
      lattice != nullptr ? lattice->friction : std::get<NetworkParameters>(scenario.product).friction;
  const CellParameters& cell = scenario.cell;
  for (int pad = 0; pad < 2; ++pad) {
    present_[pad].set(lane, scenario.gripper.has_value());
    friction_[pad].set(lane, product_friction);
    if (!scenario.gripper) continue;
    const GripperParameters& gripper = *scenario.gripper;
    stiffness_[pad].set(lane, gripper.pad_modulus_Pa / gripper.pad_thickness_m);
    relaxation_[pad].set(lane, gripper.pad_relaxation_time_s);
    rest_place_[pad].set(lane, model_.pole_m[pad] - normal_sign(pad) * approach_gap_m(scenario));
    pad_size_[0].set(lane, gripper.pad_size_m[0]);
    pad_size_[1].set(lane, gripper.pad_size_m[1]);
  }
  pad_center_[0].set(lane, product_center_m[1] + cell.grip_offset_m);
  pad_center_[1].set(lane, product_center_m[2] + cell.grip_height_m);
  const auto support = kSupport;
  present_[support].set(lane, cell.support);
  friction_[support].set(lane, cell.support_friction);
  stiffness_[support].set(lane, cell.support_modulus_Pa / cell.support_thickness_m);
  relaxation_[support].set(lane, cell.support_relaxation_time_s);
}

void ContactLanes::set_rest(int lane, const StaticRest& rest) {
  for (std::size_t c = 0; c < rest.normal_force_N.size(); ++c) {
    if (!(rest.normal_force_N[c] > 0.0)) continue;
    penetration_.at(c, lane) = rest.penetration_m[c];
    normal_.at(c, lane) = normal_theta_.at(c, lane) = rest.normal_force_N[c];
    share_.at(c, lane) = 1.0;
  }
}

void ContactLanes::set_anchor_to_place(int lane, const LaneArray& u) {
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    const auto tangents = tangent_axes(model_.candidate[c].surface);
    const auto node = 3 * static_cast<std::size_t>(model_.candidate[c].node);
    anchor1_.at(c, lane) = u.at(node + static_cast<std::size_t>(tangents[0]), lane);
    anchor2_.at(c, lane) = u.at(node + static_cast<std::size_t>(tangents[1]), lane);
  }
}

void ContactLanes::reset_travel(int lane) {
  travel1_.clear_lane(lane);
  travel2_.clear_lane(lane);
}

Lane ContactLanes::layer_stiffness(std::size_t c) const {
  const ContactCandidate& candidate = model_.candidate[c];
  if (candidate.stiffness_N_m > 0.0) return Lane(candidate.stiffness_N_m);
  return stiffness_[candidate.surface] * Lane(candidate.area_m2) * share_.get(c);
}

Lane ContactLanes::normal_stiffness(std::size_t c) const {
  const ContactCandidate& candidate = model_.candidate[c];
  if (candidate.stiffness_N_m > 0.0) return Lane(candidate.stiffness_N_m);
  return Lane(candidate.area_m2) * share_.get(c) /
         (Lane(1.0) / stiffness_[candidate.surface] + Lane(candidate.cell_compliance_m_Pa));
}

Lane ContactLanes::surface_place(int surface, const CarrierMotion& carriers,
                                 const std::array<Lane, 2>& way) const {
  if (surface == kSupport) return carriers.cell[2].place_m;
  return rest_place_[surface] + Lane(normal_sign(surface)) * way[surface] + carriers.palm[0].place_m;
}

void ContactLanes::begin_step(const WilsonTheta& w, const LaneArray& u, const LaneArray& v, const LaneArray& a,
                              const CarrierMotion& now, const CarrierMotion& theta, const FingerLanes& fingers,
                              const LaneArray& base, const Mask& running) {
  theta_ = theta;
  for (int s = 0; s < kSurfaceCount; ++s) a1_tau_factor_[s] = Lane(1.0) + Lane(w.a1) * relaxation_[s];
  const std::array<Lane, 2> way_now = {fingers.way(0), fingers.way(1)};
  const std::array<Lane, 2> no_force = {Lane(0.0), Lane(0.0)};
  const std::array<Lane, 2> way_free = {fingers.way_at_theta(0, no_force), fingers.way_at_theta(1, no_force)};
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    const ContactCandidate& candidate = model_.candidate[c];
    const int surface = candidate.surface;
    const auto axis = static_cast<std::size_t>(normal_axis(surface));
    const auto node = 3 * static_cast<std::size_t>(candidate.node);
    const auto free = 3 * static_cast<std::size_t>(candidate.contact_node);
    const Lane sign(normal_sign(surface));
    const Lane rest(candidate.surface_m);
    const Lane gap_now = sign * (rest + u.get(node + axis) - surface_place(surface, now, way_now));
    const Lane gap_free = sign * (rest + base.get(free + axis) - surface_place(surface, theta, way_free));
    const Lane held = normal_theta_.get(c);
    const Mask carrying = held > Lane(0.0);
    const Lane least(candidate.least_relief_m);
    Mask near = running & present_[surface] & (carrying | (gap_free + least < near_margin_));
    if (is_pad(surface)) {
      // Share of the tributary rectangle under the pad; a closed contact keeps the one it closed with.
      const auto tangents = tangent_axes(surface);
      Lane share(1.0);
      for (std::size_t t = 0; t < 2; ++t) {
        const Lane place = Lane(candidate.place_m[t]) + u.get(node + static_cast<std::size_t>(tangents[t])) -
                           now.palm[static_cast<std::size_t>(tangents[t])].place_m - pad_center_[t];
        const Lane half(0.5 * candidate.extent_m[t]);
        const Lane pad_half = Lane(0.5) * pad_size_[t];
        share *=
            max0(min(place + half, pad_half) - max(place - half, -pad_half)) * Lane(1.0 / candidate.extent_m[t]);
      }
      const Lane kept = select(carrying & (share > Lane(0.0)), share_.get(c), share);
      share_.put(c, kept);
      near = near & (kept > Lane(0.0));
    } else {
      share_.put(c, Lane(1.0));
    }
    near_.put(c, select(near, Lane(1.0), Lane(0.0)));
    gap_now_.put(c, gap_now + least);
    gap_free_.put(c, gap_free + least);
    previous_.put(c, held);
    was_sliding_.put(c, sliding_.get(c));
    // N = k (1 + tau a1) p - k tau (a1 p_n + 2 p'_n + a3 p''_n); penetration p = -gap.
    const AxisMotion& carrier = carriers_of(now, surface)[axis];
    Lane surface_velocity = carrier.velocity_m_s, surface_acceleration = carrier.acceleration_m_s2;
    if (is_pad(surface)) {
      surface_velocity += Lane(normal_sign(surface)) * fingers.speed(surface);
      surface_acceleration += Lane(normal_sign(surface)) * fingers.acceleration(surface);
    }
    const Lane rate = -sign * (v.get(node + axis) - surface_velocity);
    const Lane second_rate = -sign * (a.get(node + axis) - surface_acceleration);
    offset_.put(c, relaxation_[surface] * w.viscous(-gap_now, rate, second_rate));
    normal_theta_.put(c, select(near, held, Lane(0.0)));
    tangent1_theta_.put(c, select(near, tangent1_theta_.get(c), Lane(0.0)));
    tangent2_theta_.put(c, select(near, tangent2_theta_.get(c), Lane(0.0)));
    // Where the contact is open its penetration is where the particle is, whatever it once was.
    penetration_.put(c, select(running & !carrying, -gap_now, penetration_.get(c)));
    if (none(near)) continue;
    // What the solve needs again and again.
    const double* own = model_.compliance.data() + 9 * candidate.contact_node * (model_.node_count() + 1);
    const auto tangents = tangent_axes(surface);
    const Lane shear = layer_stiffness(c) * Lane(1.0 / 3.0);
    layer_.put(c, normal_stiffness(c));
    shear_.put(c, shear);
    shear_relaxed_.put(
        c, Lane(1.0) / (Lane(1.0) + shear * Lane(std::max(own[4 * tangents[0]], own[4 * tangents[1]]))));
  }
  choose_active(running);
  rebase(base, running);
}

void ContactLanes::choose_active(const Mask& running) {
  active_node_.clear();
  live_candidate_.clear();
  has_near_ = Mask(false);
  node_force_.fill(0.0);
  for (std::size_t node = 0; node < model_.node_count(); ++node) {
    bool active = false;
    for (int c = model_.first_candidate[node]; c < model_.first_candidate[node + 1]; ++c) {
      const auto at = static_cast<std::size_t>(c);
      const bool near = any(near_.get(at) > Lane(0.0));
      if (near) has_near_ = has_near_ | (near_.get(at) > Lane(0.0));
      active = active || near;
      if (near || any(running & (normal_.get(at) > Lane(0.0)))) live_candidate_.push_back(c);
    }
    if (active) active_node_.push_back(static_cast<int>(node));
  }
}

void ContactLanes::rebase(const LaneArray& base, const Mask& lanes) {
  // Lanes that are solved already keep their sums: summing again would round them differently.
  std::array<Lane, 2> pad_force = {Lane(0.0), Lane(0.0)};
  for (int node : active_node_) {
    const auto at = 3 * static_cast<std::size_t>(node);
    std::array<Lane, 3> force = {Lane(0.0), Lane(0.0), Lane(0.0)};
    for (int c = model_.first_candidate[node]; c < model_.first_candidate[node + 1]; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const int surface = model_.candidate[k].surface;
      const auto tangents = tangent_axes(surface);
      force[static_cast<std::size_t>(normal_axis(surface))] += Lane(normal_sign(surface)) * normal_theta_.get(k);
      force[static_cast<std::size_t>(tangents[0])] += tangent1_theta_.get(k);
      force[static_cast<std::size_t>(tangents[1])] += tangent2_theta_.get(k);
      if (is_pad(surface)) pad_force[surface] += normal_theta_.get(k);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      base_.put(at + axis, select(lanes, base.get(at + axis), base_.get(at + axis)));
      node_force_.put(at + axis, select(lanes, force[axis], node_force_.get(at + axis)));
    }
  }
  for (std::size_t pad = 0; pad < 2; ++pad) pad_force_[pad] = select(lanes, pad_force[pad], pad_force_[pad]);
}

void ContactLanes::update_candidate(std::size_t c, const FingerLanes& fingers, const Mask& solving, bool careful,
                                    std::array<Lane, 3>& d, const double* own, Lane& largest_change,
                                    Lane& largest_force) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const Mask active = solving & (near_.get(c) > Lane(0.0));
  if (none(active)) return;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const auto tangents = tangent_axes(surface);
  const auto t1 = static_cast<std::size_t>(tangents[0]);
  const auto t2 = static_cast<std::size_t>(tangents[1]);
  const auto at = 3 * static_cast<std::size_t>(candidate.contact_node);
  const Lane sign(normal_sign(surface));
  const Lane layer = layer_.get(c);

  // Normal: N(p) of the layer at the solution, and p falls by (W_nn + finger compliance) per unit of N.
  Lane compliance(own[4 * axis]);
  std::array<Lane, 2> way = {Lane(0.0), Lane(0.0)};
  if (is_pad(surface)) {
    compliance += fingers.compliance();
    way[surface] = fingers.way_at_theta(surface, pad_force_);
  }
  const Lane gap = sign * (Lane(candidate.surface_m) + d[axis] - surface_place(surface, theta_, way));
  const Lane penetration = -gap;
  penetration_theta_.put(c, select(active, penetration, penetration_theta_.get(c)));
  const Lane rate_slope = a1_tau_factor_[surface] - Lane(1.0);
  const LayerLaw law = layer_law(candidate, penetration, rate_slope * penetration - offset_.get(c), rate_slope);
  const Lane old_normal = normal_theta_.get(c);
  // Newton on the layer's law; where its kinks make that go round in circles, the steepest slope cannot overshoot.
  const Lane slope = careful ? max(Lane(2.0), a1_tau_factor_[surface]) : law.slope;
  const Lane wanted = old_normal + (layer * law.force - old_normal) / (Lane(1.0) + layer * slope * compliance);
  const Lane normal = select(active, max0(wanted), old_normal);
  const Lane change = normal - old_normal;
  normal_theta_.put(c, normal);
  if (is_pad(surface)) pad_force_[surface] += change;
  for (std::size_t i = 0; i < 3; ++i) d[i] += Lane(own[3 * i + axis]) * sign * change;
  node_force_.put(at + axis, node_force_.get(at + axis) + sign * change);

  // Tangential: a spring to the anchor, held inside the friction cone.
  const Lane shear = shear_.get(c);
  const Lane inverse = shear_relaxed_.get(c);
  const Lane r1 = d[t1] - (is_pad(surface) ? theta_.palm[t1].place_m : Lane(0.0));
  const Lane r2 = d[t2] - (is_pad(surface) ? theta_.palm[t2].place_m : Lane(0.0));
  const Lane old1 = tangent1_theta_.get(c);
  const Lane old2 = tangent2_theta_.get(c);
  Lane new1 = old1 + (-shear * (r1 - anchor1_.get(c)) - old1) * inverse;
  Lane new2 = old2 + (-shear * (r2 - anchor2_.get(c)) - old2) * inverse;
  const Lane cone = friction_[surface] * normal;
  const Lane size2 = new1 * new1 + new2 * new2;
  const Mask sliding = size2 > cone * cone;
  const Lane scale = select(sliding, cone / sqrt(max(size2, Lane(1e-300))), Lane(1.0));
  new1 = select(active, new1 * scale, old1);
  new2 = select(active, new2 * scale, old2);
  sliding_.put(c, select(active, select(sliding, Lane(1.0), Lane(0.0)), sliding_.get(c)));
  tangent1_theta_.put(c, new1);
  tangent2_theta_.put(c, new2);
  const Lane change1 = new1 - old1;
  const Lane change2 = new2 - old2;
  for (std::size_t i = 0; i < 3; ++i) d[i] += Lane(own[3 * i + t1]) * change1 + Lane(own[3 * i + t2]) * change2;
  node_force_.put(at + t1, node_force_.get(at + t1) + change1);
  node_force_.put(at + t2, node_force_.get(at + t2) + change2);

  largest_change =
      max(largest_change, select(active, max(abs(change), max(abs(change1), abs(change2))), Lane(0.0)));
  largest_force = max(largest_force, select(active, normal, Lane(0.0)));
}

Lane ContactLanes::solve(const FingerLanes& fingers, const Mask& lanes) {
  Lane sweeps(0.0);
  unsolved_ = Mask(false);
  // A lane with nothing near takes no sweep, whatever its neighbours do.
  Mask solving = lanes & has_near_;
  const std::size_t m = model_.node_count();
  for (int sweep = 0; sweep < kMaxSweeps && any(solving) && !active_node_.empty(); ++sweep) {
    Lane largest_change(0.0), largest_force(0.0);
    for (int node : active_node_) {
      const auto i = static_cast<std::size_t>(node);
      std::array<Lane, 3> d = {base_.get(3 * i), base_.get(3 * i + 1), base_.get(3 * i + 2)};
      const double* row = model_.compliance.data() + 9 * i * m;
      add_blocks(row, active_node_, node_force_, d);
      const double* own = row + 9 * i;
      for (int c = model_.first_candidate[i]; c < model_.first_candidate[i + 1]; ++c) {
        update_candidate(static_cast<std::size_t>(c), fingers, solving, sweep >= kNewtonSweeps, d, own,
                         largest_change, largest_force);
      }
    }
    sweeps += select(solving, Lane(1.0), Lane(0.0));
    unsolved_ = solving & (largest_change > Lane(kUnsolved) * max(largest_force, Lane(1e-6)));
    solving = solving & (largest_change > Lane(kTolerance) * max(largest_force, Lane(1e-6)));
  }
  return sweeps;
}

void ContactLanes::end_step(const WilsonTheta& w, const LaneArray& u_theta, const LaneArray& u,
                            const std::vector<std::array<double, 3>>& position_m, const CarrierMotion& next,
                            const Mask& running) {
  for (SurfaceTally& tally : tally_) tally = SurfaceTally{};
  patch_pressure_ = Lane(0.0);
  first_touch_ = Lane(2.0);
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    // Anchors of open contacts go with the particle, so that a contact closes where it touches.
    const auto tangents = tangent_axes(model_.candidate[c].surface);
    const auto node = 3 * static_cast<std::size_t>(model_.candidate[c].node);
    const int surface = model_.candidate[c].surface;
    const Mask open = running & !(normal_theta_.get(c) > Lane(0.0));
    for (std::size_t t = 0; t < 2; ++t) {
      const auto axis = static_cast<std::size_t>(tangents[t]);
      const Lane place = u.get(node + axis) - (is_pad(surface) ? next.palm[axis].place_m : Lane(0.0));
      LaneArray& anchor = t == 0 ? anchor1_ : anchor2_;
      anchor.put(c, select(open, place, anchor.get(c)));
    }
  }
  for (int live : live_candidate_) {
    const auto c = static_cast<std::size_t>(live);
    const ContactCandidate& candidate = model_.candidate[c];
    const int surface = candidate.surface;
    SurfaceTally& tally = tally_[surface];
    const auto axis = static_cast<std::size_t>(normal_axis(surface));
    const auto tangents = tangent_axes(surface);
    const auto node = static_cast<std::size_t>(candidate.node);
    const Lane closed = select(running & (normal_theta_.get(c) > Lane(0.0)), Lane(1.0), Lane(0.0));
    const Mask is_closed = closed > Lane(0.0);
    const Lane sliding = closed * sliding_.get(c);

    const Lane old[3] = {normal_.get(c), tangent1_.get(c), tangent2_.get(c)};
    Lane now[3] = {w.at_end(old[0], normal_theta_.get(c)), w.at_end(old[1], tangent1_theta_.get(c)),
                   w.at_end(old[2], tangent2_theta_.get(c))};
    const Mask dust = (!is_closed) & (now[0] < Lane(kDust));
    for (int i = 0; i < 3; ++i) now[i] = select(running, select(dust, Lane(0.0), now[i]), old[i]);
    normal_.put(c, now[0]);
    tangent1_.put(c, now[1]);
    tangent2_.put(c, now[2]);

    // Where a contact slides, its anchor follows so that the spring stays on the cone.
    const Lane layer = layer_stiffness(c);
    const Lane shear = max(layer * Lane(1.0 / 3.0), Lane(1e-300));
    Lane moved[2];
    for (std::size_t t = 0; t < 2; ++t) {
      LaneArray& anchor = t == 0 ? anchor1_ : anchor2_;
      const LaneArray& force = t == 0 ? tangent1_theta_ : tangent2_theta_;
      const auto along = static_cast<std::size_t>(tangents[t]);
      const Lane place =
          u_theta.get(3 * node + along) - (is_pad(surface) ? theta_.palm[along].place_m : Lane(0.0));
      const Lane before = anchor.get(c);
      const Lane after = w.at_end(before, place + force.get(c) / shear);
      moved[t] = select(sliding > Lane(0.0), after - before, Lane(0.0));
      anchor.put(c, before + moved[t]);
    }
    const Mask near = running & (near_.get(c) > Lane(0.0));
    const Lane old_penetration = penetration_.get(c);
    const Lane penetration = select(near, w.at_end(old_penetration, penetration_theta_.get(c)), old_penetration);
    penetration_.put(c, penetration);
    const Mask viscous = near & (relaxation_[surface] > Lane(0.0));
    if (any(viscous)) {
      // Trapezoid rule over the way of the penetration, as forces and places are linear over the step. An open
      // layer that is still pressed carries nothing: its viscosity holds what its elasticity would push with.
      const Lane before =
          select(previous_.get(c) > Lane(0.0), viscous_.get(c), -elastic_force(c, old_penetration));
      const Lane after = w.at_end(before, normal_theta_.get(c) - elastic_force(c, penetration_theta_.get(c)));
      viscous_.put(c, select(viscous, after, viscous_.get(c)));
      // Only the way within the layer counts: beyond it there is no force.
      const Lane least(candidate.least_relief_m);
      const Lane way = max0(penetration - least) - max0(old_penetration - least);
      dissipated_ += select(viscous, Lane(0.5) * (before + after) * way, Lane(0.0));
    }
    Lane travel[2];
    for (std::size_t t = 0; t < 2; ++t) {
      LaneArray& way = t == 0 ? travel1_ : travel2_;
      travel[t] = select(is_closed, way.get(c) + moved[t], select(running, Lane(0.0), way.get(c)));
      way.put(c, travel[t]);
    }
    dissipated_ +=
        select(running, -Lane(0.5) * ((old[1] + now[1]) * moved[0] + (old[2] + now[2]) * moved[1]), Lane(0.0));

    tally.normal += select(running, now[0], Lane(0.0));
    tally.tangent[0] += select(running, now[1], Lane(0.0));
    tally.tangent[1] += select(running, now[2], Lane(0.0));
    tally.closed += closed;
    tally.sliding += sliding;
    tally.travel += closed * sqrt(travel[0] * travel[0] + travel[1] * travel[1]);
    tally_moments(c, now[0], tally);
    if (is_pad(surface)) {
      Lane arm[3], force[3];
      for (std::size_t i = 0; i < 3; ++i) {
        arm[i] = Lane(position_m[node][i]) + u.get(3 * node + i) - next.palm[i].place_m;
        if (i > 0) arm[i] -= pad_center_[i - 1];
      }
      force[axis] = Lane(normal_sign(surface)) * now[0];
      force[tangents[0]] = now[1];
      force[tangents[1]] = now[2];
      for (std::size_t i = 0; i < 3; ++i) {
        tally.torque[i] += select(
            running, arm[(i + 1) % 3] * force[(i + 2) % 3] - arm[(i + 2) % 3] * force[(i + 1) % 3], Lane(0.0));
      }
      const Mask touched = is_closed & !(previous_.get(c) > Lane(0.0));
      const Lane gap_now = max0(gap_now_.get(c));
      const Lane fraction = gap_now / max(gap_now - gap_free_.get(c), Lane(1e-300));
      first_touch_ = min(first_touch_, select(touched, min(fraction, Lane(1.0)), Lane(2.0)));
    }
  }
  for (int live : live_candidate_) {
    const auto c = static_cast<std::size_t>(live);
    Lane patch(0.0);
    for (std::size_t p = model_.patch_start[c]; p < model_.patch_start[c + 1]; ++p) {
      patch += Lane(model_.patch_weight[p].weight) *
               normal_.get(static_cast<std::size_t>(model_.patch_weight[p].candidate));
    }
    patch_pressure_ = max(patch_pressure_, select(running, patch / Lane(model_.patch_area_m2), Lane(0.0)));
  }
}

void ContactLanes::tally_moments(std::size_t c, const Lane& normal, SurfaceTally& tally) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const Lane y(candidate.place_m[0]), z(candidate.place_m[1]);
  Lane m1[2] = {y, z};
  Lane m2[3] = {y * y, z * z, y * z};
  if (!candidate.flat) {
    // The force sits where the places touch, in proportion to their depth.
    const Lane p = penetration_theta_.get(c);
    Lane sum(0.0), first[2] = {0.0, 0.0}, second[3] = {0.0, 0.0, 0.0};
    for (int q = 0; q < kReliefPlaces; ++q) {
      const Lane depth = max0(p - Lane(candidate.relief_m[static_cast<std::size_t>(q)]));
      const auto offset = relief_offset(q);
      const Lane yq(candidate.place_m[0] + offset[0] * candidate.extent_m[0]);
      const Lane zq(candidate.place_m[1] + offset[1] * candidate.extent_m[1]);
      sum += depth;
      first[0] += depth * yq;
      first[1] += depth * zq;
      second[0] += depth * yq * yq;
      second[1] += depth * zq * zq;
      second[2] += depth * yq * zq;
    }
    const Mask spread = sum > Lane(1e-12);
    const Lane inverse = Lane(1.0) / max(sum, Lane(1e-12));
    for (int i = 0; i < 2; ++i) m1[i] = select(spread, first[i] * inverse, m1[i]);
    for (int i = 0; i < 3; ++i) m2[i] = select(spread, second[i] * inverse, m2[i]);
  }
  for (std::size_t i = 0; i < 2; ++i) tally.first[i] += normal * m1[i];
  for (std::size_t i = 0; i < 3; ++i) tally.second[i] += normal * m2[i];
}

Lane ContactLanes::elastic_force(std::size_t c, const Lane& penetration) const {
  return normal_stiffness(c) * layer_law(model_.candidate[c], penetration, Lane(0.0), Lane(0.0)).force;
}

Lane ContactLanes::stored_energy() const {
  Lane energy(0.0);
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    const ContactCandidate& candidate = model_.candidate[c];
    const Mask closed = normal_theta_.get(c) > Lane(0.0);
    // A viscous layer that recovers more slowly than the particle leaves is still pressed when it carries nothing.
    const Mask viscous = (relaxation_[candidate.surface] > Lane(0.0)) & (penetration_.get(c) > Lane(0.0));
    if (none(closed | viscous)) continue;
    const Lane press = normal_stiffness(c);
    const Lane n = normal_.get(c), t1 = tangent1_.get(c), t2 = tangent2_.get(c);
    const Lane in_place = press * squared_depth(candidate, penetration_.get(c)) * Lane(0.5);
    Lane stored = in_place;
    if (candidate.flat) stored = select(viscous, in_place, Lane(0.5) * n * n / max(press, Lane(1e-300)));
    const Lane sheared = Lane(1.5) * (t1 * t1 + t2 * t2) / max(layer_stiffness(c), Lane(1e-300));
    energy += select(closed, stored + sheared, select(viscous, stored, Lane(0.0)));
  }
  return energy;
}

Lane ContactLanes::lattice_patch_area(int pad) const {
  const SurfaceTally& t = tally_[pad];
  const Lane force = max(t.normal, Lane(1e-9));
  const Lane y = t.first[0] / force, z = t.first[1] / force;
  // The moments of one loaded particle vanish; its force still spreads over its tributary rectangle.
  const Lane least_y(model_.pad_extent_m[0] * model_.pad_extent_m[0] / 12.0);
  const Lane least_z(model_.pad_extent_m[1] * model_.pad_extent_m[1] / 12.0);
  const Lane yy = max(t.second[0] / force - y * y, least_y);
  const Lane zz = max(t.second[1] / force - z * z, least_z);
  const Lane yz = t.second[2] / force - y * z;
  return Lane(model_.patch_form[pad].area_factor) * sqrt(max(yy * zz - yz * yz, least_y * least_z));
}

Lane ContactLanes::patch_area(int pad) const {
  const PatchForm& form = model_.patch_form[pad];
  const Lane lattice = lattice_patch_area(pad);
  if (form.hertz_area_m2_N23 == 0.0) return lattice;
  // A patch about as large as a cell is not resolved by the lattice: elasticity gives its area at the measured
  // force. Where it reaches past the pad the lattice takes over, in proportion: by then it spans the pad's many
  // cells.
  const Lane force = max(tally_[pad].normal, Lane(1e-9));
  Lane hertz(0.0);
  for (int lane = 0; lane < kLanes; ++lane) {
    const double root = std::cbrt(force[lane]);
    hertz.set(lane, form.hertz_area_m2_N23 * root * root);
  }
  const Lane elastic = sqrt(hertz * hertz + Lane(form.layer_area_m) * force / stiffness_[pad]);
  Lane under_pad(1.0);
  for (std::size_t i = 0; i < 2; ++i) {
    const Lane half = Lane(form.semi_axis[i]) * sqrt(elastic);
    const Lane place = Lane(form.pole_m[i]) - pad_center_[i];
    const Lane pad_half = Lane(0.5) * pad_size_[i];
    under_pad *= max0(min(place + half, pad_half) - max(place - half, -pad_half)) / (Lane(2.0) * half);
  }
  return under_pad * elastic + (Lane(1.0) - under_pad) * lattice;
}

Lane ContactLanes::yield_ratio(int pad, const Lane& yield_stress) const {
  const Lane& force = tally_[pad].normal;
  const Lane strength = Lane(model_.patch_form[pad].yield_factor) * yield_stress;
  return select(force > Lane(1e-9), force / (max(patch_area(pad), Lane(1e-30)) * strength), Lane(0.0));
}

Lane ContactLanes::force_along(int surface, std::size_t axis) const {
  const SurfaceTally& t = tally_[surface];
  const auto tangents = tangent_axes(surface);
  for (std::size_t i = 0; i < 2; ++i) {
    if (axis == static_cast<std::size_t>(tangents[i])) return t.tangent[i];
  }
  return Lane(normal_sign(surface)) * t.normal;
}

std::array<double, 3> ContactLanes::surface_force(int surface, int lane) const {
  const SurfaceTally& t = tally_[surface];
  std::array<double, 3> force{};
  force[static_cast<std::size_t>(normal_axis(surface))] = normal_sign(surface) * t.normal[lane];
  const auto tangents = tangent_axes(surface);
  for (std::size_t i = 0; i < 2; ++i) force[static_cast<std::size_t>(tangents[i])] = t.tangent[i][lane];
  return force;
}

void ContactLanes::record_events(int lane, double step_start_s, const WilsonTheta& w,
                                 std::vector<ContactEvent>& events) const {
  for (int live : live_candidate_) {
    const auto c = static_cast<std::size_t>(live);
    const ContactCandidate& candidate = model_.candidate[c];
    const bool was = previous_.at(c, lane) > 0.0;
    const bool is = normal_theta_.at(c, lane) > 0.0;
    const double gap_now = std::max(0.0, gap_now_.at(c, lane));
    const double gap_free = gap_free_.at(c, lane);
    const double fraction = is ? (gap_now - gap_free > 0.0 ? gap_now / (gap_now - gap_free) : 0.0) : 0.5;
    const double time = step_start_s + w.theta * w.dt * std::clamp(fraction, 0.0, 1.0);
    using Kind = ContactEvent::Kind;
    if (is != was) events.push_back({time, candidate.node, candidate.surface, is ? Kind::make : Kind::break_});
    const bool slid = was && was_sliding_.at(c, lane) > 0.0;
    const bool slides = is && sliding_.at(c, lane) > 0.0;
    if (is && slid != slides) {
      events.push_back(
          {step_start_s + w.theta * w.dt, candidate.node, candidate.surface, slides ? Kind::slip : Kind::stick});
    }
  }
}

}  // namespace unbruised
