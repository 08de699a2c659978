#pragma once

/// @file
/// The motion of a product by its slowest modes, all lanes at once. A step costs the modes at the particles that
/// can be touched, whatever the number of particles. In a floating frame the modes are along its axes, as all is;
/// contact forces and what they make of G turn with the body.

#include "core/body/body_motion.hpp"
#include "core/body/modal_basis.hpp"
#include "core/body/relaxing_rows.hpp"
#include "core/body/turning_modes.hpp"
#include "core/lanes/lane_packs.hpp"

namespace unbruised {

class ModalLanes final : public BodyMotion {
 public:
  /// All have to outlive this.
  ModalLanes(const BodyModel& body, const ModalBasis& basis, const WilsonTheta& wilson);

  void load(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2) override;
  void archive(LaneArchive& lane) override;

  void begin_step(const Mask& running, const LaneArray* remembered = nullptr) override;
  void add_forces(int lane, std::span<const double> force_N) override;
  void start_solve(const LaneArray* load, LaneVector* moment = nullptr) override;
  void solve_without_contact(const Touchable& touchable, LaneArray& base) override;
  void add_contact(std::span<const int> particles, std::span<const int> active, const LaneArray& force) override;
  void finish_solve(const Mask& lanes, const LaneVector* turn_rad = nullptr) override;
  void advance(const Mask& running, const OuterForces& outer = {}) override;

  [[nodiscard]] const FrameLanes* frame() const override { return frame_ ? &*frame_ : nullptr; }
  [[nodiscard]] BodyState state(int lane) const override;
  [[nodiscard]] std::optional<BodyEnergy> energy(int lane) const override;
  [[nodiscard]] double rotation_rad(int lane) const override;
  [[nodiscard]] std::array<double, 3> momentum(int lane) const override;
  [[nodiscard]] double kinetic_energy_J(int lane) const override;
  /// With what has faded.
  [[nodiscard]] double damped_J(int lane) const override;

  /// Largest strain, sqrt(e:e), of the cells that can be touched, as of the last time that the contact forces were
  /// larger than ever before by `kForceStep`.
  [[nodiscard]] const Lane& largest_strain() const { return largest_strain_; }
  /// Largest rotation of these cells against a floating frame [rad].
  [[nodiscard]] const Lane& largest_cell_rotation() const { return largest_cell_rotation_; }

 private:
  /// Three rows that Wilson's method moves, and where they come at t + theta dt.
  struct Motion {
    Motion(std::size_t rows, const RelaxationStep& step) : now(rows), rate(rows), second(rows), theta(rows) {
      if (!step.branch.empty()) memory.emplace(step, rows);
    }
    LaneArray now, rate, second, theta;
    std::optional<RelaxingRows> memory;  ///< where the stiffness fades

    void clear(int lane) {
      for (LaneArray* row : {&now, &rate, &second, &theta}) row->clear_lane(lane);
      if (memory) memory->load(lane);
    }
    void archive(LaneArchive& lane) {
      lane(now, rate, second);
      if (memory) memory->archive(lane);
    }
    /// tau (a1 u + 2 v + a3 a), less what is remembered: what K multiplies on the right-hand side.
    [[nodiscard]] NarrowPack carried(const WilsonTheta& w, double relaxation_s, std::size_t row, int first) const {
      const NarrowPack viscous =
          w.viscous(get_pack(now, row, first), get_pack(rate, row, first), get_pack(second, row, first));
      return carried(viscous, relaxation_s, row, first);
    }
    /// @param viscous a1 u + 2 v + a3 a of what deforms
    [[nodiscard]] NarrowPack carried(const NarrowPack& viscous, double relaxation_s, std::size_t row,
                                     int first) const {
      const NarrowPack damped = NarrowPack(relaxation_s) * viscous;
      return memory ? damped - get_pack(memory->remembered(), row, first) : damped;
    }
  };
  void measure_strain(const Mask& lanes);
  void book_fading(const Mask& running);
  /// A state in the axes of a frame, and gravity.
  struct InFrame {
    BodyState state;
    std::array<double, 3> gravity_m_s2;
  };
  InFrame place_in_frame(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2);
  void load_modes(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2);
  void fit_frame(const BalanceSums& balance, const OuterForces& outer, const Mask& running);
  [[nodiscard]] ModalMotion modal_motion() { return {mode_.now, mode_.rate, mode_.second}; }
  /// Velocity with which the modes deform the body, at the start of a step.
  [[nodiscard]] const LaneArray& deforming_rate() const { return frame_ ? deforming_rate_ : mode_.rate; }
  [[nodiscard]] double elastic_J(int lane) const;
  /// Where a row of nodes stands in the rows of all particles.
  [[nodiscard]] std::size_t freedom_of(std::size_t row) const {
    return 3 * static_cast<std::size_t>(basis_.node[row / 3]) + row % 3;
  }

  const BodyModel& body_;
  const ModalBasis& basis_;
  const WilsonTheta& w_;
  double relaxation_s_;                    ///< tau
  double viscous_;                         ///< viscous_share
  std::vector<double> inverse_effective_;  ///< of each mode [s2]
  double root_mass_;
  std::vector<int> every_mode_, every_row_;

  std::optional<FrameLanes> frame_;
  std::optional<TurningModes> turning_;           ///< where there is a frame
  LaneArray deforming_viscous_, deforming_rate_;  ///< in a floating frame: a1 y + 2 s + a3 q, s

  Motion mode_;                 ///< y
  Motion rest_;                 ///< G f at the nodes
  Motion force_;                ///< f
  LaneArray base_;              ///< y at t + theta dt without contact
  LaneArray rest_base_;         ///< G f there
  LaneArray pushed_, yielded_;  ///< by the contact forces of the step: S' forces, G forces
  LaneArray by_modes_;          ///< S y at t + theta dt at the nodes
  std::vector<int> columns_;    ///< rows of nodes that contact forces act on in this step
  Mask running_{true};
  BookedWork deformed_;  ///< of the deformation on a body whose stiffness fades
  std::array<double, kLanes> start_energy_J_{};
  Lane force_sum_{0.0};    ///< of the present step, |components|
  Lane strained_by_{0.0};  ///< for which the strain was measured last
  Lane largest_strain_{0.0}, largest_cell_rotation_{0.0};
  LaneArray strain_, strain_of_rest_;
};

}  // namespace unbruised
