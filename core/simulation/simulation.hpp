#pragma once

/// @file
/// The simulator's door: an immutable `Model` per factor key, shared by all threads, and a mutable
/// `LaneSimulation` per thread that advances `kLaneCount` scenarios of that key in lockstep.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/contact/compliance_size.hpp"
#include "core/outcome/outcome.hpp"
#include "core/outcome/replay.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/factor_key.hpp"
#include "core/scenario/rules.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Scenarios that advance together; every scenario, alone or not, runs in a batch of this width.
int lane_count();

/// What a model will cost, known without factoring it.
struct ModelSize {
  std::size_t particle_count = 0;
  std::size_t freedom_count = 0;
  std::size_t contact_candidate_count = 0;
  std::size_t contact_node_count = 0;  ///< particles with such a candidate
  /// Of the compliance of these particles under forces on each other.
  [[nodiscard]] double compliance_bytes() const { return unbruised::compliance_bytes(contact_node_count); }
};
ModelSize model_size(const Scenario& scenario);

/// The part that all scenarios of one factor key share: particles, springs, the factored effective
/// stiffness, the compliance of the contact freedoms. Immutable after construction.
class Model {
 public:
  /// Assembles and factors. Returns nullptr and sets `error` when the matrix cannot be factored.
  static std::shared_ptr<const Model> build(const Scenario& scenario, std::string& error);
  ~Model();

  [[nodiscard]] std::size_t particle_count() const;
  [[nodiscard]] std::size_t freedom_count() const;
  [[nodiscard]] std::size_t contact_candidate_count() const;
  [[nodiscard]] std::size_t factor_entry_count() const;  ///< entries of L
  [[nodiscard]] double max_frequency_Hz() const;         ///< Gershgorin bound on the fastest mode

  struct Parts;  ///< defined inside core
  [[nodiscard]] const Parts& parts() const { return *parts_; }

 private:
  Model();
  std::unique_ptr<Parts> parts_;
};

class LaneObserver;  ///< lane_observer.hpp, inside core

/// `lane_count()` scenarios of one factor key advancing in lockstep. A lane's bits never depend on its
/// position, on its neighbours, or on when it was loaded.
class LaneSimulation {
 public:
  explicit LaneSimulation(std::shared_ptr<const Model> model);
  ~LaneSimulation();
  LaneSimulation(const LaneSimulation&) = delete;
  LaneSimulation& operator=(const LaneSimulation&) = delete;

  /// Puts a scenario of this model's factor key into a free lane at its own t = 0.
  void load(int lane, const Scenario& scenario);
  [[nodiscard]] bool busy(int lane) const;
  [[nodiscard]] int busy_count() const;
  /// Adds an observer to the scenario in `lane` (call after load, before the first step).
  void watch(int lane, std::unique_ptr<LaneObserver> observer);
  /// Watches it with what records its full trace; `trace` has to outlive the run.
  void record_trace(int lane, Trace& trace);
  /// And with what keeps what there is to see, a frame every `interval_s`; `replay` has to outlive the run.
  void record_replay(int lane, Replay& replay, double interval_s);

  /// Advances every busy lane by one time step. Lanes that end become free and are returned by `finished`.
  void step();
  struct Finished {
    int lane;
    ScenarioResult result;
  };
  /// Results of the lanes that ended in the last step, in lane order.
  [[nodiscard]] const std::vector<Finished>& finished() const;

  /// Time spent per part, in seconds, for benchmarks.
  struct PartTimes {
    double right_hand_side_s = 0, solve_s = 0, contact_s = 0, plasticity_s = 0, update_s = 0;
    std::uint64_t lane_steps = 0;  ///< busy lanes summed over steps
    std::uint64_t steps = 0;
  };
  /// Measures the parts of every step from now on.
  void enable_timing();
  [[nodiscard]] const PartTimes& part_times() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Runs one scenario alone, in the same kernels as a batch.
/// @param trace filled when not null.
ScenarioResult simulate(const std::shared_ptr<const Model>& model, const Scenario& scenario, Trace* trace);

}  // namespace unbruised
