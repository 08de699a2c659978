#pragma once

/// @file
/// The motion of a product by every one of its particles, all lanes at once: state, the step's linear equations,
/// and their solution with what others add to the right-hand side.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/body/body_motion.hpp"
#include "core/body/correction.hpp"
#include "core/body/factor_solve.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {

class BodyLanes final : public BodyMotion {
 public:
  /// Both have to outlive this. In a floating frame u, v and a are along its axes; sums, momentum, `state` and
  /// gravity are along x, y, z whatever the frame.
  /// @param touchable particles that contact forces may act on; what it refers to has to outlive this
  BodyLanes(const BodyModel& body, const WilsonTheta& wilson, ProductFrame frame = ProductFrame::upright,
            const Touchable& touchable = {});

  void load(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2) override;
  void archive(LaneArchive& lane) override;

  void begin_step(const Mask& running, const LaneArray* remembered = nullptr) override;
  /// What accelerates every particle from the coming step on, in place of gravity; of a body that is held.
  void set_gravity(const std::array<Lane, 3>& acceleration_m_s2) { gravity_ = acceleration_m_s2; }
  /// sum shape' (right-hand side), [3n], after `begin_step`.
  [[nodiscard]] Lane weighted_load(std::span<const double> shape) const;
  /// sum m (a0 u + a2 v + 2 a) along one axis.
  [[nodiscard]] Lane inertial_sum(std::size_t axis) const;
  void add_forces(int lane, std::span<const double> force_N) override;

  /// Forward through the factor.
  void start_solve(const LaneArray* load, LaneVector* moment = nullptr) override;
  void solve_without_contact(const Touchable& touchable, LaneArray& base) override;
  HeldForces solve_under_held(const Touchable& touchable, LaneArray& base) override;
  void add_contact(std::span<const int> particles, std::span<const int> active, const LaneArray& force) override;
  /// Backward through the factor.
  void finish_solve(const Mask& lanes, const LaneVector* turn_rad = nullptr) override;
  /// Adds a motion, [3n], times a factor to the displacement at t + theta dt.
  void add_motion(std::span<const double> shape, const Lane& factor, const Mask& lanes);

  void advance(const Mask& running, const OuterForces& outer = {}) override;

  [[nodiscard]] const LaneArray& rate() const override { return frame_ ? rate_ : v_; }
  [[nodiscard]] const LaneArray& stiffness_rate() const override { return c_v_; }
  [[nodiscard]] const FrameLanes* frame() const override { return frame_ ? &*frame_ : nullptr; }
  [[nodiscard]] BodyState state(int lane) const override;
  [[nodiscard]] double rotation_rad(int lane) const override;
  [[nodiscard]] std::array<double, 3> momentum(int lane) const override;
  [[nodiscard]] double kinetic_energy_J(int lane) const override;
  [[nodiscard]] double damped_J(int lane) const override { return damped_.work_J(lane); }

 private:
  /// C = tau K?
  [[nodiscard]] bool is_damped_as_it_is_stiff() const { return body_.C.value.empty(); }
  /// Of the matrix that stands for C.
  [[nodiscard]] double damping_factor() const {
    return is_damped_as_it_is_stiff() ? body_.relaxation_time_s : 1.0;
  }
  /// Begins the right-hand side. @param rate velocity that is damped
  /// @param outer_m_s2 gives a particle's acceleration by what acts on all of them
  template <class Acceleration>
  void put_right_hand_side(const LaneArray& rate, const LaneArray* remembered, const Acceleration& outer_m_s2,
                           const Mask& running);
  [[nodiscard]] Lane power_of(const LaneArray& rate, const NarrowPacks& busy) const;
  [[nodiscard]] LaneVector moment_of_load(const LaneArray* load) const;
  void advance_upright(const Mask& running);

  /// Puts what is to be corrected there, and into viscous_ what K multiplies in the right-hand side that is left.
  void predict(const LaneArray* remembered);

  const BodyModel& body_;
  const WilsonTheta& w_;
  // A free solid is solved as a correction, all others as they are.
  std::optional<Correction> correction_;
  std::optional<FactorSolve<LaneArray>> solve_;
  LaneArray viscous_, c_viscous_;  ///< a1 u + 2 v + a3 a; C times it
  LaneArray c_v_;                  ///< C v, of bodies whose stiffness fades or that are not corrected
  LaneArray rhs_;                  ///< elimination order; of a correction what is left of it
  std::optional<FrameLanes> frame_;
  LaneArray rate_;  ///< velocity with which a body in a floating frame deforms, [3n]
  std::array<Lane, 3> turn_{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< sum m r x u
  Mask running_{true};                                         ///< in the present step
};

}  // namespace unbruised
