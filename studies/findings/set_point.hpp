#pragma once

/// @file
/// The force to type into the robot: where in a grip window the setting leaves the most room to both ends, what
/// the gripper can set and how exactly taken off (docs/metrics.md, "The set-point").

#include <string>
#include <string_view>

#include "core/scenario/scenario.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// Forces that are known to hold the product and leave it unmarked.
struct SafeForces {
  bool exists = false;
  /// > 0; the upper end of F_hold's bracket, the lower one of F_damage's: the safe sides
  double least_N = kAbsent;
  /// >= least_N; NaN where nobody looked at damage
  double greatest_N = kAbsent;
};

/// What a gripper can set.
struct ForceSetting {
  /// >= 0
  double min_N = 0.0;
  /// >= min_N; infinite: no limit
  double max_N = 0.0;
  /// >= 0, < 1; the force that acts lies within (1 +- accuracy) x the setting
  double accuracy = 0.0;
  /// >= 0; settings are multiples of it; 0: any
  double step_N = 0.0;
};
ForceSetting force_setting(const ParallelJawParameters& gripper);

struct SetPoint {
  bool exists = false;
  double force_N = kAbsent;
  /// The setting may be off by this either way, the gripper's accuracy on top; rounded down to two digits.
  double tolerance_N = kAbsent;
  /// "set 2.4 N, may be off by 0.8 N either way", or why there is none.
  std::string sentence;
};

/// The setting s that makes the smaller of the two margins (1 - a) s / least and greatest / ((1 + a) s) as large
/// as it can be, s = sqrt(least greatest / (1 - a^2)), moved into [min, max], then rounded to the roundest number
/// (1, 2 or 5 times a power of ten, a multiple of the step) that gives up no more than a fifth of that margin.
/// Does not exist where the window does not, has no upper end because damage is not judged, lies outside what the
/// gripper can hold, is narrower than the accuracy, or no multiple of the step lies inside; the sentence says
/// which.
SetPoint set_point(const SafeForces& window, const ForceSetting& gripper);

/// Is the gripper the reason why there is no set-point? @param sentence of a set_point
bool blames_gripper(std::string_view sentence);

}  // namespace unbruised::studies
