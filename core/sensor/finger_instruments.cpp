#include "core/sensor/finger_instruments.hpp"

#include <algorithm>
#include <cmath>

#include "core/chance/philox.hpp"
#include "core/scenario/gripper.hpp"
#include "core/sensor/sample_clock.hpp"

namespace unbruised {

struct FingerInstruments::Step {
  double start_s, end_s;
  const FingerSigns& now;

  /// A part of the step.
  [[nodiscard]] double share(double time_s) const { return (time_s - start_s) / (end_s - start_s); }
  [[nodiscard]] double time_s(double share) const { return start_s + share * (end_s - start_s); }
};

namespace {

/// A ray that comes to meet the product or to pass it does so within the step: until half of it, it has not.
double between(double before, double after, double share) {
  if (std::isfinite(before) && std::isfinite(after)) return before + share * (after - before);
  return share < 0.5 ? before : after;
}

/// The part of a step after which a value that falls linearly is below a bound; none: it is not, at its end.
std::optional<double> falls_below(double bound, double before, double after) {
  if (!(after < bound)) return std::nullopt;
  if (before < bound) return 0.0;
  return std::isfinite(before) ? (before - bound) / (before - after) : 0.5;
}

}  // namespace

FingerInstruments::FingerInstruments(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return;
  finger_count_ = static_cast<std::size_t>(finger_count(scenario));
  range_ = jaw->range;
  force_rate_Hz_ = jaw->force_rate_Hz;
  const StrategyParameters& s = scenario.strategy;
  if (s.guard == GuardKind::range) guard_range_m_ = s.guard_range_m;
  if (s.guard == GuardKind::force) guard_force_N_ = s.guard_force_N;
}

void FingerInstruments::see_guard(double time_s) { guard_s_ = std::min(time_s, guard_s_.value_or(time_s)); }

/// The noise of a sample belongs to its number and its finger.
double FingerInstruments::reading_m(std::size_t finger, std::int64_t sample, double distance_m) const {
  if (!(distance_m < *range_.maximum_m)) return *range_.maximum_m;
  if (range_.noise_m > 0.0) {
    distance_m += range_.noise_m * standard_normal(static_cast<std::uint64_t>(range_.noise_seed), finger,
                                                   static_cast<std::uint64_t>(sample));
  }
  if (range_.resolution_m > 0.0) distance_m = std::round(distance_m / range_.resolution_m) * range_.resolution_m;
  return std::clamp(distance_m, 0.0, *range_.maximum_m);
}

void FingerInstruments::start(const FingerSigns& now) {
  last_ = now;
  if (!has_range()) return;
  for (std::size_t f = 0; f < finger_count_; ++f) {
    range_m_[f] = reading_m(f, 0, now.distance_m[f]);
    if (guard_range_m_ && range_m_[f] < *guard_range_m_) see_guard(0.0);
  }
}

void FingerInstruments::observe(double start_s, double end_s, const FingerSigns& now) {
  const Step step{start_s, end_s, now};
  if (has_range()) range_.rate_Hz ? sample_ranges(step) : read_ranges(step);
  if (guard_force_N_ && !guard_s_) watch_forces(step);
  last_ = now;
}

void FingerInstruments::sample_ranges(const Step& step) {
  const SampleClock clock(*range_.rate_Hz);
  const std::int64_t last = clock.last(step.end_s);
  for (std::int64_t k = clock.last(step.start_s) + 1; k <= last; ++k) {
    const double time_s = clock.time_s(k);
    for (std::size_t f = 0; f < finger_count_; ++f) {
      range_m_[f] = reading_m(f, k, between(last_.distance_m[f], step.now.distance_m[f], step.share(time_s)));
      if (guard_range_m_ && !guard_s_ && range_m_[f] < *guard_range_m_) see_guard(time_s);
    }
  }
}

void FingerInstruments::read_ranges(const Step& step) {
  for (std::size_t f = 0; f < finger_count_; ++f) {
    const double before_m = range_m_[f];
    range_m_[f] = reading_m(f, 0, step.now.distance_m[f]);
    if (!guard_range_m_) continue;
    const auto share = falls_below(*guard_range_m_, before_m, range_m_[f]);
    if (share) see_guard(step.time_s(*share));
  }
}

void FingerInstruments::watch_forces(const Step& step) {
  const auto force = [&](double share) {
    double largest_N = 0.0;
    for (std::size_t f = 0; f < finger_count_; ++f) {
      largest_N = std::max(largest_N, between(last_.force_N[f], step.now.force_N[f], share));
    }
    return largest_N;
  };
  if (!force_rate_Hz_) {
    for (std::size_t f = 0; f < finger_count_; ++f) {
      const auto share = falls_below(-*guard_force_N_, -last_.force_N[f], -step.now.force_N[f]);
      if (share) see_guard(step.time_s(*share));
    }
    return;
  }
  const SampleClock clock(*force_rate_Hz_);
  const std::int64_t last = clock.last(step.end_s);
  for (std::int64_t k = clock.last(step.start_s) + 1; k <= last && !guard_s_; ++k) {
    if (force(step.share(clock.time_s(k))) > *guard_force_N_) see_guard(clock.time_s(k));
  }
}

}  // namespace unbruised
