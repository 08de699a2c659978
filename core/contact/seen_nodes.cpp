#include "core/contact/seen_nodes.hpp"

#include <algorithm>

#include "core/door/require.hpp"
#include "core/lanes/lane_rotation.hpp"

namespace unbruised {
namespace {

LaneVector palm_place(const CarrierMotion& there) {
  return {{there.palm[0].place_m, there.palm[1].place_m, there.palm[2].place_m}};
}

}  // namespace

SeenNodes::SeenNodes(const ContactModel& model, const BodyModel& body)
    : model_(model), center_of_mass_m_(body.center_of_mass_m) {
  for (SeenMotion& seen : seen_) {
    for (LaneArray* rows : {&seen.u, &seen.v, &seen.a, &seen.u_theta}) *rows = LaneArray(3 * body.particle_count);
    seen.base = LaneArray(3 * model.node_count());
  }
  for (std::size_t i = 0; i < model.node_count(); ++i) {
    const auto first = model.candidate.begin() + model.first_candidate[i];
    const auto last = model.candidate.begin() + model.first_candidate[i + 1];
    for (std::size_t carrier = 0; carrier < kCarrierCount; ++carrier) {
      const auto meets = [carrier](const ContactCandidate& c) {
        return c.place < 0 && carrier_number(c.surface) == carrier;
      };
      if (std::any_of(first, last, meets)) side_node_[carrier].push_back(i);
    }
  }
}

void SeenNodes::load(int lane, const std::array<double, 3>& grip_m) {
  require(is_lane(lane), "SeenNodes::load: there is no such lane");
  for (std::size_t i = 0; i < 3; ++i) lever_[i].set(lane, center_of_mass_m_[i] - grip_m[i]);
}

/// The palm sees P' (c + R y - p) from its pads' centre.
std::array<CarrierAxes, kCarrierCount> SeenNodes::axes_of(const FrameLanes& frame,
                                                          const CarrierMotion& there) const {
  const LaneMatrix back = transposed(rotation_by(there.palm_rotation_rad).matrix());
  const LaneVector center = frame.center_motion_m();
  const LaneVector from_palm = center + lever_ - palm_place(there);
  return {{{back * frame.axes(), back * from_palm - lever_}, {frame.axes(), center}}};
}

void SeenNodes::see_start(const FrameLanes& frame, const StateRows& state, const LaneArray& base,
                          const CarrierMotion& now, const CarrierMotion& theta) {
  axes_theta_ = axes_of(frame, theta);
  see_rates(frame, state, now, axes_of(frame, now));
  see_base(frame, base);
}

/// In the palm's axes, r from its centre: w = v - V - Omega x r and a - A - Omega' x r - Omega x (Omega x r) - 2
/// Omega x w.
void SeenNodes::see_rates(const FrameLanes& frame, const StateRows& state, const CarrierMotion& now,
                          const std::array<CarrierAxes, kCarrierCount>& axes) {
  const LaneMatrix back = transposed(rotation_by(now.palm_rotation_rad).matrix());
  LaneVector V, A;
  for (std::size_t i = 0; i < 3; ++i) {
    V[i] = now.palm[i].velocity_m_s;
    A[i] = now.palm[i].acceleration_m_s2;
  }
  V = back * V;
  A = back * A;
  const LaneVector Omega = back * now.palm_spin_rad_s, Omega_rate = back * now.palm_spin_acceleration_rad_s2;
  SeenMotion &palm = seen_[kPalm], &cell = seen_[kCell];
  for (const std::size_t i : side_node_[kCell]) {
    const auto p = static_cast<std::size_t>(model_.node[i]);
    const LaneVector X = to_lanes(frame.rest_place_m(p));
    put_vector(cell.u, p, axes[kCell].displacement(X, get_vector(state.u, p)));
    put_vector(cell.v, p, axes[kCell].turn * get_vector(state.v, p));
    put_vector(cell.a, p, axes[kCell].turn * get_vector(state.a, p));
  }
  for (const std::size_t i : side_node_[kPalm]) {
    const auto p = static_cast<std::size_t>(model_.node[i]);
    const LaneVector X = to_lanes(frame.rest_place_m(p)), u = get_vector(state.u, p), v = get_vector(state.v, p),
                     a = get_vector(state.a, p);
    const LaneVector moved = axes[kPalm].displacement(X, u);
    const LaneVector r = moved + X + lever_;
    const LaneVector w = axes[kPalm].turn * v - V - cross(Omega, r);
    put_vector(palm.u, p, moved);
    put_vector(palm.v, p, w);
    put_vector(palm.a, p,
               axes[kPalm].turn * a - A - cross(Omega_rate, r) - cross(Omega, cross(Omega, r) + Lane(2.0) * w));
  }
}

void SeenNodes::see_base(const FrameLanes& frame, const LaneArray& base) {
  for (std::size_t c = 0; c < kCarrierCount; ++c) {
    for (const std::size_t i : side_node_[c]) {
      put_vector(seen_[c].base, i, axes_theta_[c].displacement(rest_place_m(frame, i), get_vector(base, i)));
    }
  }
}

void SeenNodes::see_theta(const FrameLanes& frame, const LaneArray& u_theta) {
  for (std::size_t c = 0; c < kCarrierCount; ++c) {
    for (const std::size_t i : side_node_[c]) {
      const auto p = static_cast<std::size_t>(model_.node[i]);
      put_vector(seen_[c].u_theta, p, axes_theta_[c].displacement(rest_place_m(frame, i), get_vector(u_theta, p)));
    }
  }
}

void SeenNodes::see_from_cell(const FrameLanes& frame, const LaneArray& u, const CarrierMotion& there) {
  const CarrierAxes cell = axes_of(frame, there)[kCell];
  for (std::size_t i = 0; i < model_.node_count(); ++i) {
    const auto p = static_cast<std::size_t>(model_.node[i]);
    put_vector(seen_[kCell].u, p, cell.displacement(rest_place_m(frame, i), get_vector(u, p)));
  }
}

void SeenNodes::see_end(const FrameLanes& frame, const LaneArray& u, const CarrierMotion& there) {
  const auto axes = axes_of(frame, there);
  for (std::size_t c = 0; c < kCarrierCount; ++c) {
    for (const std::size_t i : side_node_[c]) {
      const auto p = static_cast<std::size_t>(model_.node[i]);
      put_vector(seen_[c].u, p, axes[c].displacement(rest_place_m(frame, i), get_vector(u, p)));
    }
  }
}

}  // namespace unbruised
