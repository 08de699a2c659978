#pragma once

/// @file
/// How a palm really goes where what carries it gives way.

#include <array>
#include <vector>

#include "core/motion/palm_path.hpp"

namespace unbruised {

/// Known at even steps of time. Between two of them place and rotation are polynomials of fifth degree with the
/// place, velocity and acceleration of both: the acceleration is continuous.
class PalmTrack {
 public:
  /// @param knot at least one; about the turn between two of them see docs/robot.md: it is small
  PalmTrack(double start_s, double step_s, std::vector<PalmState> knot);

  [[nodiscard]] double start_s() const { return start_s_; }
  /// As at the first knot before the start, at rest where the last knot is after the end.
  [[nodiscard]] PalmState at(double time_s) const;

 private:
  double start_s_, step_s_;
  std::vector<PalmState> knot_;
};

}  // namespace unbruised
