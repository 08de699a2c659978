#pragma once

/// @file
/// Modes in a floating frame (docs/theory.md, "A product that turns by its modes"), all lanes at once. A field
/// that modes carry, S z, and the places y = X + S z that they make, are turned, and summed up with the masses,
/// without a look at the particles: by T_ab = S' M e_a e_b' S, what modes carry of component b put along e_a.

#include <array>
#include <vector>

#include "core/algebra/lane_dense.hpp"
#include "core/body/body_model.hpp"
#include "core/body/mode_shapes.hpp"
#include "core/frame/frame_lanes.hpp"
#include "core/lanes/lane_packs.hpp"

namespace unbruised {

/// Read-only once built.
struct TurningBasis {
  DenseMatrix crossing;         ///< S' M [e_c x] S, block by block of [3 x modes, modes]
  DenseMatrix stretching;       ///< T_xx, T_yy and T_yz + T_zy, T_zx + T_xz, T_xy + T_yx of [5 x modes, modes]
  std::vector<double> of_X;     ///< S' M e_a X_b, row 3 a + b of [9, modes; kg^1/2 m]
  std::array<double, 9> X_X{};  ///< sum m X X'
  double root_mass = 0.0;       ///< kg^1/2
  /// A rotation d x X is sum c_k s_k of the three rotating modes, c = this d; its transpose makes of what acts on
  /// them the moment about the centre of mass.
  std::array<double, 9> to_rotating{};
};

TurningBasis turning_basis(const BodyModel& body, const ModeShapes& modes);

/// y, y' and y'' of the modes.
struct ModalMotion {
  LaneArray& now;
  LaneArray& rate;
  LaneArray& second;
};

class TurningModes {
 public:
  /// Both have to outlive this.
  TurningModes(const TurningBasis& basis, const WilsonTheta& wilson);

  /// Turns a motion into the predicted axes.
  /// @param viscous, rate become a1 y + 2 s + a3 q and s, the velocity and acceleration with which the body
  /// deforms, of deforming modes
  void predict(const FramePrediction& prediction, const ModalMotion& motion, LaneArray& viscous, LaneArray& rate,
               const Mask& running);
  /// At t + theta dt, from the motion at the start of the step in the predicted axes.
  [[nodiscard]] BalanceSums balance(const ModalMotion& start, const LaneArray& theta, const Mask& running);
  /// Of a motion, which `apply` can take on afterwards.
  [[nodiscard]] StateSums sums(const ModalMotion& motion, const Mask& running);
  /// Takes the motion whose sums were asked for last into the frame that fits.
  void apply(const FrameCorrection& correction, const ModalMotion& motion, const Mask& running);
  /// Gives a motion that fits the frame this angular momentum about the centre of mass by a turn of it all: what
  /// is turned loses what modes cannot carry.
  void give_momentum(const LaneVector& momentum_kg_m2_s, const ModalMotion& motion, const Mask& lanes);

  /// What a rotation by `turn` comes to in the rotating modes.
  [[nodiscard]] LaneVector to_rotating(const LaneVector& turn) const { return to_rotating_ * turn; }
  /// The moment about the centre of mass at rest of what acts on the rotating modes.
  [[nodiscard]] LaneVector moment(const LaneVector& on_rotating) const {
    return transposed(to_rotating_) * on_rotating;
  }

 private:
  /// What modes carry of a field's components, [3 x modes] and [5 x modes].
  struct Components {
    LaneArray crossing, stretching;
  };
  /// A matrix by what it does to them.
  struct Turn;
  void look(const LaneArray& amounts, const BusyPacks& lanes, Components& components) const;
  void cross(const LaneArray& amounts, const BusyPacks& lanes, LaneArray& crossing) const;
  [[nodiscard]] LaneVector root_mass_times(const LaneArray& amounts) const;
  [[nodiscard]] NarrowPack turned(const Turn& by, const LaneArray& amounts, const Components& components,
                                  std::size_t mode, int first) const;
  [[nodiscard]] NarrowPack turned_X(const PackMatrix& by, std::size_t mode) const;
  [[nodiscard]] PackVector levers(const LaneArray& crossing, std::size_t mode, int first) const;

  const TurningBasis& basis_;
  const WilsonTheta& w_;
  std::size_t count_;
  LaneMatrix to_rotating_;
  std::vector<int> every_mode_;
  Components now_, rate_, second_;
  LaneArray crossing_;      ///< of the places at t + theta dt
  LaneArray acceleration_;  ///< there
};

}  // namespace unbruised
