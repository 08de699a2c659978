#include "core/contact/contact_lanes.hpp"

namespace unbruised {

// How a step looks from each carrier of surfaces: as it is given where the product is upright.

namespace {

/// What is not the palm moves as it does for everybody.
void rest_palm(const CarrierMotion& given, CarrierMotion& resting) {
  resting.cell = given.cell;
  resting.listed = given.listed;
}

}  // namespace

void ContactLanes::load_seen(int lane) {
  const auto& center_m = surfaces_[kLeftPad].center_m;
  std::array<double, 3> grip_m{};
  for (std::size_t t = 0; t < 2; ++t) {
    grip_m[static_cast<std::size_t>(tangent_axes(kLeftPad)[t])] = center_m[t][lane];
  }
  seen_->load(lane, grip_m);
}

void ContactLanes::set_anchors(int lane, const LaneArray& u, const CarrierMotion& now, const FrameLanes* frame) {
  if (seen_ && frame != nullptr) seen_->see_from_cell(*frame, u, now);
  // The palm has not moved yet: it sees what the cell sees.
  register_.set_anchors(lane, seen_ ? seen_->from(kCell).u : u);
  if (!places_ || frame == nullptr) return;
  places_->see(*frame, now);
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    const ContactCandidate& candidate = model_.candidate[c];
    if (candidate.place < 0 || !(register_.normal.at(c, lane) > 0.0)) continue;  // open ones follow as they meet
    const LaneVector there =
        places_->displacement(candidate, get_vector(u, static_cast<std::size_t>(candidate.node)));
    for (std::size_t t = 0; t < 2; ++t) {
      const auto along = static_cast<std::size_t>(tangent_axes(candidate.surface)[t]);
      register_.anchor[t].at(c, lane) = there[along][lane];
    }
  }
}

ContactLanes::Starts ContactLanes::seen_start(const ContactStart& start) {
  if (!seen_ || start.frame == nullptr) return {start, start};
  seen_->see_start(*start.frame, {start.u, start.v, start.a}, start.free.displacement, start.now, start.theta);
  if (places_) places_->see_start(*start.frame, start.now, start.theta);
  for (std::size_t i = 0; i < 2; ++i) rest_palm(i == 0 ? start.now : start.theta, resting_[i]);
  const auto from = [&](std::size_t carrier) -> ContactStart {
    const SeenMotion& seen = seen_->from(carrier);
    return {seen.u,      seen.v,      seen.a,        {seen.base, start.free.moment_N_m},
            resting_[0], resting_[1], start.gripper, start.frame,
            start.mount, start.pads};
  };
  return {from(kPalm), from(kCell)};
}

ContactLanes::Ends ContactLanes::seen_end(const ContactEnd& end, const FrameLanes* frame) {
  if (!seen_ || frame == nullptr) return {end, end};
  seen_->see_end(*frame, end.u, end.next);
  for (std::size_t i = 0; i < 2; ++i) rest_palm(i == 0 ? end.theta : end.next, resting_[i]);
  const auto from = [&](std::size_t carrier) -> ContactEnd {
    return {seen_->from(carrier).u_theta, seen_->from(carrier).u, resting_[0], resting_[1], end.mount, end.pads};
  };
  return {from(kPalm), from(kCell)};
}

}  // namespace unbruised
