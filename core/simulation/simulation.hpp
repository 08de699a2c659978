#pragma once

/// @file
/// The simulator's door: an immutable `Model` per factor key, shared by all threads, and a mutable
/// `LevelSimulation` per thread that advances scenarios of that key, each with steps of its own choice, in batches
/// of `lane_count()` in lockstep, a `LaneSimulation` for each length of step.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/contact/compliance_size.hpp"
#include "core/outcome/curve.hpp"
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

/// How the modes of a product stand for it.
struct ModeSummary {
  std::size_t deforming = 0;    ///< beside the six rigid motions
  double fastest_Hz = 0.0;      ///< of those
  double left_out_share = 0.0;  ///< Metric::modes_left_out_share
};

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

  /// Of a product that moves by its modes; none: every particle moves.
  [[nodiscard]] const std::optional<ModeSummary>& modes() const;

  /// The same for steps that are longer by this factor. @param scenario of this factor key
  [[nodiscard]] std::shared_ptr<const Model> with_ticks(int ticks, const Scenario& scenario) const;

  struct Parts;  ///< defined inside core
  [[nodiscard]] const Parts& parts() const { return *parts_; }

 private:
  Model();
  /// @param ticks shortest steps of its scenarios that a step takes @param shorter what scenarios start in; null:
  /// this
  static std::shared_ptr<const Model> build(const Scenario& scenario, std::string& error, int ticks,
                                            const Parts* shorter);
  std::unique_ptr<Parts> parts_;
};

/// What is kept of a run beside its result, where not null; all have to outlive the run.
struct Recording {
  Recording() = default;
  Recording(std::nullptr_t) {}             // NOLINT(google-explicit-constructor): most keep a trace or nothing
  Recording(Trace* kept) : trace(kept) {}  // NOLINT(google-explicit-constructor)
  explicit Recording(Curve* kept) : curve(kept) {}
  Recording(Trace* kept, Replay* seen, double every_s) : trace(kept), replay(seen), replay_interval_s(every_s) {}

  Trace* trace = nullptr;    ///< every row of the full trace
  Curve* curve = nullptr;    ///< force over closure
  Replay* replay = nullptr;  ///< what there is to see, a frame every
  double replay_interval_s = 0.0;
};

class LaneObserver;     ///< lane_observer.hpp, inside core
struct ParkedScenario;  ///< parked_scenario.hpp, inside core

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
  /// Watches it with what records what is asked for.
  void record(int lane, const Recording& kept);

  /// Advances every busy lane by one time step. Lanes that end become free and are returned by `finished`.
  void step();
  struct Finished {
    int lane;
    ScenarioResult result;
  };
  /// Results of the lanes that ended in the last step, in lane order.
  [[nodiscard]] const std::vector<Finished>& finished() const;

  /// How many of the shortest steps of its scenarios a step here is, and the scenario in a lane wants its next one
  /// to be.
  [[nodiscard]] int ticks() const;
  [[nodiscard]] int next_ticks(int lane) const;
  /// From where the scenario in a lane is to the end that its plan has now [s].
  [[nodiscard]] double time_left_s(int lane) const;
  /// Takes a scenario out of its lane between two steps, and puts it into a free one, of this model or the same
  /// for other steps. It goes on as if nothing had happened.
  [[nodiscard]] std::unique_ptr<ParkedScenario> take(int lane);
  void put(int lane, ParkedScenario& parked);

  /// Time spent per part, in seconds, for benchmarks.
  struct PartTimes {
    double right_hand_side_s = 0, solve_s = 0, contact_s = 0, plasticity_s = 0, update_s = 0;
    std::uint64_t lane_steps = 0;  ///< busy lanes summed over steps
    std::uint64_t steps = 0;

    PartTimes& operator+=(const PartTimes& other);
  };
  /// Measures the parts of every step from now on.
  void enable_timing();
  [[nodiscard]] const PartTimes& part_times() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Scenarios of one factor key, each taking the steps that it wants (step_level.hpp): it has a batch for each
/// length of step, and those that no batch has room for wait. A scenario's bits never depend on the others here.
class LevelSimulation {
 public:
  /// Gives the model for longer steps, `Model::with_ticks`; asked once for each.
  using Longer = std::function<std::shared_ptr<const Model>(int ticks, const Scenario& scenario)>;
  /// @param longer of those who share them; none: they are made here
  explicit LevelSimulation(std::shared_ptr<const Model> model, Longer longer = {});
  ~LevelSimulation();
  LevelSimulation(const LevelSimulation&) = delete;
  LevelSimulation& operator=(const LevelSimulation&) = delete;

  /// Puts a scenario of the model's factor key into a free place, from 0 on, at its own t = 0.
  void load(int place, const Scenario& scenario);
  [[nodiscard]] bool busy(int place) const;
  /// As that of LaneSimulation, right after load.
  void record(int place, const Recording& kept);

  /// Advances the scenarios of one batch by one of its steps: the last one while it is full; of the full batches,
  /// or where none is full of all, the one with the scenario that has most time before it.
  void step();
  /// A second thread, and how the two keep out of each other's way.
  struct TwoThreads {
    /// Calls both functions at the same time, and returns when both have ended, or throws what one has thrown.
    std::function<void(std::function<void()>, const std::function<void()>&)> both;
    /// Calls the function while the other thread is in no call of this.
    std::function<void(const std::function<void()>&)> alone;
  };
  /// Two threads at once, each with a batch of its own for some steps; until some scenario has finished, and a
  /// while at most.
  void step(const TwoThreads& threads);
  /// How many scenarios the last call of `step` advanced, and in how many batches: both count each of its steps.
  [[nodiscard]] int stepped() const;
  [[nodiscard]] int stepped_batches() const;
  struct Finished {
    int place;
    ScenarioResult result;
  };
  /// Results of the places that became free in the last call of `step`.
  [[nodiscard]] const std::vector<Finished>& finished() const;

  void enable_timing();
  /// Of all batches together.
  [[nodiscard]] LaneSimulation::PartTimes part_times() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Scenarios that are worth holding in one LevelSimulation: where they are spread over the step lengths, the batch
/// with most to do is full.
int level_place_count();

/// Runs one scenario alone, in the same kernels as a batch.
/// @param trace filled when not null.
ScenarioResult simulate(const std::shared_ptr<const Model>& model, const Scenario& scenario, Trace* trace);

}  // namespace unbruised
