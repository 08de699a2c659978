#include "core/outcome/peak_rise.hpp"

#include <algorithm>

namespace unbruised {

void PeakRise::observe(double force_N) {
  if (!started_) last_N_.fill(force_N);
  started_ = true;
  peak_N_ = std::max(peak_N_, force_N);
  for (std::size_t back = 1; back < kMostRiseSteps; ++back) {
    const double before_N = last_N_[(next_ + kMostRiseSteps - back) % kMostRiseSteps];
    climb_N_[back] = std::max(climb_N_[back], force_N - before_N);
  }
  last_N_[next_] = force_N;
  next_ = (next_ + 1) % kMostRiseSteps;
}

int PeakRise::steps() const {
  for (std::size_t back = 1; back < kMostRiseSteps; ++back) {
    if (peak_N_ > 0.0 && climb_N_[back] >= 0.5 * peak_N_) return static_cast<int>(back);
  }
  return kMostRiseSteps;
}

}  // namespace unbruised
