#include "core/outcome/contact_transition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unbruised {

void ContactTransition::observe(double time_s, std::span<const TouchObservation> finger,
                                const HandlingCycle& cycle) {
  finger_count_ = finger.size();
  if (lift_started_) return;
  lift_start_s_ = cycle.plan().lift_start_s();
  const double before_s = last_s_;
  lift_started_ = time_s >= lift_start_s_;
  last_s_ = std::min(time_s, lift_start_s_);
  const double share = time_s > before_s ? (last_s_ - before_s) / (time_s - before_s) : 1.0;
  bool is_touched = false;
  for (std::size_t f = 0; f < finger_count_; ++f) {
    Finger& own = finger_[f];
    follow(finger[f], own);
    if (!(own.first_touch_s < kNever)) continue;
    is_touched = true;
    const double before_N = own.force_N.empty() ? 0.0 : own.force_N.back();
    own.force_N.push_back(before_N + share * (finger[f].force_N - before_N));
    own.lift_force_N = own.force_N.back();
  }
  if (is_touched) time_s_.push_back(last_s_);
}

/// A contact that comes or goes without a time of its own does so at the end of the step.
void ContactTransition::follow(const TouchObservation& now, Finger& finger) const {
  const bool touched = finger.first_touch_s < kNever && !(finger.left_s < kNever);
  if (now.touches == touched) return;
  const double own_s = now.touches ? now.touched_s : now.left_s;
  const double at_s = std::min(own_s < kNever ? own_s : last_s_, lift_start_s_);
  if (!now.touches) {
    if (at_s >= lift_start_s_) return;
    ++finger.rebounds;
    finger.left_s = at_s;
  } else if (finger.left_s < kNever) {
    finger.loss_s += std::max(0.0, at_s - finger.left_s);
    finger.left_s = kNever;
  } else {
    finger.first_touch_s = at_s;
  }
}

double ContactTransition::loss_s(const Finger& finger) const {
  return finger.loss_s + (finger.left_s < kNever ? std::max(0.0, last_s_ - finger.left_s) : 0.0);
}

/// From the first touch to where the force comes into the band for the last time, straight lines between the ends
/// of steps.
double ContactTransition::steady_s(const Finger& finger) const {
  const double goal_N = finger.lift_force_N, band_N = kSteadyForce * goal_N;
  if (!lift_started_ || !(goal_N > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t offset = time_s_.size() - finger.force_N.size();
  std::size_t steady = finger.force_N.size() - 1;
  while (steady > 0 && std::abs(finger.force_N[steady - 1] - goal_N) <= band_N) --steady;
  const bool is_first = steady == 0;
  const double before_s = is_first ? finger.first_touch_s : time_s_[offset + steady - 1];
  const double before_N = is_first ? 0.0 : finger.force_N[steady - 1], after_N = finger.force_N[steady];
  const double edge_N = goal_N + std::copysign(band_N, before_N - goal_N);
  const double share =
      before_N == after_N ? 1.0 : std::clamp((edge_N - before_N) / (after_N - before_N), 0.0, 1.0);
  return std::max(0.0, before_s + share * (time_s_[offset + steady] - before_s) - finger.first_touch_s);
}

void ContactTransition::measure(Metrics& metrics) const {
  double rebounds = 0.0, lost_s = 0.0, steady = 0.0;
  for (const Finger& finger : std::span(finger_).first(finger_count_)) {
    rebounds += finger.rebounds;
    lost_s += loss_s(finger);
    const double own_s = steady_s(finger);
    steady = std::isnan(own_s) ? own_s : std::max(steady, own_s);
  }
  metrics[Metric::contact_rebounds] = rebounds;
  metrics[Metric::contact_loss_s] = lost_s;
  metrics[Metric::time_to_steady_force_s] = steady;
}

}  // namespace unbruised
