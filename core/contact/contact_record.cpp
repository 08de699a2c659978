#include <limits>

#include "core/contact/contact_lanes.hpp"
#include "core/lanes/lane_rotation.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {

// What contacts tell those who record a lane.

void ContactLanes::note_events(int lane) {
  events_.start(lane);
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    if (!(register_.normal_theta.at(c, lane) > 0.0)) continue;
    ContactStep rest;
    rest.depth_m = register_.penetration.at(c, lane) - model_.candidate[c].least_relief_m;
    rest.theta_N = {register_.normal.at(c, lane), register_.tangent[0].at(c, lane),
                    register_.tangent[1].at(c, lane)};
    for (std::size_t t = 0; t < 2; ++t) rest.place_m[t] = register_.anchor[t].at(c, lane);
    events_.note_rest(static_cast<int>(c), lane, rest);
  }
}

void ContactLanes::note_changes(std::size_t c, const CandidateStep& step) {
  for (int lane = 0; lane < kLanes; ++lane) {
    if (!events_.lanes()[lane]) continue;
    if (!step.closed[lane] && !register_.was_closed.at(c, lane)) continue;
    events_.note(static_cast<int>(c), lane, contact_step(c, lane, step));
  }
}

ContactStep ContactLanes::contact_step(std::size_t c, int lane, const CandidateStep& step) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  ContactStep seen;
  seen.was_closed = register_.was_closed.at(c, lane);
  seen.is_closed = step.closed[lane];
  seen.was_sliding = register_.was_sliding.at(c, lane);
  seen.is_sliding = step.sliding[lane];
  seen.gap_now_m = register_.gap_now.at(c, lane);
  seen.gap_free_m = register_.gap_free.at(c, lane);
  // The layer pushes with its depth and, where that is less, with what its viscosity leaves of it. A candidate
  // that is not near has lost its surface.
  const double depth_m = register_.penetration_theta.at(c, lane) - register_.least_relief(c)[lane];
  seen.depth_m = register_.near.at(c, lane) ? depth_m + std::min(0.0, sweep_.viscous_depth(c)[lane])
                                            : -std::numeric_limits<double>::infinity();
  seen.friction = surface.friction[lane];
  seen.shear_N_m = register_.layer_stiffness(c, surface)[lane] / 3.0;
  seen.theta_N = {register_.normal_theta.at(c, lane), register_.tangent_theta[0].at(c, lane),
                  register_.tangent_theta[1].at(c, lane)};
  for (std::size_t i = 0; i < 3; ++i) seen.before_N[i] = step.before[i][lane];
  for (std::size_t t = 0; t < 2; ++t) {
    // Where it slides the anchor has followed: at t + theta dt it stands off the particle by the layer's stretch.
    const double moved_m = step.moved[t][lane];
    seen.anchor_m[t] = register_.anchor[t].at(c, lane) - moved_m;
    seen.place_m[t] = seen.anchor_m[t] + w_.theta * moved_m;
    if (seen.shear_N_m > 0.0) seen.place_m[t] -= seen.theta_N[1 + t] / seen.shear_N_m;
  }
  return seen;
}

ContactLanes::ContactPoint ContactLanes::contact_point(std::size_t c, int lane, const BodyMotion& body) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const auto p = static_cast<std::size_t>(candidate.node);
  LaneVector moved = get_vector(body.u(), p), velocity = get_vector(body.v(), p);
  if (const FrameLanes* frame = body.frame()) {
    moved = frame->displacement_m(p, get_vector(body.u(), p));
    velocity = frame->to_world(velocity);
    if (candidate.place >= 0) {
      const LaneVector arm = to_lanes(model_.place[static_cast<std::size_t>(candidate.place)].arm_m);
      moved += frame->to_world(arm);
      velocity += frame->to_world(frame->velocity_of(arm));
    }
  }
  ContactPoint point{body_.position_m[p], of_lane(velocity, lane)};
  for (std::size_t i = 0; i < 3; ++i) point.place_m[i] += moved[i][lane];
  return point;
}

/// What is given along the axes of a surface's carrier, along x, y, z.
std::array<double, 3> ContactLanes::in_cell(int surface, int lane, const std::array<double, 3>& along,
                                            const CarrierMotion& now) const {
  LaneVector vector = to_lanes(along);
  if (has_own_axes(surface)) vector = transposed(surfaces_[surface].axes) * vector;
  if (is_pad(surface)) vector = rotation_by(now.palm_rotation_rad).matrix() * vector;
  return of_lane(vector, lane);
}

void ContactLanes::append_events(int lane, const EventStep& step, std::vector<ContactEvent>& events) const {
  for (const ContactChange& change : events_.changes(lane)) {
    const auto c = static_cast<std::size_t>(change.candidate);
    const ContactCandidate& candidate = model_.candidate[c];
    const int surface = candidate.surface;
    ContactPoint point = contact_point(c, lane, step.body);
    if (candidate.place < 0) {
      // The true surface lies off the particle.
      std::array<double, 3> off{};
      const auto axis = static_cast<std::size_t>(normal_axis(surface));
      off[axis] = candidate.surface_m - body_.position_m[static_cast<std::size_t>(candidate.node)][axis];
      off = in_cell(surface, lane, off, step.now);
      for (std::size_t i = 0; i < 3; ++i) point.place_m[i] += off[i];
    }
    const double time_s = step.start_s + change.after_s;
    for (std::size_t i = 0; i < 3; ++i) point.place_m[i] += (time_s - step.end_s) * point.velocity_m_s[i];
    const std::array<double, 3> by_axes = of_carrier(c, lane, change.force_N);
    std::array<double, 3> force_N{};
    force_N[static_cast<std::size_t>(normal_axis(surface))] = normal_sign(surface) * by_axes[0];
    for (std::size_t t = 0; t < 2; ++t) {
      force_N[static_cast<std::size_t>(tangent_axes(surface)[t])] = by_axes[1 + t];
    }
    events.push_back({time_s, candidate.node, model_.number_of(surface), change.kind, change.candidate,
                      point.place_m, in_cell(surface, lane, force_N, step.now)});
  }
}

std::array<std::array<double, 3>, kSurfaceCount> ContactLanes::surface_torques(int lane, const BodyMotion& body,
                                                                               const CarrierMotion& now) const {
  std::array<double, 3> center_m = body_.center_of_mass_m;
  for (std::size_t i = 0; i < 3; ++i) center_m[i] += body.mass_u()[i][lane] / body_.total_mass_kg;
  std::array<std::array<double, 3>, kSurfaceCount> torque{};
  for (std::size_t c = 0; c < model_.candidate.size(); ++c) {
    if (!(register_.normal.at(c, lane) > 0.0)) continue;
    const int surface = model_.candidate[c].surface;
    const std::array<Lane, 3> by_axes =
        of_carrier(c, {register_.normal.get(c), register_.tangent[0].get(c), register_.tangent[1].get(c)});
    const LaneVector lanes{along_axes(surface, by_axes[0], by_axes[1], by_axes[2])};
    const std::array<double, 3> force_N = in_cell(surface, lane, of_lane(lanes, lane), now);
    std::array<double, 3> arm_m = contact_point(c, lane, body).place_m;
    for (std::size_t i = 0; i < 3; ++i) arm_m[i] -= center_m[i];
    const std::array<double, 3> moment_N_m = cross(arm_m, force_N);
    for (std::size_t i = 0; i < 3; ++i) torque[static_cast<std::size_t>(surface)][i] += moment_N_m[i];
  }
  return torque;
}

}  // namespace unbruised
