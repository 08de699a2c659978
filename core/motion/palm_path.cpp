#include "core/motion/palm_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// Limits along an arc with which those of all directions hold: half of the square of the acceleration goes along
/// it and half across. The jerk is (j - v^3 / r^2, 3 v a / r) along and across: j and v^3 / r^2 a quarter of the
/// limit each and 3 v a / r four fifths come to 0.95 of it.
PalmPath::Limits along_arc(const PalmPath::Limits& m, double radius_m) {
  PalmPath::Limits along = m;
  along.acceleration = m.acceleration / std::numbers::sqrt2;
  along.speed = std::min(m.speed, std::sqrt(along.acceleration * radius_m));
  if (!std::isfinite(m.jerk)) return along;
  along.jerk = 0.25 * m.jerk;
  along.speed = std::min(along.speed, std::cbrt(0.25 * m.jerk * radius_m * radius_m));
  along.acceleration = std::min(along.acceleration, 0.8 / 3.0 * m.jerk * radius_m / along.speed);
  return along;
}

/// An s_curve alone looks at the jerk.
PalmPath::Limits jerked(ProfileKind kind, PalmPath::Limits limits) {
  if (kind != ProfileKind::s_curve) limits.jerk = std::numeric_limits<double>::infinity();
  return limits;
}

/// Of what share of a leg is done.
PalmPath::Limits share_limits(double way_m, double turn_rad, const PalmPath::Limits& m,
                              const PalmPath::Limits& rad) {
  const auto share = [](const PalmPath::Limits& limits, double way) {
    return PalmPath::Limits{limits.speed / way, limits.acceleration / way, limits.jerk / way};
  };
  if (!(way_m > 0.0)) return share(rad, turn_rad);
  if (!(turn_rad > 0.0)) return share(m, way_m);
  const PalmPath::Limits goes = share(m, way_m), turns = share(rad, turn_rad);
  return {std::min(goes.speed, turns.speed), std::min(goes.acceleration, turns.acceleration),
          std::min(goes.jerk, turns.jerk)};
}

/// The profile of what share of the leg is done.
MotionProfile share_profile(ProfileKind kind, double way_m, double turn_rad, const PalmStop& to,
                            PalmPath::Limits m, const PalmPath::Limits& rad) {
  if (!(way_m > 0.0) && !(turn_rad > 0.0)) return {};
  if (to.speed_m_s) m.speed = std::min(m.speed, *to.speed_m_s);
  const auto plan = [kind](const PalmPath::Limits& limits) {
    return MotionProfile::plan(kind, 1.0, limits.acceleration, limits.speed, limits.jerk);
  };
  const PalmPath::Limits limits = share_limits(way_m, turn_rad, m, rad);
  const MotionProfile fastest = plan(limits);
  const double slower = to.duration_s ? *to.duration_s / fastest.duration_s() : 1.0;
  if (!(slower > 1.0)) return fastest;
  // Stretched in time: the speed that it reaches and not the one it may reach has to fall.
  const double reached = std::min(limits.speed, fastest.at(0.5 * fastest.duration_s()).velocity_m_s);
  return plan(
      {reached / slower, limits.acceleration / (slower * slower), limits.jerk / (slower * slower * slower)});
}

}  // namespace

PalmPath::PalmPath(const PalmStop& from, const std::vector<PalmStop>& stops, ProfileKind profile, const Limits& m,
                   const Limits& rad)
    : from_(from) {
  const Limits goes = jerked(profile, m), turns = jerked(profile, rad);
  add_legs(stops, profile, goes, turns, 1.0);
  const bool blends = std::ranges::any_of(stops, [](const PalmStop& stop) { return stop.blend_m > 0.0; });
  // Two motions at their limits leave no room to add up in: slower ones may be blended more.
  for (const double room : {0.9, 0.8, 1.0 / std::numbers::sqrt2, 0.6, 0.5}) {
    if (!blends) break;
    PalmPath other;
    other.from_ = from;
    other.add_legs(stops, profile, goes, turns, room);
    if (other.duration_s_ < duration_s_) *this = std::move(other);
  }
}

void PalmPath::add_legs(const std::vector<PalmStop>& stops, ProfileKind profile, const Limits& m,
                        const Limits& rad, double room) {
  const auto of = [room](const Limits& limits) {
    return Limits{limits.speed, room * limits.acceleration, room * limits.jerk};
  };
  PalmStop last = from_;
  for (const PalmStop& stop : stops) {
    Leg leg{duration_s_,
            last,
            between(last.place_m, stop.place_m),
            rotation_to(stop.attitude * inverse(last.attitude)),
            {},
            arc_between(last, stop)};
    const double way_m = leg.arc ? leg.arc->length_m() : length(leg.way_m);
    leg.share = share_profile(profile, way_m, length(leg.turn_rad), stop,
                              leg.arc ? along_arc(of(m), leg.arc->radius_m()) : of(m), of(rad));
    if (last.blend_m > 0.0 && !legs_.empty()) leg.start_s -= overlap_s(legs_.back(), leg, last.blend_m, m, rad);
    duration_s_ = leg.start_s + (leg.share.duration_s() + stop.wait_s);
    legs_.push_back(std::move(leg));
    last = stop;
  }
}

PalmState PalmPath::Leg::done(const MotionProfile::State& share_done) const {
  PalmState palm;
  palm.position_m = times(share_done.position_m, way_m);
  palm.velocity_m_s = times(share_done.velocity_m_s, way_m);
  palm.acceleration_m_s2 = times(share_done.acceleration_m_s2, way_m);
  if (arc) {
    const std::array<double, 3> r =
        turned(attitude_of(times(share_done.position_m * arc->angle_rad, arc->axis)), arc->from_center_m);
    const std::array<double, 3> along = cross(arc->axis, r);
    const double w = share_done.velocity_m_s * arc->angle_rad;
    palm.position_m = between(arc->from_center_m, r);
    palm.velocity_m_s = times(w, along);
    palm.acceleration_m_s2 = sum(times(share_done.acceleration_m_s2 * arc->angle_rad, along), times(-w * w, r));
  }
  palm.rotation_rad = times(share_done.position_m, turn_rad);
  palm.spin_rad_s = times(share_done.velocity_m_s, turn_rad);
  palm.spin_acceleration_rad_s2 = times(share_done.acceleration_m_s2, turn_rad);
  return palm;
}

namespace {

/// First what is left of one motion, then the other: how both add up. Rotations are about vectors by their length.
void add_before(const PalmState& left, PalmState& palm) {
  const Attitude turn = attitude_of(palm.rotation_rad);
  const std::array<double, 3> carried = turned(turn, left.spin_rad_s);
  palm.spin_acceleration_rad_s2 =
      sum(sum(palm.spin_acceleration_rad_s2, turned(turn, left.spin_acceleration_rad_s2)),
          cross(palm.spin_rad_s, carried));
  palm.spin_rad_s = sum(palm.spin_rad_s, carried);
  palm.rotation_rad = rotation_to(turn * attitude_of(left.rotation_rad));
  palm.position_m = sum(palm.position_m, left.position_m);
  palm.velocity_m_s = sum(palm.velocity_m_s, left.velocity_m_s);
  palm.acceleration_m_s2 = sum(palm.acceleration_m_s2, left.acceleration_m_s2);
}

}  // namespace

PalmPath::Peaks PalmPath::peaks_of(const Leg& last, const Leg& next, double overlap_s) {
  constexpr int kLooks = 48;
  Peaks peaks;
  peaks.least_distance_m = std::numeric_limits<double>::infinity();
  const std::array<double, 3> whole = last.done({.position_m = 1.0}).position_m;
  std::array<double, 3> before{}, spin_before{};
  for (int i = 0; i <= kLooks; ++i) {
    const double time_s = overlap_s * i / kLooks;
    PalmState palm = next.done(next.share.at(time_s));
    add_before(last.done(last.share.at(last.share.duration_s() - overlap_s + time_s)), palm);
    peaks.least_distance_m = std::min(peaks.least_distance_m, length(between(whole, palm.position_m)));
    peaks.speed = std::max(peaks.speed, length(palm.velocity_m_s));
    peaks.acceleration = std::max(peaks.acceleration, length(palm.acceleration_m_s2));
    peaks.spin = std::max(peaks.spin, length(palm.spin_rad_s));
    peaks.spin_acceleration = std::max(peaks.spin_acceleration, length(palm.spin_acceleration_rad_s2));
    if (i > 0) {
      const double step_s = overlap_s / kLooks;
      peaks.jerk = std::max(peaks.jerk, length(between(before, palm.acceleration_m_s2)) / step_s);
      peaks.spin_jerk =
          std::max(peaks.spin_jerk, length(between(spin_before, palm.spin_acceleration_rad_s2)) / step_s);
    }
    before = palm.acceleration_m_s2;
    spin_before = palm.spin_acceleration_rad_s2;
  }
  return peaks;
}

double PalmPath::overlap_s(const Leg& last, const Leg& next, double blend_m, const Limits& m, const Limits& rad) {
  constexpr int kTries = 60;
  constexpr double kShorter = 0.88, kRounding = 1.0 + 1e-9;
  const double most_s = 0.5 * std::min(last.share.duration_s(), next.share.duration_s());
  double overlap_s = most_s;
  for (int i = 0; i < kTries; ++i, overlap_s *= kShorter) {
    const Peaks peaks = peaks_of(last, next, overlap_s);
    const bool keeps_limits =
        peaks.speed <= kRounding * m.speed && peaks.acceleration <= kRounding * m.acceleration &&
        peaks.jerk <= kRounding * m.jerk && peaks.spin <= kRounding * rad.speed &&
        peaks.spin_acceleration <= kRounding * rad.acceleration && peaks.spin_jerk <= kRounding * rad.jerk;
    if (keeps_limits && peaks.least_distance_m <= blend_m) return overlap_s;
  }
  return 0.0;
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
  const auto leg = next - 1;
  palm = leg->done(leg->share.at(time_s - leg->start_s));
  Attitude from = leg->from.attitude;
  if (leg != legs_.begin() && time_s < (leg - 1)->end_s()) {
    const Leg& last = *(leg - 1);
    PalmState left = last.done(last.share.at(time_s - last.start_s));
    left.position_m = between(last.done({.position_m = 1.0}).position_m, left.position_m);
    add_before(left, palm);
    from = last.from.attitude;
  }
  palm.position_m = sum(leg->from.place_m, palm.position_m);
  palm.rotation_rad = rotation_to(attitude_of(palm.rotation_rad) * from);
  return palm;
}

}  // namespace unbruised
