#include "core/contact/contact_sweep.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/algebra/lane_matrix.hpp"
#include "core/contact/answering_surfaces.hpp"
#include "core/contact/contact_sweep_nodes.hpp"
#include "core/contact/deflated_surfaces.hpp"
#include "core/contact/layer_law.hpp"
#include "core/contact/surface_tally.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Relative change of the forces in a sweep below which a lane is solved.
constexpr double kTolerance = 1e-8;
/// Twenty suffice at steps that resolve the contact; long steps with light fingers need some hundred.
constexpr double kMaxSweeps = 1000.0;
/// After this many sweeps a lane that is still moving is solved carefully.
constexpr int kNewtonSweeps = 40;
/// How often a node that meets several surfaces is looked at again in a sweep. Where one presses along the axis
/// that another shears, each of them undoes three quarters of what the other did; twice makes sweeps of a block
/// that is gripped on its support half as many, four times no fewer (docs/performance.md).
constexpr int kAgain = 2;
/// A step of more sweeps is a slow one. After it a lane in which all that is pressed sticks finds those forces at
/// once (stuck_patches.hpp), which costs as much as four to five sweeps, as long as no more sweeps are left for it
/// then.
constexpr double kSlowSweeps = 7.0;
/// A step of more sweeps is a hard one. After so many of them in a row the patches of a lane answer as wholes, in
/// which a sweep takes two to three times as long (docs/contact.md, "Long steps"), for two steps; then it tries
/// without them, and goes on with them where that would be a hard step again. Each time it waits four times as
/// many steps with the next trial, at most so many.
constexpr double kHardSweeps = 80.0, kHardSteps = 2.0, kMostDeflatedSteps = 64.0;
/// Relative change in the last sweep above which forces must not be used.
constexpr double kUnsolved = 1e-4;

}  // namespace

ContactSweep::ContactSweep(const ContactModel& model, const SurfaceLanes& surfaces, ContactRegister& contacts,
                           const ShapedPads* shaped)
    : model_(model), surfaces_(surfaces), contacts_(contacts), shaped_(shaped) {
  require(model.compliance.size() == 9 * model.node_count() * model.node_count(),
          "ContactSweep: the contact model has no compliance yet");
  for (LaneArray* rows : {&viscous_, &layer_, &shear_, &shear_relaxed_}) *rows = LaneArray(model.candidate.size());
  for (LaneArray* rows : {&base_, &node_force_, &left_force_}) *rows = LaneArray(3 * model.node_count());
  rate_slope_.fill(Lane(0.0));
  if (!model.place.empty()) levers_ = LeverSums(model.turn_per_moment);
}

void ContactSweep::begin_step(const WilsonTheta& w, const CarrierMotion& theta, const Eyes& eyes,
                              MountedContacts* mounted, PadContacts* pads) {
  theta_ = &theta;
  eyes_ = eyes;
  mounted_ = mounted;
  pads_ = pads;
  if ((eyes_.frame != nullptr || model_.shaped_pads) && own_.rows() == 0)
    own_ = LaneArray(9 * model_.candidate.size());
  for (const int s : model_.surface) {
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
  Lane compliance(std::max(own[4 * tangents[0]], own[4 * tangents[1]]));
  if (eyes_.frame != nullptr || model_.is_shaped(c)) {
    prepare_turned(c);
    const std::size_t row = 9 * c;
    compliance = max(own_.get(row + 4 * static_cast<std::size_t>(tangents[0])),
                     own_.get(row + 4 * static_cast<std::size_t>(tangents[1])));
  }
  if (mounted_ != nullptr) {
    compliance += max(mounted_->own_compliance(c, static_cast<std::size_t>(tangents[0])),
                      mounted_->own_compliance(c, static_cast<std::size_t>(tangents[1])));
  }
  if (pads_ != nullptr && pads_->has(c)) {
    compliance += max(pads_->own_compliance(c, static_cast<std::size_t>(tangents[0])),
                      pads_->own_compliance(c, static_cast<std::size_t>(tangents[1])));
  }
  shear_relaxed_.put(c, Lane(1.0) / (Lane(1.0) + shear * compliance));
}

void ContactSweep::list_active(const Mask& running, std::span<const int> awake) {
  active_node_.clear();
  live_candidate_.clear();
  near_candidate_.clear();
  first_near_.clear();
  near_node_.clear();
  shared_node_.clear();
  has_near_ = Mask(false);
  is_first_solve_ = true;
  effort_.deflated_steps = select(running, max0(effort_.deflated_steps - Lane(1.0)), effort_.deflated_steps);
  for (const int c : awake) {
    const auto at = static_cast<std::size_t>(c);
    const Mask near = contacts_.near.get(at);
    const bool is_near = any(near);
    if (is_near || any(running & (contacts_.normal.get(at) > Lane(0.0)))) live_candidate_.push_back(c);
    if (!is_near) continue;
    has_near_ = has_near_ | near;
    const int node = model_.candidate[at].contact_node;
    if (active_node_.empty() || active_node_.back() != node) {
      active_node_.push_back(node);
      first_near_.push_back(near_candidate_.size());
      near_node_.push_back(Mask(false));
      shared_node_.push_back(Mask(false));
    }
    shared_node_.back() = shared_node_.back() | (near_node_.back() & near);
    near_node_.back() = near_node_.back() | near;
    near_candidate_.push_back(c);
  }
  first_near_.push_back(near_candidate_.size());
  if (pads_ != nullptr) pads_->list_near(near_candidate_);
}

void ContactSweep::rebase(const FreeMotion& free, const Mask& lanes) {
  const LaneArray& base = free.displacement;
  require(base.rows() == base_.rows(), "ContactSweep::rebase: displacements of other contact nodes");
  held_ = free.held;
  // Lanes that are solved already keep their sums: summing again would round them differently.
  PadForces pad_force = without_force();
  if (eyes_.places != nullptr) levers_.restart(free.moment_N_m, lanes);
  if (mounted_ != nullptr) mounted_->restart(lanes);
  if (pads_ != nullptr) pads_->restart(lanes);
  for (std::size_t a = 0; a < active_node_.size(); ++a) {
    const int node = active_node_[a];
    const auto at = 3 * static_cast<std::size_t>(node);
    std::array<Lane, 3> force = {Lane(0.0), Lane(0.0), Lane(0.0)};
    for (const int c : near_of(a)) {  // the others carry nothing
      const auto k = static_cast<std::size_t>(c);
      const ContactCandidate& candidate = model_.candidate[k];
      const LaneVector by_candidate = force_in_frame(k);
      for (std::size_t i = 0; i < 3; ++i) force[i] += by_candidate[i];
      if (is_pad(candidate.surface)) pad_force[finger_of(candidate.surface)] += closing_force(k);
      if (mounted_ != nullptr) mounted_->push(k, select(lanes, force_on_carrier(k), LaneVector{}));
      if (pads_ != nullptr && pads_->has(k)) {
        pad_force[candidate.surface] -= pads_->push(k, select(lanes, force_on_carrier(k), LaneVector{}));
      }
      if (eyes_.places == nullptr) continue;
      levers_.add(rest_place_m(static_cast<std::size_t>(node)), arm_of(candidate),
                  select(lanes, by_candidate, LaneVector{}));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      base_.put(at + axis, select(lanes, base.get(at + axis), base_.get(at + axis)));
      if (held_.force_N != nullptr) force[axis] -= select(near_node_[a], held_.force_N->get(at + axis), Lane(0.0));
      node_force_.put(at + axis, select(lanes, force[axis], node_force_.get(at + axis)));
    }
  }
  if (held_.force_N != nullptr) take_left_forces_off(lanes);
  for (std::size_t pad = 0; pad < kMostFingers; ++pad) {
    pad_force_[pad] = select(lanes, pad_force[pad], pad_force_[pad]);
  }
}

/// Of the base, those that are held where nothing is near any more. Lane by lane, so that it is no matter what is
/// near in others.
void ContactSweep::take_left_forces_off(const Mask& lanes) {
  left_node_.clear();
  for (const int node : held_.on) {
    const auto active = std::ranges::lower_bound(active_node_, node);
    const bool is_active = active != active_node_.end() && *active == node;
    const Mask near =
        is_active ? near_node_[static_cast<std::size_t>(active - active_node_.begin())] : Mask(false);
    const Mask left = lanes & has_near_ & !near;
    if (none(left)) continue;
    Mask any_force(false);
    for (std::size_t row = 3 * static_cast<std::size_t>(node), end = row + 3; row < end; ++row) {
      const Lane force = select(left, held_.force_N->get(row), Lane(0.0));
      left_force_.put(row, force);
      any_force = any_force | !(force == Lane(0.0));
    }
    if (any(any_force)) left_node_.push_back(node);
  }
  if (left_node_.empty()) return;
  subtract_product(model_.compliance, model_.node_count(), active_node_, left_node_, left_force_, lanes, base_);
}

/// The forces on nodes are all of them again.
void ContactSweep::count_held(const Mask& lanes) {
  if (held_.force_N == nullptr) return;
  for (std::size_t a = 0; a < active_node_.size(); ++a) {
    const Mask here = lanes & near_node_[a];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = 3 * static_cast<std::size_t>(active_node_[a]) + axis;
      node_force_.put(at, node_force_.get(at) + select(here, held_.force_N->get(at), Lane(0.0)));
    }
  }
}

// The three of a sweep's innermost loop are one piece of code: lane values stay in registers.

/// N(p) of the layer at the solution, where p falls by `compliance` per unit of N.
/// @return change of the force
[[gnu::always_inline]] inline Lane ContactSweep::press(std::size_t c, const Lane& gap, const Lane& compliance,
                                                       const Mask& active, Slope slope) {
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  const Lane layer = layer_.get(c);
  const Lane penetration = -gap;
  contacts_.penetration_theta.put(c, select(active, penetration, contacts_.penetration_theta.get(c)));
  const Lane& rate_slope = rate_slope_[candidate.surface];
  const Lane old_normal = contacts_.normal_theta.get(c);
  // Below every place the law is flat and says nothing of where the contact is: look from where it would stand
  // without its force.
  const Mask below = penetration <= contacts_.least_relief(c);
  const Lane from = select(below, Lane(0.0), old_normal);
  const Lane at = select(below, penetration + compliance * old_normal, penetration);
  const LayerLaw law = layer_law(candidate, at, rate_slope * at - viscous_.get(c), rate_slope, contacts_.cover(c));
  if (deflating_) note_law(c, at, law, active);
  const Lane down = slope == Slope::steepest ? max(Lane(2.0), Lane(1.0) + rate_slope) : law.slope;
  Lane wanted = from + (layer * law.force - from) / (Lane(1.0) + layer * down * compliance);
  // There a step along the steepest slope would be a part of the force only, whatever the contact carries already,
  // and sweeps would throw it to and fro.
  const Mask exact = slope == Slope::steepest ? surface.curve.lanes() | (active & below) : surface.curve.lanes();
  if (any(exact)) {
    const Lane by_law = force_by_law(c, penetration + compliance * old_normal, compliance, exact);
    wanted = select(exact, by_law, wanted);
  }
  const Lane normal = select(active, max0(wanted), old_normal);
  contacts_.normal_theta.put(c, normal);
  return normal - old_normal;
}

/// A spring to the anchor, held inside the friction cone. @param r from where the particle is at rest @param
/// relaxed 1 / (1 + shear x compliance)
/// @return changes of the force
[[gnu::always_inline]] inline std::array<Lane, 2> ContactSweep::drag(std::size_t c, const std::array<Lane, 2>& r,
                                                                     const Lane& relaxed, const Mask& active) {
  const int surface = model_.candidate[c].surface;
  const Lane shear = shear_.get(c);
  const Lane old1 = contacts_.tangent_theta[0].get(c);
  const Lane old2 = contacts_.tangent_theta[1].get(c);
  Lane new1 = old1 + (-shear * (r[0] - contacts_.anchor[0].get(c)) - old1) * relaxed;
  Lane new2 = old2 + (-shear * (r[1] - contacts_.anchor[1].get(c)) - old2) * relaxed;
  const Lane cone = surfaces_[surface].friction * contacts_.normal_theta.get(c);
  const Lane size2 = new1 * new1 + new2 * new2;
  const Mask sliding = size2 > cone * cone;
  if (any(active & sliding)) {
    const Lane scale = select(sliding, cone / sqrt(max(size2, Lane(1e-300))), Lane(1.0));
    new1 *= scale;
    new2 *= scale;
  }
  new1 = select(active, new1, old1);
  new2 = select(active, new2, old2);
  contacts_.sliding.put(c, (active & sliding) | ((!active) & contacts_.sliding.get(c)));
  contacts_.tangent_theta[0].put(c, new1);
  contacts_.tangent_theta[1].put(c, new2);
  return {new1 - old1, new2 - old2};
}

/// @return change of the normal force
template <class Mounting, class AnyNode>
[[gnu::always_inline]] inline Lane ContactSweep::update_normal(std::size_t c, const GripperLanes& gripper,
                                                               const Mask& active, Slope slope, AnyNode& node,
                                                               Mounting& mounting) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const Lane sign(normal_sign(surface));
  Lane compliance = node.compliance(axis), way(0.0);
  if (is_pad(surface)) {
    compliance += gripper.compliance();
    way = gripper.way_at_theta(static_cast<int>(finger_of(surface)), mounting.pad_forces());
  }
  Lane place = surfaces_.place(surface, *theta_, way);
  mounting.give_way(c, axis, compliance, place);
  const Lane change =
      press(c, sign * (Lane(candidate.surface_m) + node.d[axis] - place), compliance, active, slope);
  const Lane own = mounting.own_normal(c, change);
  if (is_pad(surface)) pad_force_[finger_of(surface)] += own;
  node.push(axis, sign, own);
  mounting.push(axis, sign * own);
  return change;
}

/// @return the larger of the changes along the tangents
template <class Mounting, class AnyNode>
[[gnu::always_inline]] inline Lane ContactSweep::update_tangent(std::size_t c, const Mask& active, AnyNode& node,
                                                                Mounting& mounting) {
  const int surface = model_.candidate[c].surface;
  const auto tangents = tangent_axes(surface);
  const auto t1 = static_cast<std::size_t>(tangents[0]);
  const auto t2 = static_cast<std::size_t>(tangents[1]);
  const auto& carrier = carrier_of(surface, *theta_);
  mounting.begin_tangents(c);
  const Lane r1 = node.d[t1] - mounting.place(t1, carrier[t1].place_m);
  const Lane r2 = node.d[t2] - mounting.place(t2, carrier[t2].place_m);
  const Lane relaxed = mounting.relaxed(c, shear_relaxed_.get(c), {node.compliance(t1), node.compliance(t2)});
  const auto [change1, change2] = drag(c, {r1, r2}, relaxed, active);
  const Lane own1 = mounting.own_tangent(c, 0, change1), own2 = mounting.own_tangent(c, 1, change2);
  node.push({t1, t2}, {own1, own2});
  mounting.push(t1, own1);
  mounting.push(t2, own2);
  return max(abs(change1), abs(change2));
}

/// A shaped pad, in the axes of the candidate: the finger goes along the closing direction, which is none of them.
/// @param node in the axes of the pad's carrier, with the candidate's own compliance in its own axes
template <class Mounting>
[[gnu::always_inline]] inline void ContactSweep::update_shaped(std::size_t c, const GripperLanes& gripper,
                                                               const Mask& active, Pass& pass, TurnedNode& node) {
  const ContactCandidate& candidate = model_.candidate[c];
  const auto pad = static_cast<std::size_t>(candidate.surface);
  const Lane sign(normal_sign(candidate.surface));
  Mounting mounting(*this, gripper);
  mounting.begin(c);
  const LaneVector closing{
      {sign * shaped_->axis(c, 0, 0), sign * shaped_->axis(c, 1, 0), sign * shaped_->axis(c, 2, 0)}};
  Lane way = gripper.way_at_theta(candidate.surface, pad_force_);
  const auto& carrier = carrier_of(candidate.surface, *theta_);
  LaneVector x = shaped_->seen(
      c, {{Lane(candidate.surface_m) + node.d[0] -
               mounting.place(0, surfaces_.place(candidate.surface, *theta_, way)),
           node.d[1] - mounting.place(1, carrier[1].place_m), node.d[2] - mounting.place(2, carrier[2].place_m)}});
  const Lane& finger = gripper.compliance();
  const Lane mount =
      mounting.compliance_along(c, {{shaped_->axis(c, 0, 0), shaped_->axis(c, 0, 1), shaped_->axis(c, 0, 2)}});
  const Lane normal = press(c, shaped_->gap_m(c, x), node.block(0, 0) + finger * closing[0] * closing[0] + mount,
                            active, pass.slope);
  pad_force_[pad] += sign * closing[0] * normal;
  const Lane went = gripper.way_at_theta(candidate.surface, pad_force_) - way;
  for (std::size_t i = 0; i < 3; ++i) x[i] += node.block(i, 0) * sign * normal - closing[i] * went;
  const Lane across = max(node.block(1, 1) + finger * closing[1] * closing[1],
                          node.block(2, 2) + finger * closing[2] * closing[2]) +
                      mounting.compliance_across(c);
  const auto [change1, change2] = drag(c, {x[1], x[2]}, Lane(1.0) / (Lane(1.0) + shear_.get(c) * across), active);
  pad_force_[pad] += closing[1] * change1 + closing[2] * change2;
  node.change = shaped_->along_carrier(c, {{sign * normal, change1, change2}});
  for (std::size_t i = 0; i < 3; ++i) mounting.push(i, node.change[i]);
  mounting.end(c);
  note(c, active, abs(normal), max(abs(change1), abs(change2)), pass);
}

/// Takes in what an update has changed.
[[gnu::always_inline]] inline void ContactSweep::note(std::size_t c, const Mask& active, const Lane& change,
                                                      const Lane& change_across, Pass& pass) const {
  pass.largest_change = max(pass.largest_change, select(active, max(change, change_across), Lane(0.0)));
  pass.largest_force = max(pass.largest_force, select(active, contacts_.normal_theta.get(c), Lane(0.0)));
}

template <class Mounting, class AnyNode>
[[gnu::always_inline]] inline void ContactSweep::update_forces(std::size_t c, const GripperLanes& gripper,
                                                               const Mask& active, Pass& pass, AnyNode& node) {
  Mounting mounting(*this, gripper);
  mounting.begin(c);
  const Lane change = abs(update_normal(c, gripper, active, pass.slope, node, mounting));
  const Lane change_across = update_tangent(c, active, node, mounting);
  mounting.end(c);
  note(c, active, change, change_across, pass);
}

template <class Mounting>
[[gnu::always_inline]] inline void ContactSweep::update_candidate(std::size_t c, const GripperLanes& gripper,
                                                                  Pass& pass, Node& node) {
  const Mask active = pass.solving & contacts_.near.get(c);
  if (none(active)) return;
  const ContactCandidate& candidate = model_.candidate[c];
  const bool shaped = model_.is_shaped(c);
  if (eyes_.frame == nullptr && !shaped) {
    update_forces<Mounting>(c, gripper, active, pass, node);
    return;
  }
  const LaneVector d = eyes_.frame == nullptr ? LaneVector{node.d} : seen_displacement(candidate, {node.d});
  TurnedNode turned{own_.row(9 * c), d, {}};
  if (shaped) {
    update_shaped<Mounting>(c, gripper, active, pass, turned);
  } else {
    update_forces<Mounting>(c, gripper, active, pass, turned);
  }
  if (!turned.has_changed()) return;  // near, and open
  if (eyes_.frame == nullptr) {
    node.push(turned.change);
    return;
  }
  const LaneVector change = transposed(axes_of(candidate).turn) * turned.change;
  node.push(change);
  if (eyes_.places == nullptr) return;
  const LaneVector X = rest_place_m(static_cast<std::size_t>(candidate.contact_node));
  const LaneVector further = cross(levers_.add(X, arm_of(candidate), change), X);
  for (std::size_t i = 0; i < 3; ++i) node.d[i] += further[i];
}

/// Of a candidate along the axes of its surface's carrier, by that of its particle.
[[gnu::always_inline]] inline LaneVector ContactSweep::seen_displacement(const ContactCandidate& candidate,
                                                                         const LaneVector& u) const {
  if (candidate.place >= 0) return eyes_.places->displacement(candidate, u, levers_.turn());
  return axes_of(candidate).displacement(rest_place_m(static_cast<std::size_t>(candidate.contact_node)), u);
}

Lane ContactSweep::solve(const GripperLanes& gripper, const Mask& lanes) {
  const Lane most(kMaxSweeps);
  Lane sweeps(0.0);
  if (pads_ != nullptr) {
    sweeps = solve_with<PaddedSurfaces>(gripper, lanes, most);
  } else if (!may_deflate()) {
    sweeps = mounted_ != nullptr ? solve_with<MountedSurfaces>(gripper, lanes, most)
                                 : solve_with<FixedSurfaces>(gripper, lanes, most);
  } else if (const Mask on_mount = mounted_ != nullptr ? lanes & mounted_->lanes() : Mask(false); any(on_mount)) {
    sweeps = solve_with<MountedSurfaces>(gripper, on_mount, most);
    const Mask unsolved = unsolved_;
    sweeps += solve_upright(gripper, lanes & !on_mount);
    unsolved_ = unsolved_ | unsolved;
  } else {
    sweeps = solve_upright(gripper, lanes);
  }
  count_held(lanes);
  for (int pad = 0; pad < kJawFingers && shaped_ != nullptr; ++pad) {
    pad_place_[static_cast<std::size_t>(pad)] =
        surfaces_.place(pad, *theta_, gripper.way_at_theta(pad, pad_force_));
  }
  return sweeps;
}

std::size_t ContactSweep::end_of_group(std::size_t first) const {
  const int group = active_node_[first] / kGroup;
  std::size_t end = first + 1;
  while (end < active_node_.size() && active_node_[end] / kGroup == group) ++end;
  return end;
}

/// One pass over the forces serves all of them.
ContactSweep::Group ContactSweep::look_at_group(std::size_t first, std::size_t end, const BusyPacks& lanes) const {
  Group group;
  for (std::size_t g = 0; g < end - first; ++g) {
    const auto i = static_cast<std::size_t>(active_node_[first + g]);
    group.row[g] = model_.compliance.data() + 9 * i * model_.node_count();
    group.d[g] = {base_.get(3 * i), base_.get(3 * i + 1), base_.get(3 * i + 2)};
  }
  add_blocks({group.row.data(), end - first}, active_node_, node_force_, lanes, {group.d.data(), end - first});
  return group;
}

template <class Mounting>
void ContactSweep::update_node(std::size_t active, const GripperLanes& gripper, Pass& pass, Node& node) {
  const std::span<const int> near = near_of(active);
  for (const int c : near) update_candidate<Mounting>(static_cast<std::size_t>(c), gripper, pass, node);
  // Layers of several surfaces share what the node gives way: again, until they have come to terms.
  const Mask solving = std::exchange(pass.solving, pass.solving & shared_node_[active]);
  for (int again = 0; again < kAgain && any(pass.solving); ++again) {
    for (const int c : near) update_candidate<Mounting>(static_cast<std::size_t>(c), gripper, pass, node);
  }
  pass.solving = solving;
}

/// Updates the candidates of active nodes of one group.
template <class Mounting>
void ContactSweep::update_group(std::size_t first, std::size_t end, const GripperLanes& gripper, Pass& pass) {
  Mask here(false);
  for (std::size_t a = first; a < end; ++a) here = here | near_node_[a];
  here = here & pass.solving;
  if (none(here)) return;
  // All under the forces before the group's updates.
  const auto& [row, d] = look_at_group(first, end, BusyPacks(here));
  std::array<std::array<Lane, 3>, kGroup> change;
  for (std::size_t g = 0; g < end - first; ++g) {
    const auto i = static_cast<std::size_t>(active_node_[first + g]);
    const std::array<Lane, 3> before = {node_force_.get(3 * i), node_force_.get(3 * i + 1),
                                        node_force_.get(3 * i + 2)};
    Node node{node_force_, 3 * i, row[g] + 9 * i, d[g]};
    for (std::size_t h = 0; h < g; ++h) {
      const double* block = row[g] + 9 * static_cast<std::size_t>(active_node_[first + h]);
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) node.d[axis] += Lane(block[3 * axis + k]) * change[h][k];
      }
    }
    if (eyes_.places != nullptr) {
      const LaneVector by_arms = cross(levers_.turn_by_arms(), rest_place_m(i));
      for (std::size_t axis = 0; axis < 3; ++axis) node.d[axis] += by_arms[axis];
    }
    update_node<Mounting>(first + g, gripper, pass, node);
    for (std::size_t axis = 0; axis < 3; ++axis) change[g][axis] = node_force_.get(3 * i + axis) - before[axis];
  }
}

/// Where patches may answer as wholes.
Lane ContactSweep::solve_upright(const GripperLanes& gripper, const Mask& lanes) {
  const Mask plain = lanes & !(effort_.deflated_steps > Lane(0.0)), tries = plain & (effort_.span > Lane(0.0));
  Lane sweeps(0.0), found(0.0);
  Mask left = lanes & !plain, unsolved(false);
  // What a lane remembers of its steps: of those with nothing near none, since nobody asks where the whole batch
  // has nothing near.
  if (any(plain)) {
    Lane pressed(0.0);
    Mask stuck = is_stuck(plain, pressed) & (effort_.slow > Lane(0.0));
    if (is_first_solve_) {
      // Where contacts come and go every step would ask for a factor of its own.
      stuck = stuck & ((pressed == effort_.pressed) | (effort_.pressed == Lane(Effort::kUnknown)));
      effort_.pressed = select(plain & has_near_, pressed, effort_.pressed);
    }
    if (any(stuck)) found = answer_stuck(gripper, stuck);
    sweeps = solve_with<FixedSurfaces>(gripper, plain, select(tries, Lane(kHardSweeps), Lane(kMaxSweeps)));
    unsolved = unsolved_ & !swept_out_;
    left = left | swept_out_;
    if (is_first_solve_) {
      const Mask took = plain & has_near_;
      const Mask slow = (stuck & (sweeps + found < effort_.plain)) | ((!stuck) & (sweeps > Lane(kSlowSweeps)));
      effort_.slow = select(took, select(slow, Lane(1.0), Lane(0.0)), effort_.slow);
      effort_.plain = select(took & !stuck, sweeps, effort_.plain);
      effort_.take_in(plain & has_near_, swept_out_ | (sweeps > Lane(kHardSweeps)));
    }
  }
  is_first_solve_ = false;
  sweeps += found;
  if (none(left)) return sweeps;
  deflating_ = true;
  sweeps += solve_with<DeflatedSurfaces>(gripper, left, Lane(kMaxSweeps));
  deflating_ = false;
  unsolved_ = unsolved_ | unsolved;
  return sweeps;
}

/// @param lanes that swept without modes in this step @param hard of them
void ContactSweep::Effort::take_in(const Mask& lanes, const Mask& hard) {
  hard_steps = select(lanes, select(hard, hard_steps + Lane(1.0), Lane(0.0)), hard_steps);
  const Mask begins = lanes & (hard_steps >= Lane(kHardSteps));
  span = select(lanes, select(begins, max(Lane(2.0), min(Lane(kMostDeflatedSteps), Lane(4.0) * span)), Lane(0.0)),
                span);
  deflated_steps = select(begins, span, deflated_steps);
}

template <class Mounting>
Lane ContactSweep::solve_with(const GripperLanes& gripper, const Mask& lanes, const Lane& most) {
  Lane sweeps(0.0);
  unsolved_ = swept_out_ = Mask(false);
  // A lane with nothing near takes no sweep, whatever its neighbours do.
  Mask solving = lanes & has_near_;
  for (int sweep = 0; any(solving) && !active_node_.empty(); ++sweep) {
    if constexpr (std::is_same_v<Mounting, DeflatedSurfaces>) before_deflated(sweep, gripper, solving);
    Pass pass{solving, sweep >= kNewtonSweeps ? Slope::steepest : Slope::tangent};
    for (std::size_t first = 0; first < active_node_.size();) {
      const std::size_t end = end_of_group(first);
      update_group<Mounting>(first, end, gripper, pass);
      first = end;
    }
    if constexpr (std::is_same_v<Mounting, DeflatedSurfaces>) fold_modes();
    sweeps += select(solving, Lane(1.0), Lane(0.0));
    const Lane force = max(pass.largest_force, Lane(kLeastForce));
    unsolved_ = solving & (pass.largest_change > Lane(kUnsolved) * force);
    solving = solving & (pass.largest_change > Lane(kTolerance) * force);
    const Mask out = solving & (sweeps >= most);
    swept_out_ = swept_out_ | out;
    solving = solving & !out;
  }
  return sweeps;
}

}  // namespace unbruised
