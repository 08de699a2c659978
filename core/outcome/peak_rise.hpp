#pragma once

/// @file
/// In how few time steps a force rose by half of its peak: one or two say that an impact was stepped over, and
/// that its true peak is higher (docs/contact.md, "Impacts that a step does not resolve").

#include <array>
#include <cstddef>

namespace unbruised {

/// More steps than these are not counted.
inline constexpr int kMostRiseSteps = 8;
/// With fewer steps the peak is off. Half a sine of 12 steps, whose peak Wilson's method gets within some per
/// cent, rises by half of its height in 2.
inline constexpr int kFewestRiseSteps = 3;

class PeakRise {
 public:
  /// Takes in the force at the end of a step. What presses from the first one on has not risen.
  void observe(double force_N);
  [[nodiscard]] double peak_N() const { return peak_N_; }
  /// Fewest steps within which the force rose by half of its peak; kMostRiseSteps where it took as many or more.
  [[nodiscard]] int steps() const;

 private:
  std::array<double, kMostRiseSteps> last_N_{};   ///< a ring
  std::array<double, kMostRiseSteps> climb_N_{};  ///< largest rise over 1, 2, ... steps
  std::size_t next_ = 0;
  bool started_ = false;
  double peak_N_ = 0;
};

}  // namespace unbruised
