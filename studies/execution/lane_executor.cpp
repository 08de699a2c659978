#include "studies/execution/lane_executor.hpp"

#include <utility>

#include "studies/execution/lane_scheduler.hpp"
#include "studies/execution/lone_run.hpp"

namespace unbruised::studies {

std::unique_ptr<Work> LaneExecutor::begin(WorkOrder order) const {
  return std::make_unique<LaneScheduler>(simulator_, std::move(order), threads_);
}

std::optional<ScenarioResult> LaneExecutor::run_traced(const Scenario& scenario, Trace& trace,
                                                       const std::atomic<bool>* stop) const {
  return run_alone(simulator_, scenario, &trace, stop);
}

}  // namespace unbruised::studies
