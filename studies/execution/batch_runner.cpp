#include "studies/execution/batch_runner.hpp"

#include <memory>
#include <semaphore>

#include "studies/execution/answer_recorder.hpp"

namespace unbruised::studies {

BatchReport run_batch(const Executor& executor, const Batch& batch, const ResultSink& sink) {
  std::counting_semaphore<> room(static_cast<std::ptrdiff_t>(kResultsWaitingMost));
  std::unique_ptr<Work> work;
  AnswerRecorder recorder([&](const ScenarioRow& row) { sink(row.id, row.result); },
                          [&] {
                            work->abort();
                            room.release(static_cast<std::ptrdiff_t>(batch.ids.size()));  // nobody waits any more
                          });
  const ResultSink put = [&](std::uint64_t id, const ScenarioResult& result) {
    room.acquire();
    recorder.put({.row = {.id = id, .result = result, .inputs = {}}, .hand_out = [&room] { room.release(); }});
  };
  work = executor.begin({.scenario = batch.scenario,
                         .sink = put,
                         .curve = batch.curve,
                         .stop = batch.stop,
                         .supply = Supply::at_once});
  work->add(batch.ids);
  work->close();
  const WorkReport done = work->run();
  recorder.finish();
  recorder.rethrow_failure();
  return {.group_count = done.group_count,
          .delivered = done.delivered,
          .stopped = done.delivered < batch.ids.size(),
          .lane_use = done.lane_use};
}

}  // namespace unbruised::studies
