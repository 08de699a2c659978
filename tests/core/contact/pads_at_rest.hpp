#pragma once

/// @file
/// What pads have come to when a trace of a grip ends.

#include <cmath>
#include <vector>

#include "core/scenario/opening.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

inline double last_of(const Trace& trace, const char* name, std::size_t at = 0) {
  const std::vector<double> values = column(trace, name, at);
  return values.empty() ? std::nan("") : values.back();
}

/// How far each pad is past the undeformed product; expects the grip force of the scenario.
/// @param tolerance of that force
inline double approach_at_rest_m(const Trace& trace, const Scenario& scenario, double tolerance) {
  const double force_N = scenario.strategy.grip_force_N;
  EXPECT_NEAR(last_of(trace, "finger_force_N"), force_N, tolerance * force_N) << "at rest";
  return 0.5 * (last_of(trace, "finger_way_m", 0) + last_of(trace, "finger_way_m", 1)) - approach_gap_m(scenario);
}

}  // namespace unbruised::testing
