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

/// Lanes that advance together; used by one thread at a time (see `LaneSimulation`).
class LaneEngine {
 public:
  virtual ~LaneEngine() = default;
  virtual void load(int lane, const Scenario& scenario) = 0;
  virtual void record_trace(int lane, Trace& trace) = 0;
  /// A frame every `interval_s`; lanes of tests have nothing to see.
  virtual void record_replay(int /*lane*/, Replay& /*replay*/, double /*interval_s*/) {}
  virtual void step() = 0;
  /// Results of the lanes that ended in the last step, in lane order.
  [[nodiscard]] virtual const std::vector<LaneSimulation::Finished>& finished() const = 0;
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
  [[nodiscard]] virtual int lane_count() const = 0;
  [[nodiscard]] virtual std::string factor_key(const Scenario& scenario) const = 0;
  [[nodiscard]] virtual ModelOrReason build(const Scenario& scenario) const = 0;
};

/// The simulator of core/.
const Simulator& core_simulator();

}  // namespace unbruised::studies
