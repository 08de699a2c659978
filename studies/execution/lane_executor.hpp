#pragma once

/// @file
/// This process as an executor: scenarios in lanes, over threads (lane_scheduler.hpp).

#include <memory>
#include <optional>
#include <string>

#include "studies/execution/executor.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

class LaneExecutor final : public Executor {
 public:
  /// @param simulator must outlive it. @param threads > 0
  LaneExecutor(const Simulator& simulator, int threads) : simulator_(simulator), threads_(threads) {}

  [[nodiscard]] std::string group_key(const Scenario& scenario) const override {
    return simulator_.factor_key(scenario);
  }
  [[nodiscard]] std::unique_ptr<Work> begin(WorkOrder order) const override;
  [[nodiscard]] std::optional<ScenarioResult> run_traced(const Scenario& scenario, Trace& trace,
                                                         const std::atomic<bool>* stop) const override;

 private:
  const Simulator& simulator_;
  const int threads_;
};

}  // namespace unbruised::studies
