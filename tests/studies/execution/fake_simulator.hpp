#pragma once

/// @file
/// A simulator whose results are known: a scenario runs for a number of steps that its duration gives, and ends
/// with metrics computed from its grip force alone.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "studies/execution/batch_runner.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies::testing {

inline constexpr int kFakeLanes = 4;

/// What the fakes were asked to do, and what they saw.
struct FakeRecord {
  std::atomic<int> models_built = 0;
  std::atomic<int> models_alive = 0;
  std::atomic<int> most_models_alive = 0;
  std::atomic<int> lane_simulations = 0;
  std::atomic<long> steps = 0, steps_on_two_threads = 0;
  std::atomic<int> most_lanes_busy = 0;
};

/// Grip forces that make the fake misbehave.
struct FakeFaults {
  std::optional<double> throws_in_step_at_N;
  std::optional<double> throws_in_load_at_N;
  std::optional<double> no_model_of_modulus_Pa;
  bool no_lanes = false;
};

/// What a scenario with this grip force leaves, whatever ran beside it.
inline ScenarioResult fake_result(const Scenario& scenario) {
  ScenarioResult result;
  result.outcome = Outcome::held;
  result.metrics[Metric::cycle_time_s] = std::sin(scenario.strategy.grip_force_N);
  result.metrics[Metric::peak_finger_force_N] = scenario.strategy.grip_force_N;
  result.metrics[Metric::compression_max_m] = std::get<LatticeParameters>(scenario.product).youngs_modulus_Pa;
  return result;
}

class FakeLanes final : public LaneEngine {
 public:
  FakeLanes(FakeRecord& record, const FakeFaults& faults) : record_(record), faults_(faults) {
    if (faults.no_lanes) throw std::bad_alloc();
    ++record_.lane_simulations;
  }

  void load(int lane, const Scenario& scenario) override {
    if (scenario.strategy.grip_force_N == faults_.throws_in_load_at_N)
      throw std::runtime_error("cannot load this");
    Slot& slot = slots_.at(static_cast<std::size_t>(lane));
    if (slot.scenario) throw std::logic_error("the lane is busy");
    slot.scenario = scenario;
    slot.steps_left = static_cast<int>(scenario.simulation.duration_s.value_or(1.0));
    int busy = 0;
    for (const Slot& each : slots_) busy += each.scenario ? 1 : 0;
    int most = record_.most_lanes_busy;
    while (busy > most && !record_.most_lanes_busy.compare_exchange_weak(most, busy)) {
    }
  }

  void record(int, const Recording& kept) override {
    if (kept.trace != nullptr) kept.trace->time_s = {0.0};
  }

  void step(bool on_two_threads) override {
    ++record_.steps;
    if (on_two_threads) ++record_.steps_on_two_threads;
    finished_.clear();
    stepped_ = 0;
    for (int lane = 0; lane < kFakeLanes; ++lane) {
      Slot& slot = slots_[static_cast<std::size_t>(lane)];
      if (!slot.scenario) continue;
      ++stepped_;
      if (slot.scenario->strategy.grip_force_N == faults_.throws_in_step_at_N) throw std::bad_alloc();
      if (--slot.steps_left > 0) continue;
      finished_.push_back({lane, fake_result(*slot.scenario)});
      slot.scenario.reset();
    }
    std::this_thread::yield();
  }

  int stepped() const override { return stepped_; }
  const std::vector<Finished>& finished() const override { return finished_; }

 private:
  struct Slot {
    std::optional<Scenario> scenario;
    int steps_left = 0;
  };
  FakeRecord& record_;
  const FakeFaults& faults_;
  std::vector<Slot> slots_ = std::vector<Slot>(kFakeLanes);
  std::vector<Finished> finished_;
  int stepped_ = 0;
};

class FakeModel final : public SharedModel {
 public:
  FakeModel(FakeRecord& record, const FakeFaults& faults) : record_(record), faults_(faults) {
    ++record_.models_built;
    const int alive = ++record_.models_alive;
    int most = record_.most_models_alive;
    while (alive > most && !record_.most_models_alive.compare_exchange_weak(most, alive)) {
    }
  }
  ~FakeModel() override { --record_.models_alive; }
  std::unique_ptr<LaneEngine> make_lanes() const override { return std::make_unique<FakeLanes>(record_, faults_); }

 private:
  FakeRecord& record_;
  const FakeFaults& faults_;
};

class FakeSimulator final : public Simulator {
 public:
  mutable FakeRecord record;
  FakeFaults faults;

  int lane_count() const override { return kFakeLanes; }
  int place_count() const override { return kFakeLanes; }
  double duration_s(const Scenario&) const override { return 0.0; }
  std::string factor_key(const Scenario& scenario) const override { return std::to_string(modulus(scenario)); }
  ModelOrReason build(const Scenario& scenario) const override {
    if (modulus(scenario) == faults.no_model_of_modulus_Pa) return std::string("the matrix cannot be factored");
    return std::shared_ptr<const SharedModel>(std::make_shared<FakeModel>(record, faults));
  }

 private:
  static double modulus(const Scenario& scenario) {
    return std::get<LatticeParameters>(scenario.product).youngs_modulus_Pa;
  }
};

/// `groups` factor keys of `per_group` scenarios, mixed, with durations of 1 to 7 steps.
inline Scenario scenario_of(std::uint64_t id, std::uint64_t groups) {
  Scenario scenario;
  std::get<LatticeParameters>(scenario.product).youngs_modulus_Pa = 1e6 + static_cast<double>(id % groups);
  scenario.strategy.grip_force_N = 1.0 + static_cast<double>(id);
  scenario.simulation.duration_s = static_cast<double>(1 + (id * 5) % 7);
  return scenario;
}

inline Batch batch_of(std::uint64_t count, std::uint64_t groups) {
  Batch batch;
  for (std::uint64_t id = 0; id < count; ++id) batch.ids.push_back(id);
  batch.scenario = [groups](std::uint64_t id) { return scenario_of(id, groups); };
  return batch;
}

}  // namespace unbruised::studies::testing
