#pragma once

/// @file
/// The seam between what a study wants to know and where scenarios are run: an order of scenarios goes to an
/// executor, which knows of lanes, threads and machines so that nobody else has to. This process is one
/// (lane_executor.hpp).

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/outcome/curve.hpp"
#include "core/outcome/outcome.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

/// Takes each result once; calls are serialised. An exception ends all work and comes out of `Work::run`.
using ResultSink = std::function<void(std::uint64_t id, const ScenarioResult& result)>;

/// How full the lanes were.
struct LaneUse {
  std::uint64_t busy_lane_steps = 0;  ///< steps of scenarios
  std::uint64_t lane_steps = 0;       ///< steps x lanes, empty ones included

  /// 0..1; 1 where nothing ran.
  [[nodiscard]] double occupancy() const {
    return lane_steps == 0 ? 1.0 : static_cast<double>(busy_lane_steps) / static_cast<double>(lane_steps);
  }
  void add(const LaneUse& other) {
    busy_lane_steps += other.busy_lane_steps;
    lane_steps += other.lane_steps;
  }
};

/// Is all that will be asked for known when the work starts, or does more come while some is done?
enum class Supply { at_once, growing };

/// Scenarios to run.
struct WorkOrder {
  /// The scenario of an id; called from several threads at once, more than once per id.
  std::function<Scenario(std::uint64_t id)> scenario;
  ResultSink sink;
  /// Where the curve of a scenario goes, filled when its result is delivered; nothing: no curves are wanted.
  std::function<Curve&(std::uint64_t id)> curve = {};
  /// When it becomes true no more scenarios are begun and those in flight are dropped; may be null.
  const std::atomic<bool>* stop = nullptr;
  Supply supply = Supply::at_once;
};

struct WorkReport {
  std::size_t group_count = 0;  ///< sets of scenarios with equal keys
  std::size_t delivered = 0;
  LaneUse lane_use;
};

/// An order being carried out.
class Work {
 public:
  virtual ~Work() = default;
  /// Hands in scenarios, each id once. Thread-safe.
  virtual void add(std::span<const std::uint64_t> ids) = 0;
  /// Nothing will be added any more. Thread-safe.
  virtual void close() = 0;
  /// Drops what is in flight and begins nothing more. Thread-safe.
  virtual void abort() = 0;
  /// Carries the order out; returns when it is closed and everything is delivered, or when it is stopped or
  /// aborted. Throws what the sink threw.
  virtual WorkReport run() = 0;
};

class Executor {
 public:
  virtual ~Executor() = default;
  /// Scenarios with equal keys are cheapest when they are asked for together.
  [[nodiscard]] virtual std::string group_key(const Scenario& scenario) const = 0;
  /// The order must not outlive the executor.
  [[nodiscard]] virtual std::unique_ptr<Work> begin(WorkOrder order) const = 0;
  /// Runs one scenario alone, with the bits that it has in any company. @param stop may be null.
  /// @return nothing when stopped; a `diverged` result with the cause where it cannot be run.
  [[nodiscard]] virtual std::optional<ScenarioResult> run_traced(const Scenario& scenario, Trace& trace,
                                                                 const std::atomic<bool>* stop) const = 0;
};

}  // namespace unbruised::studies
