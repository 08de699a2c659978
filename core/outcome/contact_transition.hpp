#pragma once

/// @file
/// How a grip goes over from free motion to contact: whether the fingers bounce, and when their force is steady
/// (docs/metrics.md).

#include <array>
#include <span>
#include <vector>

#include "core/motion/handling_cycle.hpp"
#include "core/outcome/outcome.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// What of one finger a step shows.
struct TouchObservation {
  bool touches = false;
  double touched_s = kNever;  ///< when it came to touch within the step
  double left_s = kNever;     ///< when it left within it
  double force_N = 0;         ///< at the end of the step
};

/// A finger's force is steady within this part of what it is as the lift starts.
inline constexpr double kSteadyForce = 0.05;

class ContactTransition {
 public:
  /// Takes in the step that ended at `time_s`, of every finger. Nothing after the start of the lift counts.
  void observe(double time_s, std::span<const TouchObservation> finger, const HandlingCycle& cycle);
  /// Fills the metrics of a scenario with a gripper; a run that ends before the lift has no steady force.
  void measure(Metrics& metrics) const;

 private:
  struct Finger {
    double first_touch_s = kNever;
    double left_s = kNever;  ///< since when it does not touch
    int rebounds = 0;
    double loss_s = 0;              ///< over the times that it was away and came back
    std::vector<double> force_N{};  ///< at the ends of the steps since the first touch, beginning with 0 at it
    double lift_force_N = 0;
  };
  void follow(const TouchObservation& now, Finger& finger) const;
  [[nodiscard]] double loss_s(const Finger& finger) const;
  [[nodiscard]] double steady_s(const Finger& finger) const;

  std::array<Finger, kMostFingers> finger_;
  std::size_t finger_count_ = 0;
  std::vector<double> time_s_;  ///< of the steps since the first touch of any finger
  double last_s_ = 0;           ///< end of the last step that counted, at most the start of the lift
  double lift_start_s_ = kNever;
  bool lift_started_ = false;
};

}  // namespace unbruised
