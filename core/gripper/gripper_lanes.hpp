#pragma once

/// @file
/// The gripper of every lane, whatever its kind: what the contact solve, the account of energy and the observers
/// ask of it. Lanes of one batch may hold grippers of different kinds. Each kind has a class of its own that moves
/// all lanes at once (finger_lanes.hpp, the parallel jaw); here their answers become one, lane by lane. No call is
/// virtual: the contact sweep asks in its innermost loop.

#include <array>
#include <concepts>

#include "core/gripper/drive_command.hpp"
#include "core/gripper/finger_lanes.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Normal forces of the contacts on the pad of each finger, per lane [N].
using PadForces = FingerForces;

/// What the lanes of one kind of gripper have to answer. Ways are along the normal of a pad, towards the product.
template <class Kind>
concept MovesPads = requires(const Kind& kind, Kind& moving, int pad, const PadForces& force_N,
                             const WilsonTheta& wilson, const DriveCommand& command, const Mask& running) {
  moving.begin_step(wilson, command);
  moving.advance(wilson, force_N, running);
  // At t + theta dt under these forces, and a bound on d way / d force.
  { kind.way_at_theta(pad, force_N) } -> std::convertible_to<Lane>;
  { kind.compliance() } -> std::convertible_to<Lane>;
  // Now.
  { kind.way(pad) } -> std::convertible_to<Lane>;
  { kind.speed(pad) } -> std::convertible_to<Lane>;
  { kind.acceleration(pad) } -> std::convertible_to<Lane>;
  { kind.closing() } -> std::convertible_to<Lane>;
  { kind.furthest_way() } -> std::convertible_to<Lane>;
  { kind.at_end_of_stroke() } -> std::convertible_to<Mask>;
  // Its account.
  { kind.energy() } -> std::convertible_to<Lane>;
  { kind.work() } -> std::convertible_to<Lane>;
  { kind.positive_work() } -> std::convertible_to<Lane>;
  { kind.dissipated() } -> std::convertible_to<Lane>;
};

static_assert(MovesPads<FingerLanes>);

/// Another kind is a member beside `jaw_` and the mask of its lanes, and each answer a `select` between the two.
class GripperLanes {
 public:
  /// Puts the gripper of a scenario into a lane; without one its pads never touch.
  /// @param closing_speed_m_s, force_limit_N with which the fingers start
  void load(int lane, const Scenario& scenario, double closing_speed_m_s, double force_limit_N) {
    jaw_.load(lane, parallel_jaw(scenario), closing_speed_m_s, force_limit_N, opened_half_m(scenario));
  }
  /// All that a lane keeps from step to step, but for what `load` sets.
  void archive(LaneArchive& lane) { jaw_.archive(lane); }
  /// Collects what does not depend on the contact forces of this step.
  /// @param pads null: they are layers
  void begin_step(const WilsonTheta& wilson, const DriveCommand& command, const CarriedPads* pads = nullptr) {
    jaw_.begin_step(wilson, command, pads);
  }
  /// Moves to t + dt under the contact forces at t + theta dt, in the lanes of `running`.
  void advance(const WilsonTheta& wilson, const PadForces& force_theta_N, const Mask& running) {
    jaw_.advance(wilson, force_theta_N, running);
  }

  /// Way of a pad at t + theta dt when the contacts press with these forces.
  [[nodiscard]] Lane way_at_theta(int pad, const PadForces& force_N) const {
    return jaw_.way_at_theta(pad, force_N);
  }
  /// Bound on d way / d force for the contact solver's local steps.
  [[nodiscard]] const Lane& compliance() const { return jaw_.compliance(); }

  [[nodiscard]] Lane way(int pad) const { return jaw_.way(pad); }
  [[nodiscard]] Lane speed(int pad) const { return jaw_.speed(pad); }
  [[nodiscard]] Lane acceleration(int pad) const { return jaw_.acceleration(pad); }
  /// How far the pads have approached each other.
  [[nodiscard]] Lane closing() const { return jaw_.closing(); }
  /// Way of the pad that is furthest in.
  [[nodiscard]] Lane furthest_way() const { return jaw_.furthest_way(); }
  [[nodiscard]] Mask at_end_of_stroke() const { return jaw_.at_end_of_stroke(); }

  /// Energy of motion relative to the palm and what it stores itself, [J].
  [[nodiscard]] Lane energy() const { return jaw_.energy(); }
  /// Work of the drives and of the palm's acceleration since load, and the positive part of each step's, [J].
  [[nodiscard]] const Lane& work() const { return jaw_.work(); }
  [[nodiscard]] const Lane& positive_work() const { return jaw_.positive_work(); }
  /// Dissipated in the gripper since load, [J].
  [[nodiscard]] const Lane& dissipated() const { return jaw_.dissipated(); }

 private:
  FingerLanes jaw_;
};

}  // namespace unbruised
