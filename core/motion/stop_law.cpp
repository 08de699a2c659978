#include "core/motion/stop_law.hpp"

#include <algorithm>

#include "core/scenario/vectors.hpp"

namespace unbruised {

StopLaw::State StopLaw::after(State start, double h) {
  start.plan_s += h * (start.rate + 0.5 * h * start.change_1_s);
  start.rate += h * start.change_1_s;
  return start;
}

void StopLaw::add(double change_1_s, double duration_s) {
  end_.change_1_s = change_1_s;
  part_.push_back({duration_s_, end_});
  end_ = after(end_, duration_s);
  duration_s_ += duration_s;
}

StopLaw::State StopLaw::at(double since_s) const {
  if (since_s >= duration_s_) return {end_.plan_s, 0.0, 0.0};
  const auto next = std::upper_bound(part_.begin() + 1, part_.end(), since_s,
                                     [](double time_s, const Part& part) { return time_s < part.since_s; });
  const Part& part = *(next - 1);
  return after(part.start, since_s - part.since_s);
}

PalmState StopLaw::slowed(PalmState planned, const State& s) {
  const auto slow = [&s](std::array<double, 3>& rate, std::array<double, 3>& change) {
    change = sum(times(s.rate * s.rate, change), times(s.change_1_s, rate));
    rate = times(s.rate, rate);
  };
  slow(planned.velocity_m_s, planned.acceleration_m_s2);
  slow(planned.spin_rad_s, planned.spin_acceleration_rad_s2);
  return planned;
}

}  // namespace unbruised
