#include "studies/execution/batch_runner.hpp"

#include <memory>

namespace unbruised::studies {

BatchReport run_batch(const Executor& executor, const Batch& batch, const ResultSink& sink) {
  const std::unique_ptr<Work> work =
      executor.begin({.scenario = batch.scenario, .sink = sink, .stop = batch.stop, .supply = Supply::at_once});
  work->add(batch.ids);
  work->close();
  const WorkReport done = work->run();
  return {.group_count = done.group_count,
          .delivered = done.delivered,
          .stopped = done.delivered < batch.ids.size(),
          .lane_use = done.lane_use};
}

}  // namespace unbruised::studies
