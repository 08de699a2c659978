#pragma once

/// @file
/// Times the parts of a step for benchmarks. The clock never reaches a result.

#include <chrono>

namespace unbruised {

/// Adds the time since the last lap to a sum, in seconds.
class PartTimer {
 public:
  explicit PartTimer(bool enabled) : enabled_(enabled) {
    if (enabled_) last_ = std::chrono::steady_clock::now();
  }
  void lap(double& sum_s) {
    if (!enabled_) return;
    const auto now = std::chrono::steady_clock::now();
    sum_s += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  bool enabled_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace unbruised
