#pragma once

/// @file
/// The accounts of energy and of impulse. Each contributor has one line: what stores, what dissipates, what works.

#include <array>

#include "core/simulation/lane_view.hpp"

namespace unbruised {

class Balances {
 public:
  /// Opens the accounts of a lane whose state is loaded.
  void load(int lane, const LaneView& view, const Scenario& scenario);

  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane);

  /// Another plane comes under the product of a lane.
  void leave_support(int lane);

  /// Books what gravity, the palm and a belt did over the step that brought the carriers from `before` to `after`;
  /// forces are linear over the step.
  /// @param old_mass_u sum m u at the start of the step
  void book_step(const LaneView& view, const std::array<Lane, 3>& old_mass_u, const CarrierMotion& before,
                 const CarrierMotion& after, const Mask& running);
  /// Books the impulse of everything outside the product over the last step of one lane.
  void book_impulse(int lane, const LaneView& view);

  [[nodiscard]] static Dissipated dissipated(int lane, const LaneView& view, const Scenario& scenario);
  [[nodiscard]] WorkDone work_done(int lane, const LaneView& view, const Scenario& scenario) const;
  /// Fills the balance metrics at the end of a run.
  void measure(int lane, double time_s, const LaneView& view, const Scenario& scenario, Metrics& metrics) const;

 private:
  struct Impulse {
    std::array<double, 3> initial_momentum{};
    std::array<double, 3> impulse{};
    std::array<double, 3> outer_force_N{};  ///< on the product as a whole, at the start of the step
  };
  /// Of a product in a floating frame, about its centre of mass.
  struct AngularImpulse {
    std::array<double, 3> initial_momentum{};
    std::array<double, 3> impulse{};
    std::array<double, 3> outer_moment_N_m{};  ///< at the start of the step
    double size = 0;                           ///< of the momentum at the start and of all that came to it
  };
  [[nodiscard]] double impulse_mismatch(int lane, const LaneView& view) const;
  void open_angular_account(int lane, const FrameLanes& frame);
  void book_angular_impulse(int lane, double step_s, const FrameLanes& frame);
  void measure_angular_impulse(int lane, const LaneView& view, Metrics& metrics) const;

  std::array<Impulse, kLanes> impulse_;
  std::array<AngularImpulse, kLanes> angular_impulse_;
  std::array<double, kLanes> initial_energy_J_{};
  /// On the product, at the start of the step.
  std::array<Lane, 3> palm_force_{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<LaneVector, kSurfaceCount> cell_force_;  ///< of each surface that is no pad, along its axes
  LaneVector palm_moment_;                            ///< about the centre of the pads; of products that turn
  Lane palm_work_{0.0}, belt_work_{0.0}, gravity_work_{0.0}, positive_work_{0.0};
};

}  // namespace unbruised
