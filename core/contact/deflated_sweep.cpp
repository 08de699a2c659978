#include <algorithm>
#include <array>

#include "core/contact/contact_sweep.hpp"
#include "core/contact/layer_law.hpp"
#include "core/contact/surface_tally.hpp"

namespace unbruised {

// What a solve in which patches answer as wholes does before and after each sweep.

namespace {

/// Then the modes have not served, and sweeps go on without them.
constexpr int kLastDeflated = 40;
/// Members change before the sweeps of these numbers only: what they do by the body is found anew then.
bool may_change_members(int sweep) { return sweep < kLastDeflated && (sweep & (sweep - 1)) == 0; }
/// And join no more after so many.
constexpr int kLastToJoin = 8;

/// The same for rates that differ by rounding only, so that nothing is factored anew for that.
Lane to_nine_bits(const Lane& x) {
  const Lane much = x * Lane(0x1p44);
  return (x + much) - much;
}

}  // namespace

/// Does the product stay upright between planes, in all lanes?
bool ContactSweep::may_deflate() const {
  return eyes_.frame == nullptr && shaped_ == nullptr && pads_ == nullptr &&
         std::ranges::all_of(model_.surface, [](int surface) { return surface < kFirstCellSurface; });
}

PadForces ContactSweep::whole_pad_force() const {
  PadForces force = pad_force_;
  for (std::size_t pad = 0; pad < kJawFingers; ++pad) force[pad] += modes_->pad_force(pad);
  return force;
}

void ContactSweep::make_room_for_layers() {
  if (give_.rows() == 0) give_ = LaneArray(PatchModes::kForces * model_.candidate.size());
}

void ContactSweep::begin_modes(const GripperLanes& gripper, const Mask& lanes) {
  if (!modes_) {
    modes_.emplace(model_);
    own_force_ = LaneArray(PatchModes::kForces * model_.candidate.size());
    unpressed_ = LaneArray(model_.candidate.size());
    make_room_for_layers();
  }
  modes_->list(active_node_, near_candidate_);
  for (const int near : near_candidate_) {
    const auto c = static_cast<std::size_t>(near);
    const std::size_t row = PatchModes::kForces * c;
    const ContactCandidate& candidate = model_.candidate[c];
    const Lane at = contacts_.penetration_theta.get(c), rate_slope = rate_slope_[candidate.surface];
    note_law(c, at, layer_law(candidate, at, rate_slope * at - viscous_.get(c), rate_slope, contacts_.cover(c)),
             lanes);
    own_force_.put(row, contacts_.normal_theta.get(c));
    for (std::size_t t = 0; t < 2; ++t) {
      own_force_.put(row + 1 + t, contacts_.tangent_theta[t].get(c));
      give_.put(row + 1 + t, Lane(1.0) / max(shear_.get(c), Lane(1e-300)));
    }
    set_member(c, lanes & is_pressed(c));
  }
  prepare_modes(gripper, lanes);
}

/// Notes the straight line that a layer follows where it stands, in `lanes`.
void ContactSweep::note_law(std::size_t c, const Lane& at_m, const LayerLaw& law, const Mask& lanes) {
  const std::size_t row = PatchModes::kForces * c;
  const Mask follows = law.slope > Lane(0.0);
  const Lane slope = select(follows, law.slope, Lane(1.0));
  const Lane give = select(follows, Lane(1.0) / (layer_.get(c) * slope), Lane(0.0));
  give_.put(row, select(lanes, give, give_.get(row)));
  unpressed_.put(c, select(lanes, at_m - law.force / slope, unpressed_.get(c)));
}

Mask ContactSweep::is_pressed(std::size_t c) const {
  return contacts_.near.get(c) & contacts_.is_closed(c) & (give_.get(PatchModes::kForces * c) > Lane(0.0));
}

void ContactSweep::set_member(std::size_t c, const Mask& member) {
  modes_->set_member(c, member, member & !contacts_.sliding.get(c));
}

/// Members that came off their layer leave, some that came onto it join, and tangents that slide do not count.
void ContactSweep::change_members(const Mask& solving, bool may_join, const GripperLanes& gripper) {
  const Mask free = may_join ? solving : Mask(false);
  const auto differ = [](const Mask& a, const Mask& b) { return (a & !b) | (b & !a); };
  Mask changed(false);
  for (const int near : near_candidate_) {
    const auto c = static_cast<std::size_t>(near);
    const Mask was = modes_->is_member(c, 0), stuck = modes_->is_member(c, 1);
    set_member(c, (was | free) & ((!solving) | is_pressed(c)));
    changed = changed | differ(modes_->is_member(c, 0), was) | differ(modes_->is_member(c, 1), stuck);
  }
  if (any(changed & solving)) prepare_modes(gripper, changed & solving);
}

/// By how much the pads go back per force on each of them.
PatchModes::Fingers ContactSweep::finger_give(const GripperLanes& gripper, const PadForces& now) {
  PatchModes::Fingers fingers;
  for (std::size_t q = 0; q < kJawFingers; ++q) {
    PadForces more = now;
    const Lane by = max(Lane(1e-4) * now[q], Lane(1e-4));
    more[q] += by;
    for (std::size_t p = 0; p < kJawFingers; ++p) {
      const auto pad = static_cast<int>(p);
      fingers[p][q] = to_nine_bits(max0(gripper.way_at_theta(pad, now) - gripper.way_at_theta(pad, more)) / by);
    }
  }
  return fingers;
}

void ContactSweep::prepare_modes(const GripperLanes& gripper, const Mask& lanes) {
  modes_->prepare(lanes, give_, finger_give(gripper, whole_pad_force()));
}

ContactSweep::SurfacePlaces ContactSweep::places_under(const PadForces& pad_force,
                                                       const GripperLanes& gripper) const {
  SurfacePlaces place;
  for (const int surface : model_.surface) {
    Lane way(0.0);
    if (is_pad(surface)) way = gripper.way_at_theta(static_cast<int>(finger_of(surface)), pad_force);
    place[static_cast<std::size_t>(surface)] = surfaces_.place(surface, *theta_, way);
  }
  return place;
}

/// Takes out of the modes what the layers still lack in them.
void ContactSweep::step_modes(const GripperLanes& gripper, const Mask& lanes) {
  modes_->start_residual(node_force_);
  const SurfacePlaces place = places_under(pad_force_, gripper);
  for (const int near : near_candidate_) {
    const auto c = static_cast<std::size_t>(near);
    const ContactCandidate& candidate = model_.candidate[c];
    const int surface = candidate.surface;
    const std::size_t row = PatchModes::kForces * c, node = 3 * static_cast<std::size_t>(candidate.contact_node);
    const auto axis = static_cast<std::size_t>(normal_axis(surface));
    const auto tangents = tangent_axes(surface);
    const Lane depth = Lane(normal_sign(surface)) * (place[static_cast<std::size_t>(surface)] -
                                                     Lane(candidate.surface_m) - base_.get(node + axis));
    modes_->add_residual(c, 0, depth - unpressed_.get(c) - give_.get(row) * own_force_.get(row));
    for (std::size_t t = 0; t < 2; ++t) {
      const auto along = static_cast<std::size_t>(tangents[t]);
      const Lane sheared =
          carrier_of(surface, *theta_)[along].place_m + contacts_.anchor[t].get(c) - base_.get(node + along);
      modes_->add_residual(c, 1 + t, sheared - give_.get(row + 1 + t) * own_force_.get(row + 1 + t));
    }
  }
  modes_->take_residual(lanes);
  fold_modes();
}

/// Makes what the modes add the contacts' own.
void ContactSweep::fold_modes() {
  for (const int near : near_candidate_) {
    const auto c = static_cast<std::size_t>(near);
    const ContactCandidate& candidate = model_.candidate[c];
    std::array<Lane, 3> by;
    for (std::size_t of = 0; of < PatchModes::kForces; ++of) {
      const std::size_t row = PatchModes::kForces * c + of;
      by[of] = modes_->force(c, of);
      const Lane force = own_force_.get(row) + by[of];
      own_force_.put(row, force);
      (of == 0 ? contacts_.normal_theta : contacts_.tangent_theta[of - 1]).put(c, force);
    }
    const std::array<Lane, 3> push = along_axes(candidate.surface, by[0], by[1], by[2]);
    const auto node = 3 * static_cast<std::size_t>(candidate.contact_node);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node_force_.put(node + axis, node_force_.get(node + axis) + push[axis]);
    }
  }
  pad_force_ = whole_pad_force();
  modes_->clear();
}

void ContactSweep::before_deflated(int sweep, const GripperLanes& gripper, const Mask& solving) {
  if (sweep == 0) {
    begin_modes(gripper, solving);
  } else if (sweep == kLastDeflated) {
    for (const int c : near_candidate_) set_member(static_cast<std::size_t>(c), Mask(false));
    prepare_modes(gripper, solving);
  } else if (may_change_members(sweep)) {
    change_members(solving, sweep <= kLastToJoin, gripper);
  }
  step_modes(gripper, solving);
}

}  // namespace unbruised
