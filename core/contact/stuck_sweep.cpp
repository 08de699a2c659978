#include <array>

#include "core/contact/contact_sweep.hpp"
#include "core/contact/layer_law.hpp"
#include "core/contact/surface_tally.hpp"

namespace unbruised {

// Where all that is pressed sticks on straight layers, its forces are found at once before the sweeps.

namespace {

/// With fewer contacts sweeps cost next to nothing.
constexpr double kFewContacts = 8.0;

}  // namespace

/// Lanes of `lanes` in which every contact that is pressed sticks and every layer is straight.
/// @param pressed how many are
Mask ContactSweep::is_stuck(const Mask& lanes, Lane& pressed) const {
  Mask stuck = lanes & has_near_;
  pressed = Lane(0.0);
  for (const int near : near_candidate_) {
    const auto c = static_cast<std::size_t>(near);
    const ContactCandidate& candidate = model_.candidate[c];
    const Mask here = contacts_.near.get(c);
    const Mask closed = here & contacts_.is_closed(c);
    stuck = stuck & !((closed & contacts_.sliding.get(c)) | (here & surfaces_[candidate.surface].curve.lanes()));
    if (!candidate.flat) stuck = stuck & !here;
    pressed += select(closed, Lane(1.0), Lane(0.0));
  }
  return stuck & (pressed >= Lane(kFewContacts));
}

/// Finds the forces of lanes in which all sticks. @return what that took, in sweeps
Lane ContactSweep::answer_stuck(const GripperLanes& gripper, const Mask& lanes) {
  if (!stuck_) {
    stuck_.emplace(model_);
    lacks_ = LaneArray(StuckPatches::kForces * model_.candidate.size());
    make_room_for_layers();
  }
  const Mask straight = find_lacks(gripper, lanes);
  const Lane looks = select(lanes, Lane(1.0), Lane(0.0));
  if (none(straight)) return looks;
  Lane largest(kLeastForce);
  for (const int near : near_candidate_) {
    largest = max(largest, contacts_.normal_theta.get(static_cast<std::size_t>(near)));
  }
  const Lane solves =
      stuck_->solve(near_candidate_, give_, finger_give(gripper, pad_force_), straight, largest, lacks_);
  const Mask answered = solves > Lane(0.0);
  for (const int near : near_candidate_) change_stuck(static_cast<std::size_t>(near), answered);
  return looks + solves;
}

/// Looks at all layers under the present forces. @return lanes of `lanes` whose layers are in their straight part
Mask ContactSweep::find_lacks(const GripperLanes& gripper, const Mask& lanes) {
  const BusyPacks busy(lanes);
  const SurfacePlaces place = places_under(pad_force_, gripper);
  Mask straight = lanes;
  for (std::size_t first = 0; first < active_node_.size();) {
    const std::size_t end = end_of_group(first);
    const Group group = look_at_group(first, end, busy);
    for (std::size_t a = first; a < end; ++a) {
      for (const int c : near_of(a)) {
        straight = straight & find_lack(static_cast<std::size_t>(c), place, group.d[a - first]);
      }
    }
    first = end;
  }
  return straight;
}

/// @param d displacement of its node @return lanes in which the layer is straight about where it stands, or open
Mask ContactSweep::find_lack(std::size_t c, const SurfacePlaces& place, const std::array<Lane, 3>& d) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const std::size_t row = StuckPatches::kForces * c;
  const Mask closed = contacts_.near.get(c) & contacts_.is_closed(c);
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const Lane depth = Lane(normal_sign(surface)) *
                     (place[static_cast<std::size_t>(surface)] - Lane(candidate.surface_m) - d[axis]);
  const Lane& rate_slope = rate_slope_[surface];
  const LayerLaw law =
      layer_law(candidate, depth, rate_slope * depth - viscous_.get(c), rate_slope, contacts_.cover(c));
  const Mask straight = law.slope == Lane(1.0) + rate_slope;
  const Lane slope = select(straight, law.slope, Lane(1.0)), layer = layer_.get(c);
  give_.put(row, select(closed, Lane(1.0) / (layer * slope), Lane(0.0)));
  lacks_.put(row, law.force / slope - give_.get(row) * contacts_.normal_theta.get(c));
  const Lane shear = Lane(1.0) / max(shear_.get(c), Lane(1e-300));
  for (std::size_t t = 0; t < 2; ++t) {
    const auto along = static_cast<std::size_t>(tangent_axes(surface)[t]);
    give_.put(row + 1 + t, select(closed, shear, Lane(0.0)));
    const Lane sheared = carrier_of(surface, *theta_)[along].place_m + contacts_.anchor[t].get(c) - d[along];
    lacks_.put(row + 1 + t, sheared - shear * contacts_.tangent_theta[t].get(c));
  }
  return straight | !closed;
}

/// Takes a candidate's change over, as far as its layer only pushes and its friction holds.
void ContactSweep::change_stuck(std::size_t c, const Mask& lanes) {
  const ContactCandidate& candidate = model_.candidate[c];
  const std::size_t row = StuckPatches::kForces * c;
  const Mask here = lanes & (give_.get(row) > Lane(0.0));
  if (none(here)) return;
  const std::array<Lane, 3> old = {contacts_.normal_theta.get(c), contacts_.tangent_theta[0].get(c),
                                   contacts_.tangent_theta[1].get(c)};
  std::array<Lane, 3> force;
  for (std::size_t of = 0; of < 3; ++of) force[of] = old[of] + lacks_.get(row + of);
  force[0] = max0(force[0]);
  const Lane cone = surfaces_[candidate.surface].friction * force[0];
  const Lane size2 = force[1] * force[1] + force[2] * force[2];
  const Lane scale = select(size2 > cone * cone, cone / sqrt(max(size2, Lane(1e-300))), Lane(1.0));
  for (std::size_t of = 1; of < 3; ++of) force[of] = force[of] * scale;
  for (std::size_t of = 0; of < 3; ++of) force[of] = select(here, force[of], old[of]);
  contacts_.normal_theta.put(c, force[0]);
  for (std::size_t t = 0; t < 2; ++t) contacts_.tangent_theta[t].put(c, force[1 + t]);
  const std::array<Lane, 3> push =
      along_axes(candidate.surface, force[0] - old[0], force[1] - old[1], force[2] - old[2]);
  const auto node = 3 * static_cast<std::size_t>(candidate.contact_node);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node_force_.put(node + axis, node_force_.get(node + axis) + push[axis]);
  }
  if (is_pad(candidate.surface)) pad_force_[finger_of(candidate.surface)] += force[0] - old[0];
}

}  // namespace unbruised
