#pragma once

/// @file
/// An executor without lanes, threads or a simulator: it answers with a formula, in an order of its own, so that
/// what stands above the seam can be tested alone.

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "studies/execution/executor.hpp"

namespace unbruised::studies::testing {

using Formula = std::function<ScenarioResult(const Scenario&)>;

/// The last that was handed in comes first.
class FakeWork final : public Work {
 public:
  FakeWork(WorkOrder order, Formula formula, std::atomic<int>& runs)
      : order_(std::move(order)), formula_(std::move(formula)), runs_(runs) {}

  void add(std::span<const std::uint64_t> ids) override {
    const std::lock_guard lock(mutex_);
    waiting_.insert(waiting_.end(), ids.begin(), ids.end());
    changed_.notify_all();
  }
  void close() override {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }
  void abort() override {
    const std::lock_guard lock(mutex_);
    aborted_ = true;
    changed_.notify_all();
  }

  WorkReport run() override {
    WorkReport report;
    report.group_count = 1;
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return aborted_ || closed_ || !waiting_.empty(); });
      const bool stopped = order_.stop != nullptr && *order_.stop;
      if (aborted_ || stopped || waiting_.empty()) return report;
      const std::uint64_t id = waiting_.back();
      waiting_.pop_back();
      lock.unlock();
      ++runs_;
      order_.sink(id, formula_(order_.scenario(id)));
      ++report.delivered;
      lock.lock();
    }
  }

 private:
  const WorkOrder order_;
  const Formula formula_;
  std::atomic<int>& runs_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::uint64_t> waiting_;
  bool closed_ = false;
  bool aborted_ = false;
};

class FakeExecutor final : public Executor {
 public:
  explicit FakeExecutor(Formula formula) : formula_(std::move(formula)) {}

  [[nodiscard]] std::string group_key(const Scenario&) const override { return "all"; }
  [[nodiscard]] std::unique_ptr<Work> begin(WorkOrder order) const override {
    return std::make_unique<FakeWork>(std::move(order), formula_, runs);
  }
  [[nodiscard]] std::optional<ScenarioResult> run_traced(const Scenario& scenario, Trace& trace,
                                                         const std::atomic<bool>*) const override {
    trace.time_s = {0.0};
    return formula_(scenario);
  }

  mutable std::atomic<int> runs = 0;  ///< scenarios that were really run

 private:
  const Formula formula_;
};

/// Held, with the grip force as its peak force.
inline ScenarioResult force_formula(const Scenario& scenario) {
  ScenarioResult result;
  result.outcome = Outcome::held;
  result.metrics[Metric::peak_finger_force_N] = scenario.strategy.grip_force_N;
  return result;
}

}  // namespace unbruised::studies::testing
