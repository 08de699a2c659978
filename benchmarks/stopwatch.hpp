#pragma once

/// @file
/// Processor time, wall-clock samples, and what a table says of them: the best and the median.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <vector>

namespace unbruised::benchmarks {

/// Of this process so far: what the machine does beside it is not in it.
inline double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Seconds that `work()` takes.
template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Repeated measurements of one thing, in seconds. Neither value exists before the first `add`.
class Samples {
 public:
  void add(double seconds) { seconds_.push_back(seconds); }
  [[nodiscard]] std::size_t count() const { return seconds_.size(); }
  /// What the machine can do: other processes only ever make it longer.
  [[nodiscard]] double best_s() const { return *std::min_element(seconds_.begin(), seconds_.end()); }
  /// What it did; far above the best on a busy machine.
  [[nodiscard]] double median_s() const {
    std::vector<double> sorted = seconds_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }

 private:
  std::vector<double> seconds_;
};

}  // namespace unbruised::benchmarks
