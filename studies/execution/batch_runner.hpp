#pragma once

/// @file
/// Evaluates a fixed set of scenarios: grouped by factor key, in lanes, over threads (lane_scheduler.hpp).

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/execution/lane_scheduler.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

/// The scenarios to run.
struct Batch {
  std::vector<std::uint64_t> ids;  ///< each once; handed out in this order inside a group
  /// The scenario of an id; called from several threads at once.
  std::function<Scenario(std::uint64_t id)> scenario;
};

struct BatchOptions {
  /// > 0
  int threads = 1;
  /// When it becomes true no more scenarios are handed out and those in flight are dropped; may be null.
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
BatchReport run_batch(const Simulator& simulator, const Batch& batch, const BatchOptions& options,
                      const ResultSink& sink);

/// Runs one scenario alone, in the same kernels as a batch.
/// @param trace filled when not null. @param stop may be null.
/// @return nothing when stopped; a `diverged` result with the cause where there is no model or an exception.
std::optional<ScenarioResult> run_alone(const Simulator& simulator, const Scenario& scenario, Trace* trace,
                                        const std::atomic<bool>* stop);

}  // namespace unbruised::studies
