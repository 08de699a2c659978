#pragma once

/// @file
/// One lane's scenario, its clock, and who follows it.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/integration/wilson_theta.hpp"
#include "core/motion/handling_cycle.hpp"
#include "core/scenario/scenario.hpp"
#include "core/sensor/finger_instruments.hpp"
#include "core/sensor/six_axis_instrument.hpp"
#include "core/simulation/outcome_observer.hpp"

namespace unbruised {

struct LaneRun {
  bool busy = false;
  Scenario scenario;
  HandlingCycle cycle;
  std::optional<FingerInstruments> instruments;          ///< where there is something to read
  std::optional<SixAxisInstrument> six_axis;             ///< likewise
  std::int64_t step = 0;                                 ///< steps taken
  SupportPlane plane = SupportPlane::start;              ///< under the product
  OutcomeObserver* outcome = nullptr;                    ///< one of the observers
  std::vector<std::unique_ptr<LaneObserver>> observers;  ///< in the order in which they see a step

  /// t and t + theta dt of the next step, and its end [s].
  [[nodiscard]] double time_s(const WilsonTheta& w) const { return static_cast<double>(step) * w.dt; }
  [[nodiscard]] double theta_time_s(const WilsonTheta& w) const { return time_s(w) + w.theta * w.dt; }
  [[nodiscard]] double end_time_s(const WilsonTheta& w) const { return static_cast<double>(step + 1) * w.dt; }
};

}  // namespace unbruised
