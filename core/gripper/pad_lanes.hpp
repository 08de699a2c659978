#pragma once

/// @file
/// The pads of all lanes where they are bodies: each moves against its back, which goes with its finger and the
/// palm. With d the displacement against the back, n along the closing way w and b what accelerates everything in
/// the palm,
///   A d = M (a0 d_t + ..) + C (..) + M (b - n w'') + J' lambda,   w'' = a0 w - (a0 w_t + a2 w_t' + 2 w_t'')
/// at t + theta dt, so that d = d_0 + A^-1 J' lambda - a0 w A^-1 M n, and the finger feels a mass and a force that
/// do not depend on what it does in the step (docs/theory.md, "Pads that are bodies").

#include <array>
#include <vector>

#include "core/body/body_lanes.hpp"
#include "core/gripper/gripper_lanes.hpp"
#include "core/gripper/pad_body.hpp"

namespace unbruised {

class PadLanes {
 public:
  /// Both have to outlive this.
  PadLanes(const PadBody& pad, const WilsonTheta& wilson);

  /// Lets the pads of a lane hang at rest on fingers that have not closed. @param outer_m_s2 as in `begin_step`
  /// @param opened_m distance of a pad's face from the middle between them
  void load(int lane, const std::array<double, 3>& outer_m_s2, double opened_m);
  /// All that a lane keeps from step to step, but for what `load` sets.
  void archive(LaneArchive& lane);
  /// Middle of a pad from that between the fingers, along the axes of the palm.
  [[nodiscard]] LaneVector middle_m(int pad, const GripperLanes& gripper) const;
  /// Solves the step but for contact and the finger's way.
  /// @param gripper at the start of the step
  /// @param outer_m_s2 of each pad: what accelerates it in the axes of the palm at t + theta dt, gravity less the
  /// palm's own acceleration
  void begin_step(const GripperLanes& gripper, const std::array<LaneVector, kJawFingers>& outer_m_s2,
                  const Mask& running);
  /// What the fingers feel of it.
  [[nodiscard]] const CarriedPads& on_fingers() const { return on_fingers_; }
  /// d_0 of the particles of the face, rows 3 x particle of the face + axis, in the axes of the pad.
  [[nodiscard]] const LaneArray& free(int pad) const { return pad_[static_cast<std::size_t>(pad)].free; }

  /// Moves a pad to t + dt. @param face_force_N on the particles of its face, rows as in `free`; null: none
  void advance(int pad, const LaneArray* face_force_N, const Lane& way_theta_m, const Mask& running);
  /// Books the step, once the fingers have moved as well.
  void book_step(const GripperLanes& gripper, const Mask& running);

  [[nodiscard]] const PadBody& model() const { return pad_model_; }
  [[nodiscard]] const BodyLanes& body(int pad) const { return pad_[static_cast<std::size_t>(pad)].body; }
  /// Energy of both against the palm, elastic and of motion, in one lane [J].
  [[nodiscard]] double energy_J(int lane, const GripperLanes& gripper) const;
  /// Dissipated in both since load, in one lane [J].
  [[nodiscard]] double damped_J(int lane) const;
  /// Work of gravity and of the palm's acceleration on both since load, and the positive part of each step's [J].
  [[nodiscard]] const Lane& work() const { return work_; }
  [[nodiscard]] const Lane& positive_work() const { return positive_work_; }

 private:
  struct Pad {
    Pad(const PadBody& model, const WilsonTheta& wilson) : body(model.body, wilson), free(3 * model.face.size()) {}

    BodyLanes body;
    LaneArray free;
    LaneVector outer, outer_theta;  ///< in the axes of the pad, at the start of the step and at t + theta dt
    std::array<Lane, 3> mass_u{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< at the start of the step
    Lane way{0.0};                                                ///< of its finger there
  };

  const PadBody& pad_model_;
  const WilsonTheta& w_;
  std::vector<int> whole_face_;  ///< 0, 1, 2 ..
  std::array<Pad, kJawFingers> pad_;
  CarriedPads on_fingers_;
  Lane opened_{0.0};  ///< distance of a pad's middle from the middle between them, where the fingers start
  Lane work_{0.0}, positive_work_{0.0};
};

}  // namespace unbruised
