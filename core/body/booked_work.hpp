#pragma once

/// @file
/// Work of which the power is known at the starts of steps.

#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

/// Work by the trapezoid rule over time, since load.
class BookedWork {
 public:
  void load(int lane) {
    for (Lane* value : {&work_, &power_, &last_step_s_}) value->set(lane, 0.0);
  }
  /// @param power at the start of a step
  void book(double step_s, const Lane& power, const Mask& running) {
    work_ += select(running, Lane(0.5) * (last_step_s_ + Lane(step_s)) * power, Lane(0.0));
    last_step_s_ = select(running, Lane(step_s), last_step_s_);
    power_ = select(running, power, power_);
  }
  [[nodiscard]] double work_J(int lane) const { return work_[lane] + 0.5 * last_step_s_[lane] * power_[lane]; }
  void archive(LaneArchive& lane) { lane(work_, power_, last_step_s_); }

 private:
  Lane work_{0.0}, power_{0.0};
  Lane last_step_s_{0.0};  ///< 0: not stepped yet
};

}  // namespace unbruised
