#pragma once

/// @file
/// The driven fingers of a gripper, all lanes at once. A finger has one freedom, its closing way w
/// relative to the palm: m w'' + c w' = D - S - E - dir m a_palm - m (Omega_y^2 + Omega_z^2) (s - w), s - w the
/// distance of its mass from the axis of a palm that turns with Omega, with drive force D = clamp(gain (v_set -
/// w'),
/// +-limit), S the sum of its contacts' normal forces and E that of the end stop. It is integrated by the same
/// Wilson-theta as the product, coupled through S. The stop at the end of the stroke is a layer of steel on the
/// jaw's housing, E = k (d + clamp(tau d', -d, d)) at an indentation d, damped so that a finger comes to rest
/// against it. A drive with a force-speed curve gives no more than the curve at the finger's present speed; of a
/// gripper that holds by position a lock (finger_lock.hpp) takes the place of the drive while it is closed.

#include <array>

#include "core/gripper/drive_command.hpp"
#include "core/gripper/finger_lock.hpp"
#include "core/gripper/force_curve_lanes.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/scenario/scenario.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// Normal forces of the contacts on each finger, per lane [N].
using FingerForces = std::array<Lane, kMostFingers>;
inline FingerForces without_force() {
  FingerForces force;
  force.fill(Lane(0.0));
  return force;
}

/// What pads that are bodies add to the fingers they are bonded to, within a step (pad_lanes.hpp).
struct CarriedPads {
  Lane mass_kg{0.0};
  FingerForces force_N = without_force();  ///< against the closing way
};

/// All lanes have as many fingers.
class FingerLanes {
 public:
  /// Puts a jaw into a lane whose fingers close at `closing_speed_m_s` as steadily as a drive with the force
  /// limit `force_limit_N` keeps it up; null: pads that never touch.
  /// @param opened_m distance of a pad's face from the middle between them where the fingers start
  void load(int lane, const ParallelJawParameters* jaw, double closing_speed_m_s, double force_limit_N,
            double opened_m = 0.0);
  /// All that a lane keeps from step to step, but for what `load` sets.
  void archive(LaneArchive& lane);

  /// Collects what does not depend on the contact forces of this step. @param pads null: they are layers
  void begin_step(const WilsonTheta& wilson, const DriveCommand& command, const CarriedPads* pads = nullptr);

  /// Closing way at t + theta dt of `finger` when the contacts press with `force` on the fingers.
  [[nodiscard]] Lane way_at_theta(int finger, const FingerForces& force) const;

  /// Bound on d way / d force for the contact solver's local steps (drive saturated).
  [[nodiscard]] const Lane& compliance() const { return compliance_; }

  /// Moves to t + dt under the contact forces at t + theta dt, in the lanes of `running`.
  void advance(const WilsonTheta& wilson, const FingerForces& force_theta, const Mask& running);

  [[nodiscard]] Lane way(int finger) const { return state_[finger].way; }
  [[nodiscard]] Lane speed(int finger) const { return state_[finger].speed; }
  [[nodiscard]] Lane acceleration(int finger) const { return state_[finger].acceleration; }

  /// Closing ways of all fingers together: how far the pads have approached each other.
  [[nodiscard]] Lane closing() const;
  /// Closing way of the finger that is furthest in.
  [[nodiscard]] Lane furthest_way() const;
  /// Has a finger come to the end of its stroke?
  [[nodiscard]] Mask at_end_of_stroke() const { return furthest_way() >= stroke_; }

  /// Energy of motion relative to the palm, of the end stop and of the locks, [J].
  [[nodiscard]] Lane energy() const;
  /// Work of the drives and of the palm's acceleration since load, and the positive part of each step's, [J].
  [[nodiscard]] const Lane& work() const { return work_; }
  [[nodiscard]] const Lane& positive_work() const { return positive_work_; }
  /// Dissipated in the guides, the end stop and the locks since load, [J].
  [[nodiscard]] const Lane& dissipated() const { return dissipated_; }

 private:
  struct State {
    Lane way{0.0}, speed{0.0}, acceleration{0.0};
    Lane drive{0.0};    ///< drive and inertial force at the end of the last step
    Lane pressed{0.0};  ///< drive force alone there
    Lane lock{0.0};     ///< force of a lock's spring and damper there
    Lane lock_energy{0.0};
    Lane stop{0.0};        ///< force of the end stop there, against the closing way
    Lane depth{0.0};       ///< how far the stop is pressed in there, as linear as its force
    Lane free_force{0.0};  ///< right-hand side of the saturated equation without drive and contact
    Lane least{0.0};       ///< drive force, in this step
    Lane viscous{0.0};     ///< a1 w + 2 w' + a3 w'' at the start of the step
  };
  /// Force of inertia of a palm that is accelerated or turns against the closing way.
  [[nodiscard]] Lane palm_force(int finger) const;
  /// What of forces, or accelerations, acts on one finger.
  [[nodiscard]] Lane share(int finger, const FingerForces& each) const;
  [[nodiscard]] Lane drive_at_theta(int finger, const Lane& contact) const;
  /// The same once the way is known.
  [[nodiscard]] Lane drive_at_way(int finger, const Lane& way_theta) const;
  /// Of a drive that wants to give a force at a speed, within its force-speed curve.
  [[nodiscard]] Lane drive_on_curve(int finger, const Lane& speed, const Lane& wanted) const;
  /// The way at t + theta dt as if there were neither end stop nor lock.
  [[nodiscard]] Lane free_way_at_theta(int finger, const Lane& contact) const;
  /// The same against the end stop.
  [[nodiscard]] Lane stopped_way_at_theta(int finger, const Lane& contact) const;
  /// The same of drives with a force-speed curve.
  [[nodiscard]] Lane curved_way_at_theta(int finger, const Lane& contact) const;
  /// The way at t + theta dt without locks, and where a lock is closed.
  [[nodiscard]] Lane driven_way_at_theta(int finger, const Lane& contact) const;
  [[nodiscard]] Lane locked_way_at_theta(int finger, const Lane& contact) const;
  /// The way of fingers whose locks are closed, some in part. @param driven the same without locks
  [[nodiscard]] Lane held_way_at_theta(int finger, const Lane& contact, const Lane& driven) const;
  /// Where w is with `stiffness` w + E(w) = `force`, E that of the end stop.
  [[nodiscard]] Lane way_against_stop(int finger, const Lane& stiffness, const Lane& force) const;
  struct Push;
  [[nodiscard]] Push push_at_theta(int finger, const FingerForces& force_theta) const;

  int count_ = kJawFingers;
  std::array<State, kMostFingers> state_;
  Lane mass_{1.0}, viscous_{0.0}, gain_{1.0}, stroke_{1.0}, opened_{0.0};
  Lane stop_time_{0.0};  ///< tau of the end stop, [s]
  Mask centric_{true};
  Lane stiffness_{1.0};  ///< a0 m + a1 c
  Lane inverse_stiffness_{1.0};
  Lane inverse_driven_{1.0};  ///< 1 / (a0 m + a1 c + a1 gain)
  Lane compliance_{1.0};
  Lane a1_{0.0};
  ForceCurveLanes curve_;
  FingerLock lock_;
  DriveCommand command_;
  Lane work_{0.0}, positive_work_{0.0}, dissipated_{0.0};
};

// The contact solve asks for the way at every candidate: what most fingers do is one piece of code with it, and
// what stops, curves and locks add stands apart.

[[gnu::always_inline]] inline Lane FingerLanes::share(int finger, const FingerForces& each) const {
  Lane sum = each[0];
  for (int other = 1; other < count_; ++other) sum += each[static_cast<std::size_t>(other)];
  return select(centric_, Lane(1.0 / count_) * sum, each[static_cast<std::size_t>(finger)]);
}

[[gnu::always_inline]] inline Lane FingerLanes::drive_at_way(int finger, const Lane& way_theta) const {
  const Lane speed = a1_ * way_theta - state_[finger].viscous;
  const Lane wanted = gain_ * (command_.set_speed_m_s - speed);
  if (curve_.any_given()) return drive_on_curve(finger, speed, wanted);
  return max(state_[finger].least, min(command_.force_limit_N, wanted));
}

[[gnu::always_inline]] inline Lane FingerLanes::drive_at_theta(int finger, const Lane& contact) const {
  const State& s = state_[finger];
  return drive_at_way(finger,
                      (s.free_force - contact + gain_ * (command_.set_speed_m_s + s.viscous)) * inverse_driven_);
}

[[gnu::always_inline]] inline Lane FingerLanes::free_way_at_theta(int finger, const Lane& contact) const {
  // Solving with the linear drive first and clamping its force is exact: the balance is monotone in the way.
  return (state_[finger].free_force - contact + drive_at_theta(finger, contact)) * inverse_stiffness_;
}

[[gnu::always_inline]] inline Lane FingerLanes::driven_way_at_theta(int finger, const Lane& contact) const {
  Lane way = free_way_at_theta(finger, contact);
  const Mask stopped = way > stroke_;
  if (any(stopped)) way = select(stopped, stopped_way_at_theta(finger, contact), way);
  if (curve_.any_given()) way = select(curve_.given(), curved_way_at_theta(finger, contact), way);
  return way;
}

[[gnu::always_inline]] inline Lane FingerLanes::way_at_theta(int finger, const FingerForces& force) const {
  const Lane contact = share(finger, force);
  const Lane way = driven_way_at_theta(finger, contact);
  return lock_.any_closed() ? held_way_at_theta(finger, contact, way) : way;
}

}  // namespace unbruised
