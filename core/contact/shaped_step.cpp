#include "core/contact/contact_lanes.hpp"

namespace unbruised {

// How contacts with shaped pads go through a step: in axes of their own (docs/theory.md, "Shaped pads").

namespace {

/// Position, or a rate of it, of a particle's place less that of the pad, along the axes of the pad's carrier.
LaneVector less(const std::array<Lane, 3>& particle, const std::array<Lane, 3>& pad) {
  LaneVector way;
  for (std::size_t i = 0; i < 3; ++i) way[i] = particle[i] - pad[i];
  return way;
}

std::array<Lane, 3> rows_of(const LaneArray& rows, std::size_t first) {
  return {rows.get(first), rows.get(first + 1), rows.get(first + 2)};
}

}  // namespace

void ContactLanes::meet_shaped(std::size_t c, const ContactStart& start, const Mask& running) {
  const ContactCandidate& candidate = model_.candidate[c];
  const int surface = candidate.surface;
  const AxisMotion& pad = motion_[surface];
  const auto node = 3 * static_cast<std::size_t>(candidate.node);
  const auto& now = carrier_of(surface, start.now);
  const auto& theta = carrier_of(surface, start.theta);
  LaneVector here = less(rows_of(start.u, node), {pad.place_m, now[1].place_m, now[2].place_m});
  LaneVector free = less(rows_of(start.free.displacement, 3 * static_cast<std::size_t>(candidate.contact_node)),
                         {place_free_[surface], theta[1].place_m, theta[2].place_m});
  LaneVector rate = less(rows_of(start.v, node), {pad.velocity_m_s, now[1].velocity_m_s, now[2].velocity_m_s});
  LaneVector second =
      less(rows_of(start.a, node), {pad.acceleration_m_s2, now[1].acceleration_m_s2, now[2].acceleration_m_s2});
  here[0] += Lane(candidate.surface_m);
  free[0] += Lane(candidate.surface_m);
  if (start.mount != nullptr && mounted_.carries(surface)) {
    LaneVector at = here;
    at[0] += pad.place_m - now[0].place_m;
    for (std::size_t i = 1; i < 3; ++i)
      at[i] += Lane(body_.position_m[static_cast<std::size_t>(candidate.node)][i]);
    mounted_.place(c, at);
    here = here - mounted_.motion(c, start.mount->displacement());
    free = free - mounted_.motion(c, start.mount->free());
    rate = rate - mounted_.motion(c, start.mount->velocity());
    second = second - mounted_.motion(c, start.mount->acceleration());
  }
  const Mask closed = register_.is_closed(c);
  const Mask may = running & ((!closed) | register_.sliding.get(c));
  look_again(c, here, may);
  const Lane sign(normal_sign(surface));
  const LaneVector x = shaped_->seen(c, here);
  const Meeting meeting{shaped_->gap_m(c, x), shaped_->gap_m(c, shaped_->seen(c, free)),
                        -sign * shaped_->seen(c, rate)[0], -sign * shaped_->seen(c, second)[0]};
  const Mask open = running & !closed;
  for (std::size_t t = 0; t < 2; ++t) {
    register_.anchor[t].put(c, select(open, x[1 + t], register_.anchor[t].get(c)));
    shaped_place_[t].put(c, here[1 + t]);
  }
  const Mask meets = may_meet(c, meeting, running);
  const Mask moves = meets & may;
  if (any(moves)) cover_again(c, start, moves);
  take_in(c, meeting, meets, running);
}

/// Takes in the face under a candidate, and turns what it remembers into its new axes: the layer is as deep and
/// its spring as long as before, and its force on the product is the same.
void ContactLanes::look_again(std::size_t c, const LaneVector& here, const Mask& may) {
  const int surface = model_.candidate[c].surface;
  const Mask carrying = (register_.normal.get(c) > Lane(0.0)) | register_.is_closed(c);
  if (none(carrying & may)) {
    shaped_->look(c, {here[1], here[2]}, may);
    return;
  }
  const LaneVector before = shaped_->seen(c, here);
  const Lane gap_before = shaped_->gap_m(c, before);
  const LaneVector force = shaped_->along_carrier(
      c, {along_axes(surface, register_.normal.get(c), register_.tangent[0].get(c), register_.tangent[1].get(c))});
  const LayerEnergy stored = register_.stored_energy(c, surfaces_[surface]);
  const Mask turned = shaped_->look(c, {here[1], here[2]}, may) & carrying;
  if (none(turned)) return;
  const LaneVector after = shaped_->seen(c, here), turned_force = shaped_->seen(c, force);
  const auto put = [&](LaneArray& rows, const Lane& value) { rows.put(c, select(turned, value, rows.get(c))); };
  put(register_.penetration, register_.penetration.get(c) + gap_before - shaped_->gap_m(c, after));
  put(register_.normal, Lane(normal_sign(surface)) * turned_force[0]);
  for (std::size_t t = 0; t < 2; ++t) {
    put(register_.tangent[t], turned_force[1 + t]);
    put(register_.anchor[t], register_.anchor[t].get(c) + after[1 + t] - before[1 + t]);
  }
  const LayerEnergy left = register_.stored_energy(c, surfaces_[surface]);
  const Lane lost = select(turned, stored.pressed + stored.sheared - left.pressed - left.sheared, Lane(0.0));
  dissipated_ += lost;
  losses_.left += lost;
}

/// Where a candidate is at t + theta dt, as it sees it.
LaneVector ContactLanes::shaped_place_theta(std::size_t c, const ContactEnd& end) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const auto& carrier = carrier_of(candidate.surface, end.theta);
  LaneVector there = less(rows_of(end.u_theta, 3 * static_cast<std::size_t>(candidate.node)),
                          {sweep_.pad_place_m(candidate.surface), carrier[1].place_m, carrier[2].place_m});
  there[0] += Lane(candidate.surface_m);
  if (end.mount != nullptr) there = there - mounted_.motion(c, mounted_.twist());
  return shaped_->seen(c, there);
}

/// What a contact's normal and tangents are along the axes of its surface's carrier, as a normal and tangents.
std::array<Lane, 3> ContactLanes::of_carrier(std::size_t c, const std::array<Lane, 3>& force) const {
  if (!model_.is_shaped(c)) return force;
  const int surface = model_.candidate[c].surface;
  const LaneVector v = shaped_->along_carrier(c, {along_axes(surface, force[0], force[1], force[2])});
  const auto tangents = tangent_axes(surface);
  return {Lane(normal_sign(surface)) * v[static_cast<std::size_t>(normal_axis(surface))],
          v[static_cast<std::size_t>(tangents[0])], v[static_cast<std::size_t>(tangents[1])]};
}

std::array<double, 3> ContactLanes::of_carrier(std::size_t c, int lane,
                                               const std::array<double, 3>& force_N) const {
  const std::array<Lane, 3> lanes = of_carrier(c, {Lane(force_N[0]), Lane(force_N[1]), Lane(force_N[2])});
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

}  // namespace unbruised
