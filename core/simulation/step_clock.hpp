#pragma once

/// @file
/// How time goes on in the steps of one level.

namespace unbruised {

/// Times are whole numbers of the shortest step, whatever the steps in between.
struct StepClock {
  double tick_s = 0.0;  ///< the shortest step
  int ticks = 1;        ///< of a step
  double theta = 1.4;

  [[nodiscard]] double step_s() const { return static_cast<double>(ticks) * tick_s; }
};

}  // namespace unbruised
