#pragma once

/// @file
/// A simulator whose results are a formula of the scenario, and whose runs take different numbers of steps, so
/// that searches meet every possible timing.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "studies/execution/simulator.hpp"

namespace unbruised::studies::testing {

using Formula = std::function<ScenarioResult(const Scenario&)>;

inline constexpr int kFormulaLanes = 4;

class FormulaLanes final : public LaneEngine {
 public:
  explicit FormulaLanes(const Formula& formula) : formula_(formula) {}
  void load(int lane, const Scenario& scenario) override {
    Slot& slot = slots_.at(static_cast<std::size_t>(lane));
    slot.result = formula_(scenario);
    // Between 1 and 7 steps, by the bits of the grip force.
    const double force_N = scenario.strategy.grip_force_N;
    slot.steps_left = 1 + static_cast<int>(static_cast<std::uint64_t>(force_N * 1e9) % 7U);
  }
  void record(int, const Recording&) override {}
  void step(bool /*on_two_threads*/) override {
    finished_.clear();
    stepped_ = 0;
    for (int lane = 0; lane < kFormulaLanes; ++lane) {
      Slot& slot = slots_[static_cast<std::size_t>(lane)];
      if (slot.result) ++stepped_;
      if (!slot.result || --slot.steps_left > 0) continue;
      finished_.push_back({lane, *slot.result});
      slot.result.reset();
    }
    std::this_thread::yield();
  }
  int stepped() const override { return stepped_; }
  const std::vector<Finished>& finished() const override { return finished_; }

 private:
  struct Slot {
    std::optional<ScenarioResult> result;
    int steps_left = 0;
  };
  const Formula& formula_;
  std::vector<Slot> slots_ = std::vector<Slot>(kFormulaLanes);
  std::vector<Finished> finished_;
  int stepped_ = 0;
};

class FormulaModel final : public SharedModel {
 public:
  explicit FormulaModel(const Formula& formula) : formula_(formula) {}
  std::unique_ptr<LaneEngine> make_lanes() const override { return std::make_unique<FormulaLanes>(formula_); }

 private:
  const Formula& formula_;
};

class FormulaSimulator final : public Simulator {
 public:
  explicit FormulaSimulator(Formula formula) : formula_(std::move(formula)) {}
  int lane_count() const override { return kFormulaLanes; }
  int place_count() const override { return kFormulaLanes; }
  double duration_s(const Scenario&) const override { return 0.0; }
  std::string factor_key(const Scenario& scenario) const override { return unbruised::factor_key(scenario); }
  ModelOrReason build(const Scenario&) const override {
    return std::shared_ptr<const SharedModel>(std::make_shared<FormulaModel>(formula_));
  }

 private:
  Formula formula_;
};

/// A held scenario with these metrics.
inline ScenarioResult held_with(std::initializer_list<std::pair<Metric, double>> metrics) {
  ScenarioResult result;
  result.outcome = Outcome::held;
  for (const auto& [metric, value] : metrics) result.metrics[metric] = value;
  return result;
}

}  // namespace unbruised::studies::testing
