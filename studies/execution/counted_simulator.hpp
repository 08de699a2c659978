#pragma once

/// @file
/// A simulator that tells a Progress about every step its lanes make, so that the time left is known before the
/// first scenario has ended.

#include "studies/execution/progress.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::studies {

/// Answers as the simulator it is made from does, bit by bit.
class CountedSimulator final : public Simulator {
 public:
  /// Both must outlive it and everything it makes.
  CountedSimulator(const Simulator& simulator, Progress& progress) : simulator_(simulator), progress_(progress) {}

  [[nodiscard]] int lane_count() const override { return simulator_.lane_count(); }
  [[nodiscard]] int place_count() const override { return simulator_.place_count(); }
  [[nodiscard]] double duration_s(const Scenario& scenario) const override {
    return simulator_.duration_s(scenario);
  }
  [[nodiscard]] std::string factor_key(const Scenario& scenario) const override {
    return simulator_.factor_key(scenario);
  }
  [[nodiscard]] ModelOrReason build(const Scenario& scenario) const override;

 private:
  const Simulator& simulator_;
  Progress& progress_;
};

}  // namespace unbruised::studies
