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
  /// As WorkOrder::curve.
  std::function<Curve&(std::uint64_t id)> curve = {};
  /// When it becomes true no more scenarios are begun and those in flight are dropped; may be null.
  const std::atomic<bool>* stop = nullptr;
};

struct BatchReport {
  std::size_t group_count = 0;
  std::size_t delivered = 0;
  bool stopped = false;  ///< some scenarios were not run
  LaneUse lane_use;
};

/// Results that may wait for a slow sink; with more of them whoever has the next one waits.
inline constexpr std::size_t kResultsWaitingMost = 1024;

/// Runs a batch. The sink is called on a thread of its own, for one result at a time in the order of arrival:
/// while it writes to a slow disk the others go on. What has arrived is written also where the batch is stopped.
/// An exception of the sink ends the batch and comes out of it. A model that cannot be built and an exception
/// inside the simulator become `diverged` rows with the cause; the other scenarios go on.
BatchReport run_batch(const Executor& executor, const Batch& batch, const ResultSink& sink);

}  // namespace unbruised::studies
