#pragma once

/// @file
/// The inside of a lane simulation.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/door/require.hpp"
#include "core/lanes/part_timer.hpp"
#include "core/simulation/balances.hpp"
#include "core/simulation/initial_state.hpp"
#include "core/simulation/lane_run.hpp"
#include "core/simulation/lane_view.hpp"
#include "core/simulation/parked_scenario.hpp"

namespace unbruised {

struct LaneSimulation::Impl {
  explicit Impl(std::shared_ptr<const Model> shared);

  void load(int lane, const Scenario& scenario);
  /// Begins the scenario of a lane, or the next handling of its product.
  /// @param worn what the material was at the end of the last; null: it is the first
  void begin(int lane, LaneContent* worn);
  std::vector<double> wear(int lane, LaneContent* worn, const std::vector<double>& mounted_N);
  void begin_next_handling(int lane);
  void set_up(int lane, const LaneRun& r);
  void archive(LaneArchive& lane);
  std::unique_ptr<ParkedScenario> take(int lane);
  void put(int lane, ParkedScenario& parked);
  [[gnu::noinline]] void step();  // arithmetic stays within what LaneSimulation::step sets for it

  // The parts of a step, in order.
  void follow_plans();
  SupportPlane choose_support(int lane);
  void add_loads();
  void solve_step();
  void solve_contacts_and_product(const Mask& lanes);
  void advance_state();
  void observe_lanes();

  void abort_lanes(const Mask& lanes, const char* cause);
  void tell_cycle(int lane, double start_s, double time_s);
  void read_instruments(int lane, double start_s, double time_s);
  [[nodiscard]] StepObservation see(int lane, double time_s);
  void watch(int lane, std::unique_ptr<LaneObserver> observer);
  /// Where a lane is, without what its last step took.
  [[nodiscard]] LaneStep present(int lane, const StepObservation& seen);
  void observe_lane(int lane);
  void choose_level(const LaneStep& step);
  void finish(const LaneStep& last);
  /// Null: a lane has none.
  [[nodiscard]] static const SixAxisInstrument* six_axis(const LaneRun& run) {
    return run.six_axis ? &*run.six_axis : nullptr;
  }
  /// Null: no surface of any lane is on a mount.
  [[nodiscard]] const MountLanes* mount() const { return mounts.any() ? &mounts : nullptr; }
  /// Null: the pads are layers.
  [[nodiscard]] const PadLanes* padded() const { return pads ? &*pads : nullptr; }
  [[nodiscard]] LaneRun& run_of(int lane) {
    require(is_lane(lane), "LaneSimulation: there is no such lane");
    return run[static_cast<std::size_t>(lane)];
  }

  std::shared_ptr<const Model> model;
  const Model::Parts& parts;
  const WilsonTheta& w;
  const StepClock& clock;

  std::array<LaneRun, kLanes> run;
  Mask running{false};
  std::vector<Finished> finished;
  std::size_t numbers_of_lane = 0;  ///< that was taken out last

  InitialStates initial;
  std::unique_ptr<BodyMotion> own_body;
  BodyMotion& body;
  std::unique_ptr<Material> material;
  ContactLanes contact;
  GripperLanes gripper;
  MountLanes mounts;
  CarrierMotion now, theta, next;
  DriveCommand command;
  Balances balances;
  std::array<Lane, kSurfaceCount> yield_ratio;  ///< of each surface
  std::optional<PadLanes> pads;                 ///< where these are bodies
  LaneView view;

  LaneArray base;  ///< displacement without contact forces at the contact nodes
  Lane sweeps{0.0}, rounds{0.0};
  Lane yield_stress{1.0};  ///< of the product; 1 where it has none and the ratio is not asked for

  bool timing = false;
  PartTimer timer{false};  ///< one for all parts: every moment of a step is counted once
  PartTimes times;
};

}  // namespace unbruised
