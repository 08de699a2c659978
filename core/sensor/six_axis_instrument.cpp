#include "core/sensor/six_axis_instrument.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/chance/philox.hpp"
#include "core/sensor/sample_clock.hpp"

namespace unbruised {
namespace {

/// Looks within a step at a sensor that reads at all times: a half sine that lasts 12 steps loses 1e-4 of its
/// peak.
constexpr int kLooks = 8;
/// Of the noise: each component draws from a stream of its own; range sensors have the numbers below.
constexpr std::uint64_t kFirstStream = 16;

double size(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

Six between(const Six& from, const Six& to, double share) {
  Six value{};
  for (std::size_t i = 0; i < 6; ++i) value[i] = from[i] + share * (to[i] - from[i]);
  return value;
}

}  // namespace

SixAxisInstrument::SixAxisInstrument(const SixAxisSensorParameters& sensor, const SixBySix& stiffness,
                                     const MountState& start)
    : sensor_(sensor), stiffness_(stiffness), last_(start) {
  const Signal now = signal(start.twist, start.own_wrench, start.contact_wrench);
  filtered_ = filtered_from_ = now;
  if (sensor.tare == SensorTare::own_weight) tare_ = moved(add({}, -1.0, start.own_wrench), sensor.report_at_m);
  if (sensor.tare == SensorTare::start) tare_ = now.held;
  if (sensor.range_N || sensor.range_N_m) overload_ = 0.0;
  read(0);
  note_peaks(0.0);
}

SixAxisInstrument::Signal SixAxisInstrument::signal(const Six& twist, const Six& own_wrench,
                                                    const Six& contact_wrench) const {
  const Six quasi_static = add(add({}, -1.0, contact_wrench), -1.0, own_wrench);
  const Six held = sensor_.motion_prediction ? add({}, -1.0, multiply(stiffness_, twist)) : quasi_static;
  const Six correction = add(add({}, -1.0, contact_wrench), -1.0, held);
  return {moved(held, sensor_.report_at_m), moved(correction, sensor_.report_at_m)};
}

/// Within a step accelerations are linear, as Wilson's method has them, and so are wrenches.
SixAxisInstrument::Signal SixAxisInstrument::signal_at(double s, double step_s, const MountState& end) const {
  if (s >= step_s) return signal(end.twist, end.own_wrench, end.contact_wrench);
  Six twist{};
  for (std::size_t i = 0; i < 6; ++i) {
    const double a = last_.acceleration[i], jerk = (end.acceleration[i] - a) / step_s;
    twist[i] = last_.twist[i] + s * (last_.velocity[i] + s * (0.5 * a + s * jerk / 6.0));
  }
  return signal(twist, between(last_.own_wrench, end.own_wrench, s / step_s),
                between(last_.contact_wrench, end.contact_wrench, s / step_s));
}

void SixAxisInstrument::observe(double start_s, double end_s, const MountState& end) {
  const double step_s = end_s - start_s;
  const auto look = [&](double time_s) {
    filter(time_s, signal_at(std::min(time_s - start_s, step_s), step_s, end));
  };
  if (sensor_.rate_Hz) {
    const SampleClock clock(*sensor_.rate_Hz);
    const std::int64_t last = clock.last(end_s);
    for (std::int64_t k = clock.last(start_s) + 1; k <= last; ++k) {
      look(clock.time_s(k));
      read(k);
      note_peaks(clock.time_s(k));
    }
    look(end_s);
  } else {
    const int looks = sensor_.motion_prediction ? kLooks : 1;
    for (int i = 1; i <= looks; ++i) {
      const double time_s = i == looks ? end_s : start_s + step_s * i / looks;
      look(time_s);
      read(0);
      note_peaks(time_s);
    }
  }
  last_ = end;
}

/// First order, exact for what changes linearly from look to look.
void SixAxisInstrument::filter(double time_s, const Signal& to) {
  const double step_s = time_s - filtered_at_s_;
  filtered_at_s_ = time_s;
  if (!sensor_.bandwidth_Hz || !(step_s > 0.0)) {
    if (!sensor_.bandwidth_Hz) filtered_ = to;
    filtered_from_ = to;
    return;
  }
  const double tau = 1.0 / (2.0 * std::numbers::pi * *sensor_.bandwidth_Hz);
  const double left = std::exp(-step_s / tau);
  const auto pass = [&](const Six& from, const Six& now, Six& out) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double lag = tau * (now[i] - from[i]) / step_s;
      out[i] = now[i] - lag + (out[i] - from[i] + lag) * left;
    }
  };
  pass(filtered_from_.held, to.held, filtered_.held);
  pass(filtered_from_.correction, to.correction, filtered_.correction);
  filtered_from_ = to;
}

void SixAxisInstrument::read(std::int64_t sample) {
  Six wrench = add(filtered_.held, -1.0, tare_);
  for (std::size_t i = 0; i < 6; ++i) {
    const double deviation = i < 3 ? sensor_.noise_N : sensor_.noise_N_m;
    if (!(deviation > 0.0)) continue;
    wrench[i] += deviation * standard_normal(static_cast<std::uint64_t>(sensor_.noise_seed), kFirstStream + i,
                                             static_cast<std::uint64_t>(sample));
  }
  reading_ = as_shown(wrench);
  compensated_ = add(add(reading_, 1.0, tare_), 1.0, filtered_.correction);
}

/// In steps of the resolution, and within the range.
Six SixAxisInstrument::as_shown(Six wrench) {
  for (std::size_t i = 0; i < 6; ++i) {
    const double step = i < 3 ? sensor_.resolution_N : sensor_.resolution_N_m;
    if (step > 0.0) wrench[i] = step * std::round(wrench[i] / step);
    const std::optional<double>& most = i < 3 ? sensor_.range_N : sensor_.range_N_m;
    if (!most) continue;
    overload_ = std::max(overload_.value_or(0.0), std::abs(wrench[i]) / *most);
    wrench[i] = std::clamp(wrench[i], -*most, *most);
  }
  return wrench;
}

void SixAxisInstrument::note_peaks(double time_s) {
  const ForceSample now{time_s, size(reading_[0], reading_[1], reading_[2])};
  const auto& [first, middle] = before_;
  peak_torque_N_m_ = std::max(peak_torque_N_m_, size(reading_[3], reading_[4], reading_[5]));
  if (now.force_N > peak_force_N_) {
    peak_force_N_ = now.force_N;
    peak_force_time_s_ = now.time_s;
  }
  // A peak between looks: of the parabola through three of them.
  const bool is_even =
      std::abs((now.time_s - middle.time_s) - (middle.time_s - first.time_s)) < 1e-6 * (now.time_s - first.time_s);
  if (!sensor_.rate_Hz && is_even && middle.force_N > first.force_N && middle.force_N > now.force_N) {
    const double bend = first.force_N - 2.0 * middle.force_N + now.force_N;
    const double slope = 0.5 * (now.force_N - first.force_N);
    const double top_N = middle.force_N - 0.5 * slope * slope / bend;
    if (top_N > peak_force_N_) {
      peak_force_N_ = top_N;
      peak_force_time_s_ = middle.time_s - (now.time_s - middle.time_s) * slope / bend;
    }
  }
  before_ = {middle, now};
}

}  // namespace unbruised
