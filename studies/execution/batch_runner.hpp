#pragma once

/// @file
/// A fixed set of scenarios on an executor.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "studies/execution/executor.hpp"

namespace unbruised::studies {

/// The scenarios to run.
struct Batch {
  std::vector<std::uint64_t> ids;  ///< each once; begun in this order inside a group
  /// The scenario of an id; called from several threads at once.
  std::function<Scenario(std::uint64_t id)> scenario;
  /// When it becomes true no more scenarios are begun and those in flight are dropped; may be null.
  const std::atomic<bool>* stop = nullptr;
};

struct BatchReport {
  std::size_t group_count = 0;
  std::size_t delivered = 0;
  bool stopped = false;  ///< some scenarios were not run
  LaneUse lane_use;
};

/// Runs a batch; an exception of the sink comes out of it. A model that cannot be built and an exception inside
/// the simulator become `diverged` rows with the cause; the other scenarios go on.
BatchReport run_batch(const Executor& executor, const Batch& batch, const ResultSink& sink);

}  // namespace unbruised::studies
