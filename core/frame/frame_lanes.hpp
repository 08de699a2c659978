#pragma once

/// @file
/// The floating frame of a body that turns, all lanes at once (docs/theory.md, "A product that turns"): an
/// attitude R and a centre c, in whose axes K, M and C are constant. A particle stands at c + R (X + u), X from
/// the centre of mass of the body at rest; u, v and a are kept in the axes of R, v and a being absolute.
///
/// A step is written in the frame predicted for t + theta dt, and the frame is fitted to the body again at its
/// end: between the two calls of a step the same state stands in the axes of the predicted frame.

#include <span>
#include <vector>

#include "core/frame/frame_sums.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/lanes/lane_rotation.hpp"

namespace unbruised {

/// The state of a body, rows 3 x particle + axis.
struct LaneMotion {
  LaneArray& u;
  LaneArray& v;
  LaneArray& a;
};

/// From the frame that fitted at the start of a step to the one predicted for t + theta dt, in the axes of the
/// former.
struct FramePrediction {
  LaneVector v_c, a_c;      ///< velocity and acceleration of the centre
  LaneVector way;           ///< of the centre
  LaneVector omega, alpha;  ///< of the body as a whole
  LaneMatrix back;          ///< turns components into the predicted axes
};

/// From the predicted frame to the one that fits.
struct FrameCorrection {
  LaneVector shift;  ///< of the centre
  LaneMatrix turn;
  LaneVector spin;      ///< added to the rotation, in the axes that fit
  LaneVector momentum;  ///< angular momentum that comes of it, there
  Mask is_spun{false};  ///< lanes whose rotation is corrected
};

class FrameLanes {
 public:
  /// @param position_m, mass_kg of the particles at rest, of shape [n]; not all on one line
  /// @param wilson has to outlive this
  FrameLanes(std::span<const std::array<double, 3>> position_m, std::span<const double> mass_kg,
             const WilsonTheta& wilson);

  /// Fits the frame of a lane to the state that was put into it, measured from the body at rest and along x, y, z.
  /// @param rotation_rad its attitude but for its deformation, about this vector by its length
  void load(int lane, const LaneMotion& motion, const std::array<double, 3>& rotation_rad,
            const std::array<double, 3>& gravity_m_s2);
  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane);

  /// Predicts the frame for t + theta dt and turns the state into it.
  /// @param viscous, rate become a1 u + 2 s + a3 q and s, the velocity and acceleration with which the body
  /// deforms
  void predict(const LaneMotion& motion, LaneArray& viscous, LaneArray& rate, const Mask& running);
  /// What acts on particles as if on a rigid body, per mass and beside gravity, is this times X.
  [[nodiscard]] const LaneVector& rigid_load_rad_s2() const { return beta_; }
  /// Moves the state to t + dt, given u at t + theta dt and what led to it, and fits the frame to it.
  void advance(const LaneMotion& motion, const LaneArray& u_theta, const OuterForces& outer, const Mask& running);

  // The same in parts, for a body that does not move particle by particle.

  /// Predicts the frame for t + theta dt.
  FramePrediction predict(const Mask& running);
  /// Fits the frame to the state at t + dt. @param sums of it in the predicted axes @param balance at t + theta dt
  FrameCorrection fit_step(const StateSums& sums, const BalanceSums& balance, const OuterForces& outer,
                           const Mask& running);
  /// Takes these particles into another frame.
  void apply(const FrameCorrection& correction, std::span<const int> particles, const LaneMotion& motion,
             const Mask& lanes) const;

  [[nodiscard]] const LaneRotation& attitude() const { return attitude_; }
  /// Angle by which the frame has turned from x, y, z.
  [[nodiscard]] double angle_rad(int lane) const;
  /// R.
  [[nodiscard]] const LaneMatrix& axes() const { return R_; }
  /// X.
  [[nodiscard]] const std::array<double, 3>& rest_place_m(std::size_t particle) const { return X_[particle]; }
  /// Components along x, y, z of a vector that is given in the axes of the frame, and back.
  [[nodiscard]] LaneVector to_world(const LaneVector& vector) const { return R_ * vector; }
  [[nodiscard]] LaneVector to_frame(const LaneVector& vector) const { return transposed(R_) * vector; }
  /// How far the centre of mass is from where it is at rest.
  [[nodiscard]] const LaneVector& center_motion_m() const { return center_; }
  /// Displacement of a particle along x, y, z from where it is at rest.
  [[nodiscard]] LaneVector displacement_m(std::size_t particle, const LaneVector& u) const {
    const LaneVector X = to_lanes(X_[particle]);
    return center_ + R_ * (X + u) - X;
  }
  /// sum m v and sum m a, along x, y, z; at the ends of steps.
  [[nodiscard]] LaneVector momentum_kg_m_s() const { return to_world(mass_v_); }
  [[nodiscard]] LaneVector mass_acceleration_N() const { return to_world(mass_a_); }
  /// Outer force, without gravity, at the end of a step, along x, y, z.
  [[nodiscard]] const LaneVector& outer_force_N() const { return outer_force_; }
  /// Moment of the outer forces about the centre of mass at the end of a step, along x, y, z.
  [[nodiscard]] const LaneVector& outer_moment_N_m() const { return outer_moment_; }
  /// About the centre of mass, along x, y, z: what the outer forces have made of it.
  [[nodiscard]] const LaneVector& angular_momentum_kg_m2_s() const { return angular_momentum_; }
  /// What the steps since load would have lost of it by themselves, step by step; it is given back.
  [[nodiscard]] const Lane& corrected_kg_m2_s() const { return corrected_; }
  /// Angle by which the body turns within a step.
  [[nodiscard]] double turn_rad(int lane) const { return w_.dt * sqrt(dot(omega_, omega_))[lane]; }
  /// Angular velocity in the axes of the frame.
  [[nodiscard]] const LaneVector& spin_rad_s() const { return omega_; }
  /// Between `predict` and `advance`: from the axes that fitted at the start of the step to the predicted ones.
  [[nodiscard]] const LaneMatrix& from_start() const { return back_; }
  /// Velocity and acceleration at the start of a step of what turns about the centre with the body as a whole, at
  /// `arm` from it, both in the axes that fitted then.
  [[nodiscard]] LaneVector velocity_of(const LaneVector& arm) const { return cross(omega_, arm); }
  [[nodiscard]] LaneVector acceleration_of(const LaneVector& arm) const {
    return cross(alpha_, arm) + cross(omega_, cross(omega_, arm));
  }

 private:
  void turn_frame(const LaneRotation& by, const Mask& running);
  void book_outer(const OuterForces& outer, const LaneVector& moment, const Mask& running);
  void balance_moments(const BalanceSums& sums, const LaneVector& y_c, const LaneVector& moment,
                       const Mask& running);
  FrameCorrection fit(StateSums sums, const Mask& may_correct, const Mask& running);

  const WilsonTheta& w_;
  std::vector<std::array<double, 3>> X_;  ///< from the centre of mass
  std::vector<double> mass_kg_;
  std::vector<int> every_particle_;
  Lane total_mass_{0.0};

  LaneRotation attitude_;
  LaneMatrix R_;
  LaneVector center_;
  LaneVector beta_;              ///< rigid angular acceleration that takes back the moment of internal forces
  LaneVector angular_momentum_;  ///< that the body must have, along x, y, z
  LaneVector outer_force_, outer_moment_;  ///< the moment about the centre of mass; along x, y, z
  double least_inertia_;                   ///< smallest principal moment of inertia at rest
  Lane corrected_{0.0};
  // At the last end of a step, in the axes of the frame that fits.
  LaneVector mass_v_, mass_a_;  ///< sum m v, sum m a
  LaneVector omega_, alpha_;    ///< of the body as a whole
  LaneMatrix back_;             ///< of the last prediction
};

}  // namespace unbruised
