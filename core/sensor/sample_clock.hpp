#pragma once

/// @file
/// When an instrument samples: at k / rate, k = 0, 1, ..., real numbers that no step rounds.

#include <cmath>
#include <cstdint>

namespace unbruised {

class SampleClock {
 public:
  /// @param rate_Hz > 0
  explicit SampleClock(double rate_Hz) : rate_Hz_(rate_Hz) {}

  [[nodiscard]] double time_s(std::int64_t k) const { return static_cast<double>(k) / rate_Hz_; }
  /// The last sample at or before a time >= 0. Each sample lies in one of the steps (t, t + dt].
  [[nodiscard]] std::int64_t last(double at_s) const {
    auto k = static_cast<std::int64_t>(std::floor(at_s * rate_Hz_));
    while (time_s(k + 1) <= at_s) ++k;
    while (k > 0 && time_s(k) > at_s) --k;
    return k;
  }

 private:
  double rate_Hz_;
};

}  // namespace unbruised
