#pragma once

/// @file
/// One lane's scenario, its clock, and what follows it.

#include <cstdint>

#include "core/integration/wilson_theta.hpp"
#include "core/motion/handling_cycle.hpp"
#include "core/outcome/handling_record.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

struct LaneRun {
  bool busy = false;
  Scenario scenario;
  HandlingCycle cycle;
  HandlingRecord record;
  std::int64_t step = 0;   ///< steps taken
  Trace* trace = nullptr;  ///< to be filled; none where nobody asked
  double contact_sweeps = 0;
  double plastic_rounds = 0;

  /// t and t + theta dt of the next step, and its end [s].
  [[nodiscard]] double time_s(const WilsonTheta& w) const { return static_cast<double>(step) * w.dt; }
  [[nodiscard]] double theta_time_s(const WilsonTheta& w) const { return time_s(w) + w.theta * w.dt; }
  [[nodiscard]] double end_time_s(const WilsonTheta& w) const { return static_cast<double>(step + 1) * w.dt; }
};

}  // namespace unbruised
