#pragma once

/// @file
/// What the instruments of the fingers read in one scenario, and when they show what a guard waits for. A sample
/// is taken at its own time: what it reads is interpolated between the ends of steps, and held until the next.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/scenario/scenario.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// What there is to read at the end of a step.
struct FingerSigns {
  std::array<double, kMostFingers> distance_m{};  ///< along the rays; infinite where they pass the product
  std::array<double, kMostFingers> force_N{};     ///< normal force of each finger
};

class FingerInstruments {
 public:
  explicit FingerInstruments(const Scenario& scenario);

  /// Is there nothing to be read?
  [[nodiscard]] bool idle() const { return !has_range() && !guard_force_N_; }
  [[nodiscard]] bool has_range() const { return range_.maximum_m.has_value(); }

  /// The state the scenario starts from; read at once.
  void start(const FingerSigns& now);
  /// Takes in a step.
  void observe(double start_s, double end_s, const FingerSigns& now);

  /// The held readings of the range sensors [m].
  [[nodiscard]] const std::array<double, kMostFingers>& range_m() const { return range_m_; }
  /// When an instrument first showed what the guard waits for; none: not yet, or there is no guard.
  [[nodiscard]] const std::optional<double>& guard_s() const { return guard_s_; }

 private:
  struct Step;
  [[nodiscard]] double reading_m(std::size_t finger, std::int64_t sample, double distance_m) const;
  void read_ranges(const Step& step);
  void sample_ranges(const Step& step);
  void watch_forces(const Step& step);
  void see_guard(double time_s);

  std::size_t finger_count_ = kJawFingers;
  RangeSensorParameters range_;
  std::optional<double> force_rate_Hz_;
  std::optional<double> guard_range_m_, guard_force_N_;  ///< what the guard waits for
  FingerSigns last_;                                     ///< at the end of the last step
  std::array<double, kMostFingers> range_m_{};
  std::optional<double> guard_s_;
};

}  // namespace unbruised
