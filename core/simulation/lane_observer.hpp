#pragma once

/// @file
/// What follows a scenario without touching it: outcome, trace, sensors. An observer sees the start, every
/// accepted step and the end of one lane; whoever wants to see more than what it is shown adds it to `LaneView`.

#include <cstdint>

#include "core/motion/handling_cycle.hpp"
#include "core/outcome/handling_record.hpp"
#include "core/scenario/scenario.hpp"
#include "core/sensor/six_axis_instrument.hpp"
#include "core/simulation/lane_view.hpp"

namespace unbruised {

class Balances;

/// One accepted step of one lane; counts and times are those of the present handling. Valid during the call: the
/// lane may be another one in the next.
struct LaneStep {
  int lane = 0;
  std::int64_t count = 0;                         ///< accepted steps so far; 0: the state the scenario starts from
  std::int64_t tick = 0;                          ///< shortest steps of the scenario that they add up to
  double start_s = 0;                             ///< of the step
  double time_s = 0;                              ///< at its end
  double before_s = 0;                            ///< that former handlings of the product took
  std::int64_t ticks_before = 0;                  ///< likewise
  double contact_sweeps = 0, plastic_rounds = 0;  ///< that the step took
  const Scenario& scenario;
  const HandlingCycle& cycle;                   ///< has taken in the step
  const StepObservation& seen;                  ///< at the end of the step
  const LaneView& view;                         ///< at the end of the step
  const Balances& balances;                     ///< likewise
  const SixAxisInstrument* six_axis = nullptr;  ///< null: there is none
};

class LaneObserver {
 public:
  LaneObserver() = default;
  LaneObserver(const LaneObserver&) = delete;
  LaneObserver& operator=(const LaneObserver&) = delete;
  virtual ~LaneObserver() = default;

  /// The scenario is loaded; no step is taken yet.
  virtual void start(const LaneStep& loaded) = 0;
  /// Another handling of the product begins (strategy.repeat); no step of it is taken yet.
  virtual void next_handling(const LaneStep& /*loaded*/) {}
  /// A step is accepted. @return false: it has seen enough, and the run ends
  virtual bool observe(const LaneStep& step) = 0;
  /// The run ends with the step that was observed last; of several handlings the last one's.
  virtual void end(const LaneStep& last) = 0;
};

}  // namespace unbruised
