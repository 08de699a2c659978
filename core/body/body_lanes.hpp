#pragma once

/// @file
/// The motion of the product, all lanes at once: state, the step's linear equations, and their solution with what
/// others add to the right-hand side.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/body/body_state.hpp"
#include "core/frame/frame_lanes.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {

class BodyLanes {
 public:
  /// Both have to outlive this. In a floating frame u, v and a are along its axes; sums, momentum, `state` and
  /// gravity are along x, y, z whatever the frame.
  BodyLanes(const BodyModel& body, const WilsonTheta& wilson, ProductFrame frame = ProductFrame::upright);

  void load(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2);
  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane);

  /// The right-hand side without contact and plastic load, and the damping's power at the start of the step.
  /// @param remembered where not null, a displacement whose stiffness is a force of the body at t + theta dt,
  /// [3n], in the axes at the start of the step; of lattices
  void begin_step(const Mask& running, const LaneArray* remembered = nullptr);
  /// What accelerates every particle from the coming step on, in place of gravity; of a body that is held.
  void set_gravity(const std::array<Lane, 3>& acceleration_m_s2) { gravity_ = acceleration_m_s2; }
  /// sum shape' (right-hand side), [3n], after `begin_step`.
  [[nodiscard]] Lane weighted_load(std::span<const double> shape) const;
  /// sum m (a0 u + a2 v + 2 a) along one axis.
  [[nodiscard]] Lane inertial_sum(std::size_t axis) const;
  /// Adds forces at t + theta dt, [3n], to the right-hand side of one lane.
  void add_forces(int lane, std::span<const double> force_N);

  /// Forward through the factor. @param load added to the right-hand side, rows 3 x particle + axis; may be null
  /// @param moment where not null, becomes the moment of that sum about the centre of mass at rest
  void start_solve(const LaneArray* load, LaneVector* moment = nullptr);
  /// The displacement that would come without contact, at the listed particles: rows 3 x index + axis of `base`.
  /// @param reach supernodes these particles touch
  void solve_without_contact(std::span<const int> reach, std::span<const int> particles, LaneArray& base);
  /// Adds contact forces to the running solve. @param active indices into `particles` and blocks of `force`
  void add_contact(std::span<const int> particles, const std::vector<int>& active, const LaneArray& force);
  /// Backward through the factor: the displacement at t + theta dt in `lanes`.
  /// @param turn_rad where not null, by which contact forces turn a body in a floating frame beside their action
  /// on its particles
  void finish_solve(const Mask& lanes, const LaneVector* turn_rad = nullptr);
  /// Adds a motion, [3n], times a factor to the displacement at t + theta dt.
  void add_motion(std::span<const double> shape, const Lane& factor, const Mask& lanes);

  /// Moves the state to t + dt in the lanes of `running`, and its sums.
  /// @param outer forces that a body in a floating frame was solved with
  void advance(const Mask& running, const OuterForces& outer = {});
  /// Sums of contact forces at t + theta dt, for `advance`. @param active, force as in `add_contact`
  [[nodiscard]] OuterForces outer_forces(std::span<const int> particles, std::span<const int> active,
                                         const LaneArray& force) const;

  [[nodiscard]] const LaneArray& u() const { return u_; }
  [[nodiscard]] const LaneArray& v() const { return v_; }
  [[nodiscard]] const LaneArray& a() const { return a_; }
  [[nodiscard]] const LaneArray& u_theta() const { return u_theta_; }
  /// Velocity with which the body deforms at the start of a step, after `begin_step`, and K times it where K also
  /// damps.
  [[nodiscard]] const LaneArray& rate() const { return frame_ ? rate_ : v_; }
  [[nodiscard]] const LaneArray& stiffness_rate() const { return c_v_; }
  [[nodiscard]] const std::array<Lane, 3>& gravity() const { return gravity_; }
  /// sum m u and sum m a.
  [[nodiscard]] const std::array<Lane, 3>& mass_u() const { return mass_u_; }
  [[nodiscard]] const std::array<Lane, 3>& mass_a() const { return mass_a_; }
  /// The frame of a body that turns far; null: it is upright.
  [[nodiscard]] const FrameLanes* frame() const { return frame_ ? &*frame_ : nullptr; }
  /// Displacements, velocities and accelerations of a lane along x, y, z.
  [[nodiscard]] BodyState state(int lane) const;
  /// Small rotation of the body about its centre of mass; 0 in a floating frame, which goes with it [rad].
  [[nodiscard]] double rotation_rad(int lane) const;
  /// sum m v.
  [[nodiscard]] std::array<double, 3> momentum(int lane) const;
  [[nodiscard]] double kinetic_energy_J(int lane) const;
  /// v'Cv since load, by the trapezoid rule; of the deformation's v in a floating frame.
  [[nodiscard]] double damped_J(int lane) const;

 private:
  [[nodiscard]] LaneMotion motion() { return {u_, v_, a_}; }
  /// Begins the right-hand side. @param rate velocity that is damped
  /// @param outer_m_s2 gives a particle's acceleration by what acts on all of them
  template <class Acceleration>
  void put_right_hand_side(const LaneArray& rate, const LaneArray* remembered, const Acceleration& outer_m_s2,
                           const Mask& running);
  [[nodiscard]] LaneVector moment_of_load() const;
  void advance_upright(const Mask& running);
  void take_sums_of_frame();

  /// The supernodes that forces on the active ones touch.
  const std::vector<int>& reach_of_active(std::span<const int> particles, const std::vector<int>& active);

  const BodyModel& body_;
  const WilsonTheta& w_;
  Reach reach_;
  std::vector<int> active_, active_reach_;  ///< of the last `add_contact`
  LaneArray u_, v_, a_, u_theta_;           ///< [3n]
  LaneArray viscous_, c_viscous_, c_v_;     ///< a1 u + 2 v + a3 a; C times it; C v
  LaneArray rhs_, x_, x_reach_;             ///< elimination order
  std::optional<FrameLanes> frame_;
  LaneArray rate_;  ///< velocity with which a body in a floating frame deforms, [3n]
  std::array<Lane, 3> gravity_{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> mass_u_{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> mass_a_{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> turn_{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< sum m r x u
  Mask running_{true};                                         ///< in the present step
  Lane last_step_s_{0.0};                                      ///< 0: not stepped yet
  Lane damping_power_{0.0}, damped_{0.0};
};

}  // namespace unbruised
