#pragma once

/// @file
/// What the runner needs of the simulator, as an interface: `core_simulator` is the real one, tests bring theirs.

#include <memory>
#include <string>
#include <vector>

#include "core/outcome/replay.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/text/value_or.hpp"

namespace unbruised::studies {

/// Scenarios of one factor key; used by one thread at a time (see `LevelSimulation`).
class LaneEngine {
 public:
  using Finished = LevelSimulation::Finished;

  virtual ~LaneEngine() = default;
  virtual void load(int place, const Scenario& scenario) = 0;
  /// Of the scenario that was just loaded.
  virtual void record(int place, const Recording& kept) = 0;
  /// One step; several where half of the work may go to a second thread.
  virtual void step(bool on_two_threads = false) = 0;
  /// How many scenarios the last call of `step` advanced, and in how many batches of lanes, all its steps
  /// together.
  [[nodiscard]] virtual int stepped() const = 0;
  [[nodiscard]] virtual int stepped_batches() const { return 1; }
  /// Results of the places that became free in the last call of `step`.
  [[nodiscard]] virtual const std::vector<Finished>& finished() const = 0;
};

/// What all scenarios of one factor key share; immutable, used by several threads.
class SharedModel {
 public:
  virtual ~SharedModel() = default;
  [[nodiscard]] virtual std::unique_ptr<LaneEngine> make_lanes() const = 0;
};

/// The model (never null), or why there is none of this scenario.
using ModelOrReason = ValueOr<std::shared_ptr<const SharedModel>, std::string>;

class Simulator {
 public:
  virtual ~Simulator() = default;
  /// Scenarios that one step can advance.
  [[nodiscard]] virtual int lane_count() const = 0;
  /// Scenarios that lanes of one maker can hold, `lane_count()` or more.
  [[nodiscard]] virtual int place_count() const = 0;
  [[nodiscard]] virtual std::string factor_key(const Scenario& scenario) const = 0;
  /// Simulated time that a scenario takes, about [s].
  [[nodiscard]] virtual double duration_s(const Scenario& scenario) const = 0;
  [[nodiscard]] virtual ModelOrReason build(const Scenario& scenario) const = 0;
};

/// The simulator of core/.
const Simulator& core_simulator();

}  // namespace unbruised::studies
