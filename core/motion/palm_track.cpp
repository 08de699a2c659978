#include "core/motion/palm_track.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/door/require.hpp"
#include "core/scenario/attitude.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

/// A value with its first and second rate.
struct Rates {
  double value = 0.0, rate = 0.0, change = 0.0;
};

/// The polynomial of fifth degree between two, h apart, at the share u of it.
Rates between_rates(const Rates& from, const Rates& to, double h, double u) {
  const double a = 0.5 * h * h * from.change;
  const double way = to.value - from.value - h * from.rate - a;
  const double rate = h * (to.rate - from.rate) - 2.0 * a;
  const double change = h * h * (to.change - from.change);
  const double c3 = 10.0 * way - 4.0 * rate + 0.5 * change, c4 = -15.0 * way + 7.0 * rate - change,
               c5 = 6.0 * way - 3.0 * rate + 0.5 * change;
  return {from.value + u * (h * from.rate + u * (a + u * (c3 + u * (c4 + u * c5)))),
          from.rate + u * (2.0 * a + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5))) / h,
          from.change + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5)) / (h * h)};
}

/// A small turn about the vector by its length, and how the vector changes.
struct Turn {
  Vector r{}, rate{}, change{};
};

/// Of a body that has turned by r and spins: spin = r' + r x r' / 2 + r x (r x r') / 6, up to r^3 / 24.
Turn turn_of(const Vector& r, const Vector& spin, const Vector& spin_change) {
  const auto back = [&](const Vector& x) {
    return sum(x, sum(times(-0.5, cross(r, x)), times(1.0 / 12.0, cross(r, cross(r, x)))));
  };
  const Vector rate = back(spin);
  return {r, rate, back(sum(spin_change, times(-1.0 / 6.0, cross(rate, cross(r, rate)))))};
}

Vector spin_of(const Turn& turn, const Vector& x) {
  return sum(x, sum(times(0.5, cross(turn.r, x)), times(1.0 / 6.0, cross(turn.r, cross(turn.r, x)))));
}

}  // namespace

PalmTrack::PalmTrack(double start_s, double step_s, std::vector<PalmState> knot)
    : start_s_(start_s), step_s_(step_s), knot_(std::move(knot)) {
  require(!knot_.empty() && step_s > 0.0, "PalmTrack: a track has knots, a step apart");
}

PalmState PalmTrack::at(double time_s) const {
  const double steps = std::max(0.0, (time_s - start_s_) / step_s_);
  PalmState palm = knot_.back();
  if (steps >= static_cast<double>(knot_.size() - 1)) {
    palm.velocity_m_s = palm.acceleration_m_s2 = palm.spin_rad_s = palm.spin_acceleration_rad_s2 = {};
    return palm;
  }
  const auto index = static_cast<std::size_t>(steps);
  const double u = steps - static_cast<double>(index);
  const PalmState &from = knot_[index], &to = knot_[index + 1];
  const Attitude start = attitude_of(from.rotation_rad);
  const Turn first = turn_of({}, from.spin_rad_s, from.spin_acceleration_rad_s2);
  const Turn last = turn_of(rotation_to(attitude_of(to.rotation_rad) * inverse(start)), to.spin_rad_s,
                            to.spin_acceleration_rad_s2);
  Turn turn;
  for (std::size_t d = 0; d < 3; ++d) {
    const Rates place = between_rates({from.position_m[d], from.velocity_m_s[d], from.acceleration_m_s2[d]},
                                      {to.position_m[d], to.velocity_m_s[d], to.acceleration_m_s2[d]}, step_s_, u);
    palm.position_m[d] = place.value;
    palm.velocity_m_s[d] = place.rate;
    palm.acceleration_m_s2[d] = place.change;
    const Rates turned = between_rates({0.0, first.rate[d], first.change[d]},
                                       {last.r[d], last.rate[d], last.change[d]}, step_s_, u);
    turn.r[d] = turned.value;
    turn.rate[d] = turned.rate;
    turn.change[d] = turned.change;
  }
  palm.rotation_rad = rotation_to(attitude_of(turn.r) * start);
  palm.spin_rad_s = spin_of(turn, turn.rate);
  palm.spin_acceleration_rad_s2 =
      sum(spin_of(turn, turn.change), times(1.0 / 6.0, cross(turn.rate, cross(turn.r, turn.rate))));
  return palm;
}

}  // namespace unbruised
