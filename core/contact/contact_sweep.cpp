#include "core/contact/contact_sweep.hpp"

#include <algorithm>

#include "core/algebra/lane_matrix.hpp"
#include "core/contact/layer_law.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Relative change of the forces in a sweep below which a lane is solved.
constexpr double kTolerance = 1e-8;
/// Twenty suffice at steps that resolve the contact; long steps with light fingers need some hundred.
constexpr int kMaxSweeps = 1000;
/// After this many sweeps a lane that is still moving is solved carefully.
constexpr int kNewtonSweeps = 40;
/// Relative change in the last sweep above which forces must not be used.
constexpr double kUnsolved = 1e-4;
/// Changes are measured against at least this force [N].
constexpr double kLeastForce = 1e-6;

}  // namespace

ContactSweep::ContactSweep(const ContactModel& model, const SurfaceLanes& surfaces, ContactRegister& contacts)
    : model_(model), surfaces_(surfaces), contacts_(contacts) {
  require(model.compliance.size() == 9 * model.node_count() * model.node_count(),
          "ContactSweep: the contact model has no compliance yet");
  for (LaneArray* rows : {&viscous_, &layer_, &shear_, &shear_relaxed_}) *rows = LaneArray(model.candidate.size());
  for (LaneArray* rows : {&base_, &node_force_}) *rows = LaneArray(3 * model.node_count());
  rate_slope_.fill(Lane(0.0));
}

void ContactSweep::begin_step(const WilsonTheta& w, const CarrierMotion& theta) {
  theta_ = theta;
  for (int s = 0; s < kSurfaceCount; ++s) {
    rate_slope_[s] = (Lane(1.0) + Lane(w.a1) * surfaces_[s].relaxation_s) - Lane(1.0);
  }
  node_force_.fill(0.0);
}

void ContactSweep::prepare(std::size_t c, const Lane& viscous) {
  viscous_.put(c, viscous);
  if (none(contacts_.near.get(c))) return;
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  const double* own = model_.compliance.data() + 9 * candidate.contact_node * (model_.node_count() + 1);
  const auto tangents = tangent_axes(candidate.surface);
  const Lane shear = contacts_.layer_stiffness(c, surface) * Lane(1.0 / 3.0);
  layer_.put(c, contacts_.normal_stiffness(c, surface));
  shear_.put(c, shear);
  const double compliance = std::max(own[4 * tangents[0]], own[4 * tangents[1]]);
  shear_relaxed_.put(c, Lane(1.0) / (Lane(1.0) + shear * Lane(compliance)));
}

void ContactSweep::list_active(const Mask& running) {
  active_node_.clear();
  live_candidate_.clear();
  has_near_ = Mask(false);
  for (std::size_t node = 0; node < model_.node_count(); ++node) {
    bool active = false;
    for (int c = model_.first_candidate[node]; c < model_.first_candidate[node + 1]; ++c) {
      const auto at = static_cast<std::size_t>(c);
      const Mask near = contacts_.near.get(at);
      has_near_ = has_near_ | near;
      active = active || any(near);
      if (any(near | (running & (contacts_.normal.get(at) > Lane(0.0))))) live_candidate_.push_back(c);
    }
    if (active) active_node_.push_back(static_cast<int>(node));
  }
}

void ContactSweep::rebase(const LaneArray& base, const Mask& lanes) {
  require(base.rows() == base_.rows(), "ContactSweep::rebase: displacements of other contact nodes");
  // Lanes that are solved already keep their sums: summing again would round them differently.
  PadForces pad_force = without_force();
  for (int node : active_node_) {
    const auto at = 3 * static_cast<std::size_t>(node);
    std::array<Lane, 3> force = {Lane(0.0), Lane(0.0), Lane(0.0)};
    for (int c = model_.first_candidate[node]; c < model_.first_candidate[node + 1]; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const int surface = model_.candidate[k].surface;
      const auto tangents = tangent_axes(surface);
      const Lane normal = contacts_.normal_theta.get(k);
      force[static_cast<std::size_t>(normal_axis(surface))] += Lane(normal_sign(surface)) * normal;
      for (std::size_t t = 0; t < 2; ++t) {
        force[static_cast<std::size_t>(tangents[t])] += contacts_.tangent_theta[t].get(k);
      }
      if (is_pad(surface)) pad_force[surface] += normal;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      base_.put(at + axis, select(lanes, base.get(at + axis), base_.get(at + axis)));
      node_force_.put(at + axis, select(lanes, force[axis], node_force_.get(at + axis)));
    }
  }
  for (std::size_t pad = 0; pad < kFingerCount; ++pad) {
    pad_force_[pad] = select(lanes, pad_force[pad], pad_force_[pad]);
  }
}

// The three of a sweep's innermost loop are one piece of code: lane values stay in registers.

/// Normal: N(p) of the layer at the solution, and p falls by (W_nn + finger compliance) per unit of N.
/// @return change of the force
[[gnu::always_inline]] inline Lane ContactSweep::update_normal(std::size_t c, const GripperLanes& gripper,
                                                               const Mask& active, Slope slope, Node& node) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const Lane sign(normal_sign(surface));
  const Lane layer = layer_.get(c);
  Lane compliance(node.own[4 * axis]), way(0.0);
  if (is_pad(surface)) {
    compliance += gripper.compliance();
    way = gripper.way_at_theta(surface, pad_force_);
  }
  const Lane gap = sign * (Lane(candidate.surface_m) + node.d[axis] - surfaces_.place(surface, theta_, way));
  const Lane penetration = -gap;
  contacts_.penetration_theta.put(c, select(active, penetration, contacts_.penetration_theta.get(c)));
  const Lane& rate_slope = rate_slope_[surface];
  const Lane old_normal = contacts_.normal_theta.get(c);
  // Below every place the law is flat and says nothing of where the contact is: look from where it would stand
  // without its force.
  const Mask below = penetration <= Lane(candidate.least_relief_m);
  const Lane from = select(below, Lane(0.0), old_normal);
  const Lane at = select(below, penetration + compliance * old_normal, penetration);
  const LayerLaw law = layer_law(candidate, at, rate_slope * at - viscous_.get(c), rate_slope, contacts_.cover(c));
  const Lane down = slope == Slope::steepest ? max(Lane(2.0), Lane(1.0) + rate_slope) : law.slope;
  const Lane wanted = from + (layer * law.force - from) / (Lane(1.0) + layer * down * compliance);
  const Lane normal = select(active, max0(wanted), old_normal);
  const Lane change = normal - old_normal;
  contacts_.normal_theta.put(c, normal);
  if (is_pad(surface)) pad_force_[surface] += change;
  for (std::size_t i = 0; i < 3; ++i) node.d[i] += Lane(node.own[3 * i + axis]) * sign * change;
  node_force_.put(node.row + axis, node_force_.get(node.row + axis) + sign * change);
  return change;
}

/// Tangential: a spring to the anchor, held inside the friction cone.
/// @return the larger of the changes
[[gnu::always_inline]] inline Lane ContactSweep::update_tangent(std::size_t c, const Mask& active, Node& node) {
  const int surface = model_.candidate[c].surface;
  const auto tangents = tangent_axes(surface);
  const auto t1 = static_cast<std::size_t>(tangents[0]);
  const auto t2 = static_cast<std::size_t>(tangents[1]);
  const auto& carrier = carrier_of(surface, theta_);
  const Lane shear = shear_.get(c);
  const Lane inverse = shear_relaxed_.get(c);
  const Lane r1 = node.d[t1] - carrier[t1].place_m;
  const Lane r2 = node.d[t2] - carrier[t2].place_m;
  const Lane old1 = contacts_.tangent_theta[0].get(c);
  const Lane old2 = contacts_.tangent_theta[1].get(c);
  Lane new1 = old1 + (-shear * (r1 - contacts_.anchor[0].get(c)) - old1) * inverse;
  Lane new2 = old2 + (-shear * (r2 - contacts_.anchor[1].get(c)) - old2) * inverse;
  const Lane cone = surfaces_[surface].friction * contacts_.normal_theta.get(c);
  const Lane size2 = new1 * new1 + new2 * new2;
  const Mask sliding = size2 > cone * cone;
  const Lane scale = select(sliding, cone / sqrt(max(size2, Lane(1e-300))), Lane(1.0));
  new1 = select(active, new1 * scale, old1);
  new2 = select(active, new2 * scale, old2);
  contacts_.sliding.put(c, (active & sliding) | ((!active) & contacts_.sliding.get(c)));
  contacts_.tangent_theta[0].put(c, new1);
  contacts_.tangent_theta[1].put(c, new2);
  const Lane change1 = new1 - old1;
  const Lane change2 = new2 - old2;
  for (std::size_t i = 0; i < 3; ++i) {
    node.d[i] += Lane(node.own[3 * i + t1]) * change1 + Lane(node.own[3 * i + t2]) * change2;
  }
  node_force_.put(node.row + t1, node_force_.get(node.row + t1) + change1);
  node_force_.put(node.row + t2, node_force_.get(node.row + t2) + change2);
  return max(abs(change1), abs(change2));
}

[[gnu::always_inline]] inline void ContactSweep::update_candidate(std::size_t c, const GripperLanes& gripper,
                                                                  Pass& pass, Node& node) {
  const Mask active = pass.solving & contacts_.near.get(c);
  if (none(active)) return;
  const Lane change = abs(update_normal(c, gripper, active, pass.slope, node));
  const Lane change_across = update_tangent(c, active, node);
  pass.largest_change = max(pass.largest_change, select(active, max(change, change_across), Lane(0.0)));
  pass.largest_force = max(pass.largest_force, select(active, contacts_.normal_theta.get(c), Lane(0.0)));
}

Lane ContactSweep::solve(const GripperLanes& gripper, const Mask& lanes) {
  Lane sweeps(0.0);
  unsolved_ = Mask(false);
  // A lane with nothing near takes no sweep, whatever its neighbours do.
  Mask solving = lanes & has_near_;
  const std::size_t m = model_.node_count();
  for (int sweep = 0; sweep < kMaxSweeps && any(solving) && !active_node_.empty(); ++sweep) {
    Pass pass{solving, sweep >= kNewtonSweeps ? Slope::steepest : Slope::tangent};
    for (int active : active_node_) {
      const auto i = static_cast<std::size_t>(active);
      const double* row = model_.compliance.data() + 9 * i * m;
      Node node{3 * i, row + 9 * i, {base_.get(3 * i), base_.get(3 * i + 1), base_.get(3 * i + 2)}};
      add_blocks(row, active_node_, node_force_, node.d);
      for (int c = model_.first_candidate[i]; c < model_.first_candidate[i + 1]; ++c) {
        update_candidate(static_cast<std::size_t>(c), gripper, pass, node);
      }
    }
    sweeps += select(solving, Lane(1.0), Lane(0.0));
    const Lane force = max(pass.largest_force, Lane(kLeastForce));
    unsolved_ = solving & (pass.largest_change > Lane(kUnsolved) * force);
    solving = solving & (pass.largest_change > Lane(kTolerance) * force);
  }
  return sweeps;
}

}  // namespace unbruised
