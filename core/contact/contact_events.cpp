#include "core/contact/contact_events.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/door/require.hpp"

namespace unbruised {
namespace {

using Kind = ContactEvent::Kind;
using Plane = std::array<double, 2>;

Plane operator-(const Plane& a, const Plane& b) { return {a[0] - b[0], a[1] - b[1]}; }
double dot(const Plane& a, const Plane& b) { return a[0] * b[0] + a[1] * b[1]; }

/// The least positive f with |a + f b| = c + f d, from within that cone.
double leaving_cone(const Plane& a, const Plane& b, double c, double d) {
  const double square = dot(b, b) - d * d, half = dot(a, b) - c * d, inside = c * c - dot(a, a);
  const double below = half + std::sqrt(std::max(0.0, half * half + square * inside));
  return below > 0.0 ? std::max(0.0, inside / below) : 1.0;
}

}  // namespace

ContactEvents::ContactEvents(std::size_t candidate_count, const WilsonTheta& wilson)
    : candidate_count_(candidate_count), w_(wilson) {}

void ContactEvents::start(int lane) {
  require(is_lane(lane), "ContactEvents::start: there is no such lane");
  lanes_.set(lane, true);
  memory_[static_cast<std::size_t>(lane)].assign(candidate_count_, Memory{});
  change_[static_cast<std::size_t>(lane)].clear();
}

void ContactEvents::archive(LaneArchive& lane) {
  lane(lanes_);
  const auto at = static_cast<std::size_t>(lane.lane());
  if (!lanes_[lane.lane()]) return;
  lane.object(memory_[at]);
  lane.object(change_[at]);
  if (!lane.arrives()) stop(lane.lane());
}

void ContactEvents::note_rest(int candidate, int lane, const ContactStep& rest) {
  const auto at = static_cast<std::size_t>(lane);
  memory_[at][static_cast<std::size_t>(candidate)] = {rest.depth_m, rest.place_m, {}};
  change_[at].push_back({candidate, Kind::make, 0.0, rest.theta_N});
}

void ContactEvents::note(int candidate, int lane, const ContactStep& step) {
  const auto at = static_cast<std::size_t>(lane);
  Memory& last = memory_[at][static_cast<std::size_t>(candidate)];
  const bool slid = step.was_closed && step.was_sliding;
  if (!step.is_closed) {
    if (step.was_closed) change_[at].push_back({candidate, Kind::break_, leaving_s(step, last), {}});
    return;
  }
  if (!step.was_closed) {
    const double touching = touching_s(step);
    change_[at].push_back({candidate, Kind::make, touching, {}});
    // What slides from the start on has no time at which it stuck.
    if (step.is_sliding) change_[at].push_back({candidate, Kind::slip, touching, {}});
    const Plane way = step.place_m - step.anchor_m;  // an open contact's anchor goes with the particle
    last.way_m = {way[0] / w_.theta, way[1] / w_.theta};
  } else {
    if (!slid && step.is_sliding) change_[at].push_back(first_slip(candidate, step));
    if (slid && !step.is_sliding) {
      const double halting = halting_s(step, last);
      std::array<double, 3> force_N{};
      for (std::size_t i = 0; i < 3; ++i) {
        force_N[i] = step.before_N[i] + (step.theta_N[i] - step.before_N[i]) * halting / latest_s();
      }
      change_[at].push_back({candidate, Kind::stick, halting, force_N});
    }
    last.way_m = step.place_m - last.place_m;
  }
  last.place_m = step.place_m;
  last.depth_m = step.depth_m;
}

void ContactEvents::note_left(int candidate, int lane, const std::array<double, 3>& force_N) {
  if (!lanes_[lane]) return;
  change_[static_cast<std::size_t>(lane)].push_back({candidate, Kind::break_, earliest_s(), force_N});
}

void ContactEvents::forget() {
  if (none(lanes_)) return;
  for (std::vector<ContactChange>& changes : change_) changes.clear();
}

std::vector<ContactChange> ContactEvents::changes(int lane) const {
  std::vector<ContactChange> sorted = change_[static_cast<std::size_t>(lane)];
  // A contact that makes and slips at one time makes first.
  std::stable_sort(sorted.begin(), sorted.end(), [](const ContactChange& a, const ContactChange& b) {
    return std::tie(a.after_s, a.candidate) < std::tie(b.after_s, b.candidate);
  });
  return sorted;
}

/// The free motion closes the gap at a steady rate.
double ContactEvents::touching_s(const ContactStep& step) const {
  const double gap = std::max(0.0, step.gap_now_m);
  const double way = gap - step.gap_free_m;
  const double fraction = way > 0.0 ? gap / way : 0.0;
  return std::clamp(fraction * latest_s(), earliest_s(), latest_s());
}

/// Between the two times at which the layer's law was looked at, what it pushes with falls at a steady rate.
double ContactEvents::leaving_s(const ContactStep& step, const Memory& last) const {
  const double fall = last.depth_m - step.depth_m;
  const double fraction = fall > 0.0 ? last.depth_m / fall : 1.0;
  return std::clamp((w_.theta - 1.0 + fraction) * w_.dt, earliest_s(), latest_s());
}

/// Where the way along which it slid turns back, by the parabola through its last three places; at once where it
/// does not.
double ContactEvents::halting_s(const ContactStep& step, const Memory& last) const {
  const double along = dot(last.way_m, last.way_m), now = dot(step.place_m - last.place_m, last.way_m);
  const double fraction = along > now ? along / (along - now) - 0.5 : 0.0;
  return std::clamp((w_.theta - 1.0 + fraction) * w_.dt, earliest_s(), latest_s());
}

/// Where the force that the layer would have without slipping leaves the cone.
ContactChange ContactEvents::first_slip(int candidate, const ContactStep& step) const {
  Plane tangent{}, change{};
  for (std::size_t t = 0; t < 2; ++t) {
    tangent[t] = step.before_N[1 + t];
    change[t] = step.shear_N_m * (step.anchor_m[t] - step.place_m[t]) - tangent[t];
  }
  const double normal = step.before_N[0], rise = step.theta_N[0] - normal;
  const double fraction =
      std::min(1.0, leaving_cone(tangent, change, step.friction * normal, step.friction * rise));
  return {candidate,
          Kind::slip,
          std::clamp(fraction * latest_s(), earliest_s(), latest_s()),
          {normal + fraction * rise, tangent[0] + fraction * change[0], tangent[1] + fraction * change[1]}};
}

}  // namespace unbruised
