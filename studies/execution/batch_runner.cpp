#include "studies/execution/batch_runner.hpp"

#include <memory>
#include <string>

namespace unbruised::studies {

BatchReport run_batch(const Simulator& simulator, const Batch& batch, const BatchOptions& options,
                      const ResultSink& sink) {
  LaneScheduler scheduler(simulator, batch.scenario, sink, {.threads = options.threads, .stop = options.stop});
  scheduler.add(batch.ids);
  scheduler.close();
  scheduler.run_workers();
  scheduler.rethrow_failure();
  return {.group_count = scheduler.group_count(),
          .delivered = scheduler.delivered(),
          .stopped = scheduler.delivered() < batch.ids.size(),
          .lane_use = scheduler.lane_use()};
}

std::optional<ScenarioResult> run_alone(const Simulator& simulator, const Scenario& scenario, Trace* trace,
                                        const std::atomic<bool>* stop) {
  std::string error;
  const std::shared_ptr<const SharedModel> model = build_model(simulator, scenario, error);
  if (!model) return failed_result(error);
  return run_in_fresh_lanes(*model, scenario, trace, stop);
}

}  // namespace unbruised::studies
