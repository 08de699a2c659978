#include "core/motion/palm_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

std::array<double, 3> times(double factor, std::array<double, 3> x) {
  for (double& component : x) component *= factor;
  return x;
}

std::array<double, 3> between(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// The profile of what share of the leg is done.
MotionProfile share_profile(ProfileKind kind, double way_m, double turn_rad, const PalmPath::Limits& m,
                            const PalmPath::Limits& rad) {
  if (!(way_m > 0.0)) {
    if (!(turn_rad > 0.0)) return {};
    return MotionProfile::plan(kind, 1.0, rad.acceleration / turn_rad, rad.speed / turn_rad);
  }
  if (!(turn_rad > 0.0)) return MotionProfile::plan(kind, 1.0, m.acceleration / way_m, m.speed / way_m);
  return MotionProfile::plan(kind, 1.0, std::min(m.acceleration / way_m, rad.acceleration / turn_rad),
                             std::min(m.speed / way_m, rad.speed / turn_rad));
}

}  // namespace

PalmPath::PalmPath(const PalmStop& from, const std::vector<PalmStop>& stops, ProfileKind profile, const Limits& m,
                   const Limits& rad)
    : from_(from) {
  PalmStop last = from;
  for (const PalmStop& stop : stops) {
    Leg leg{duration_s_,
            last,
            between(last.place_m, stop.place_m),
            rotation_to(stop.attitude * inverse(last.attitude)),
            {}};
    leg.share = share_profile(profile, length(leg.way_m), length(leg.turn_rad), m, rad);
    duration_s_ += leg.share.duration_s() + stop.wait_s;
    legs_.push_back(std::move(leg));
    last = stop;
  }
}

std::vector<double> PalmPath::jumps_s() const {
  std::vector<double> all;
  for (const Leg& leg : legs_) {
    for (const double jump_s : leg.share.jumps_s()) all.push_back(leg.start_s + jump_s);
  }
  return all;
}

PalmState PalmPath::at(double time_s) const {
  PalmState palm;
  if (legs_.empty()) {
    palm.position_m = from_.place_m;
    palm.rotation_rad = rotation_to(from_.attitude);
    return palm;
  }
  const auto next = std::upper_bound(legs_.begin() + 1, legs_.end(), time_s,
                                     [](double time, const Leg& leg) { return time < leg.start_s; });
  const Leg& leg = *(next - 1);
  const MotionProfile::State share = leg.share.at(time_s - leg.start_s);
  palm.position_m = leg.from.place_m;
  for (std::size_t i = 0; i < 3; ++i) palm.position_m[i] += share.position_m * leg.way_m[i];
  palm.velocity_m_s = times(share.velocity_m_s, leg.way_m);
  palm.acceleration_m_s2 = times(share.acceleration_m_s2, leg.way_m);
  palm.rotation_rad = rotation_to(attitude_of(times(share.position_m, leg.turn_rad)) * leg.from.attitude);
  palm.spin_rad_s = times(share.velocity_m_s, leg.turn_rad);
  palm.spin_acceleration_rad_s2 = times(share.acceleration_m_s2, leg.turn_rad);
  return palm;
}

}  // namespace unbruised
