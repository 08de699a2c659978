#include "core/motion/moving_transfer.hpp"

#include <algorithm>
#include <cmath>

#include "core/door/require.hpp"
#include "core/scenario/conveyor.hpp"

namespace unbruised {
namespace {

double size(const Horizontal& x) { return std::hypot(x[0], x[1]); }

/// Share of a change of speed that is done at s = t / T, its integral and its derivatives.
struct SpeedChange {
  double way = 0.0, share = 0.0, rate = 0.0, curve = 0.0;  ///< curve: derivative of the rate
};
SpeedChange speed_change(ProfileKind kind, double s) {
  if (kind == ProfileKind::trapezoid) return {0.5 * s * s, s, 1.0};
  const double s2 = s * s;
  return {s2 * s2 * (2.5 - 3.0 * s + s2), s2 * s * (10.0 - 15.0 * s + 6.0 * s2), 30.0 * s2 * (1.0 - s) * (1.0 - s),
          60.0 * s * (1.0 - s) * (1.0 - 2.0 * s)};
}

/// What the profile on top has to do in the time T.
Horizontal left_over_m(const MovingPlace& from, const MovingPlace& to, double T) {
  Horizontal left{};
  for (std::size_t i = 0; i < 2; ++i) {
    left[i] = to.place_m[i] - from.place_m[i] + 0.5 * T * (to.velocity_m_s[i] - from.velocity_m_s[i]);
  }
  return left;
}

}  // namespace

MovingTransfer::MovingTransfer(ProfileKind kind, const MovingPlace& from, const MovingPlace& to, double duration_s)
    : kind_(kind), from_(from), to_(to), duration_s_(duration_s) {
  const Horizontal left = left_over_m(from, to, duration_s);
  const double way = size(left);
  if (way > 0.0) along_ = {left[0] / way, left[1] / way};
  rest_ = MotionProfile::in_time(kind, way, duration_s);
}

MovingTransfer MovingTransfer::plan(ProfileKind kind, const MovingPlace& from, const MovingPlace& to,
                                    const MotionLimits& m) {
  require(m.acceleration > 0.0 && m.speed >= kPalmRoom * size(from.velocity_m_s) &&
              m.speed >= kPalmRoom * size(to.velocity_m_s),
          "MovingTransfer: a place moves faster than the palm can follow");
  if (from.place_m == to.place_m && from.velocity_m_s == to.velocity_m_s) {
    MovingTransfer nowhere;
    nowhere.from_ = from;
    nowhere.to_ = to;
    return nowhere;
  }
  const auto serves = [&](double duration_s) {
    const MovingTransfer transfer(kind, from, to, duration_s);
    constexpr int kLooks = 96;  // a trapezoid's corners are among them
    for (int i = 1; i < kLooks; ++i) {
      const State state = transfer.at(duration_s * i / kLooks);
      if (size(state.acceleration_m_s2) > m.acceleration || size(state.velocity_m_s) > m.speed) return false;
      if (kind == ProfileKind::s_curve && size(state.jerk_m_s3) > m.jerk) return false;
    }
    return true;
  };
  double high = 1e-3;
  constexpr int kDoublings = 40, kHalvings = 50;
  for (int i = 0; i < kDoublings && !serves(high); ++i) high *= 2.0;
  double low = 0.5 * high;
  for (int i = 0; i < kHalvings; ++i) (serves(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return {kind, from, to, high};
}

MovingTransfer::State MovingTransfer::at(double time_s) const {
  State state;
  const double t = std::clamp(time_s, 0.0, duration_s_), T = duration_s_;
  const bool moves = time_s > 0.0 && time_s < T;
  const SpeedChange change = T > 0.0 ? speed_change(kind_, t / T) : SpeedChange{.way = 0.5, .share = 1.0};
  const MotionProfile::State rest = rest_.at(t);
  for (std::size_t i = 0; i < 2; ++i) {
    const double from = from_.velocity_m_s[i], step = to_.velocity_m_s[i] - from;
    const double beyond = time_s - t;  // before the start, or after the end
    state.velocity_m_s[i] = from + change.share * step + along_[i] * rest.velocity_m_s;
    state.place_m[i] = from_.place_m[i] + from * t + change.way * T * step + along_[i] * rest.position_m;
    state.place_m[i] += beyond * (beyond < 0.0 ? from : to_.velocity_m_s[i]);
    if (!moves) continue;
    state.acceleration_m_s2[i] = change.rate / T * step + along_[i] * rest.acceleration_m_s2;
    state.jerk_m_s3[i] = change.curve / (T * T) * step + along_[i] * rest.jerk_m_s3;
  }
  return state;
}

}  // namespace unbruised
