#pragma once

/// @file
/// The motion of a product, all lanes at once, as the simulation sees it: a step's linear equations, what others
/// add to them, and where the particles are that others ask for.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/body/body_state.hpp"
#include "core/body/booked_work.hpp"
#include "core/body/held_forces.hpp"
#include "core/body/node_compliance.hpp"
#include "core/frame/frame_lanes.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

/// Of one lane [J].
struct BodyEnergy {
  double kinetic = 0.0;
  double elastic = 0.0;
};

class BodyMotion {
 public:
  virtual ~BodyMotion() = default;
  BodyMotion(const BodyMotion&) = delete;
  BodyMotion& operator=(const BodyMotion&) = delete;

  virtual void load(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2) = 0;
  /// All that a lane keeps from step to step.
  virtual void archive(LaneArchive& lane) = 0;

  /// Begins a step without contact and plastic load, and the damping's power at its start.
  /// @param remembered where not null, a displacement whose stiffness is a force of the body at t + theta dt,
  /// [3n], in the axes at the start of the step; of lattices
  virtual void begin_step(const Mask& running, const LaneArray* remembered = nullptr) = 0;
  /// Adds forces at t + theta dt, [3n], in one lane.
  virtual void add_forces(int lane, std::span<const double> force_N) = 0;
  /// Begins the solve. @param load added to the right-hand side, rows 3 x particle + axis; may be null
  /// @param moment where not null, becomes the moment of that sum about the centre of mass at rest
  virtual void start_solve(const LaneArray* load, LaneVector* moment = nullptr) = 0;
  /// The displacement that would come without contact at these particles: rows 3 x index + axis of `base`.
  virtual void solve_without_contact(const Touchable& touchable, LaneArray& base) = 0;
  /// The same under the contact forces that the solve begins with. @return these, until `add_contact`
  virtual HeldForces solve_under_held(const Touchable& touchable, LaneArray& base) {
    solve_without_contact(touchable, base);
    return {};
  }
  /// Gives the running solve its contact forces, in every step with touchable particles.
  /// @param active indices into `particles` and blocks of `force`; forces on others are zero
  virtual void add_contact(std::span<const int> particles, std::span<const int> active,
                           const LaneArray& force) = 0;
  /// The displacement at t + theta dt in `lanes`.
  /// @param turn_rad where not null, by which contact forces turn a body in a floating frame beside their action
  /// on its particles
  virtual void finish_solve(const Mask& lanes, const LaneVector* turn_rad = nullptr) = 0;
  /// Moves the state to t + dt in the lanes of `running`, and its sums.
  /// @param outer forces that a body in a floating frame was solved with
  virtual void advance(const Mask& running, const OuterForces& outer = {}) = 0;

  /// Displacements, velocities and accelerations, rows 3 x particle + axis; at t + theta dt, and at the end of the
  /// last step. Along the axes of a floating frame. Of a body that moves by modes they are kept where particles
  /// can touch something, and are nothing elsewhere.
  [[nodiscard]] const LaneArray& u() const { return u_; }
  [[nodiscard]] const LaneArray& v() const { return v_; }
  [[nodiscard]] const LaneArray& a() const { return a_; }
  [[nodiscard]] const LaneArray& u_theta() const { return u_theta_; }
  /// Velocity with which the body deforms at the start of a step, after `begin_step`, and K times it where K also
  /// damps; of bodies whose stiffness fades.
  [[nodiscard]] virtual const LaneArray& rate() const { return v_; }
  [[nodiscard]] virtual const LaneArray& stiffness_rate() const { return v_; }
  /// Sums of contact forces at t + theta dt on a body in a floating frame, for `advance`; particles, active and
  /// force as in `add_contact`.
  [[nodiscard]] OuterForces outer_forces(std::span<const int> particles, std::span<const int> active,
                                         const LaneArray& force) const;
  [[nodiscard]] const std::array<Lane, 3>& gravity() const { return gravity_; }
  /// sum m u and sum m a.
  [[nodiscard]] const std::array<Lane, 3>& mass_u() const { return mass_u_; }
  [[nodiscard]] const std::array<Lane, 3>& mass_a() const { return mass_a_; }

  /// The frame of a body that turns far; null: it is upright.
  [[nodiscard]] virtual const FrameLanes* frame() const { return nullptr; }
  /// Displacements, velocities and accelerations of a lane along x, y, z, of every particle.
  [[nodiscard]] virtual BodyState state(int lane) const = 0;
  /// Of a body that does not keep where every particle is; none: it does.
  [[nodiscard]] virtual std::optional<BodyEnergy> energy(int /*lane*/) const { return std::nullopt; }
  /// Small rotation of the body about its centre of mass; 0 in a floating frame, which goes with it [rad].
  [[nodiscard]] virtual double rotation_rad(int lane) const = 0;
  /// sum m v.
  [[nodiscard]] virtual std::array<double, 3> momentum(int lane) const = 0;
  [[nodiscard]] virtual double kinetic_energy_J(int lane) const = 0;
  /// v'Cv since load, by the trapezoid rule; of the deformation's v in a floating frame.
  [[nodiscard]] virtual double damped_J(int lane) const = 0;

 protected:
  explicit BodyMotion(std::size_t freedoms) : u_(freedoms), v_(freedoms), a_(freedoms), u_theta_(freedoms) {}

  [[nodiscard]] LaneMotion motion() { return {u_, v_, a_}; }
  /// After a step in a floating frame.
  void take_sums_of(const FrameLanes& frame, double total_mass_kg);

  LaneArray u_, v_, a_, u_theta_;  ///< [3n]
  std::array<Lane, 3> gravity_{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> mass_u_{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> mass_a_{Lane(0.0), Lane(0.0), Lane(0.0)};
  BookedWork damped_;  ///< v'Cv
};

/// A state of one lane along the axes of a floating frame becomes one along x, y, z.
void turn_to_world(const FrameLanes& frame, int lane, BodyState& state);

}  // namespace unbruised
