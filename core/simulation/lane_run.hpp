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
#include "core/simulation/step_level.hpp"

namespace unbruised {

struct LaneRun {
  bool busy = false;
  Scenario scenario;
  HandlingCycle cycle;
  std::optional<FingerInstruments> instruments;          ///< where there is something to read
  std::optional<SixAxisInstrument> six_axis;             ///< likewise
  std::int64_t step = 0;                                 ///< steps taken
  std::int64_t tick = 0;                                 ///< shortest steps of the scenario that they add up to
  LevelChoice level;                                     ///< of the coming step
  SupportPlane plane = SupportPlane::start;              ///< under the product
  double before_s = 0.0;                                 ///< that former handlings took
  std::int64_t ticks_before = 0;                         ///< likewise
  bool again_due = false;                                ///< a handling has ended, and the next one is to begin
  OutcomeObserver* outcome = nullptr;                    ///< one of the observers
  std::vector<std::unique_ptr<LaneObserver>> observers;  ///< in the order in which they see a step

  /// t and t + theta dt of the next step, and its end [s].
  [[nodiscard]] double time_s(const StepClock& clock) const { return static_cast<double>(tick) * clock.tick_s; }
  [[nodiscard]] double theta_time_s(const StepClock& clock) const {
    return time_s(clock) + clock.theta * clock.step_s();
  }
  [[nodiscard]] double end_time_s(const StepClock& clock) const {
    return static_cast<double>(tick + clock.ticks) * clock.tick_s;
  }
};

}  // namespace unbruised
