#pragma once

/// @file
/// The memory of a lattice whose stiffness fades, all lanes at once. All its moduli fade alike, so that a branch
/// remembers a displacement q of every particle and its force is g K q: what all branches remember at t + theta dt
/// is one displacement, which K multiplies with what it multiplies anyway (docs/theory.md, "Relaxation and
/// creep").

#include <array>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

class LatticeRelaxation {
 public:
  /// @param body outlives it; its relaxation has branches
  explicit LatticeRelaxation(const BodyModel& body);

  void load(int lane);
  /// A body that has a long-term modulus has stood for long, one that flows has been laid down just now.
  void settle(int lane, const LaneArray& u);
  void begin_step(const LaneArray& u);
  /// Moves q to t + dt. @param u the displacement there
  void end_step(const LaneArray& u, const Mask& running);

  /// Books the work that the deformation does on the body.
  /// @param plastic_load at the start of the step
  void book_power(double time_step_s, const LaneArray& rate, const LaneArray& stiffness_rate,
                  const LaneArray& plastic_load, const Mask& running);
  /// Since load.
  [[nodiscard]] double work_J(int lane) const { return work_[lane] + 0.5 * last_step_s_[lane] * power_[lane]; }

  [[nodiscard]] const RelaxationStep& step() const { return step_; }
  /// sum g (exp(-theta dt / tau) q - xi u).
  [[nodiscard]] const LaneArray& remembered() const { return remembered_; }
  /// q of a branch.
  [[nodiscard]] const LaneArray& branch(std::size_t i) const { return q_[i]; }
  /// By how much the body has flowed: u - sum g tau q / sum g tau, [3n].
  [[nodiscard]] std::vector<double> flowed_m(int lane, const LaneArray& u) const;

  /// All that one lane has from step to step.
  void archive(LaneArchive& lane) {
    for (LaneArray& q : q_) lane(q);
    lane(work_, power_, last_step_s_);
  }

 private:
  const RelaxationStep& step_;
  std::vector<LaneArray> q_;                   ///< of each branch, [3n]
  LaneArray remembered_, u_start_, stressed_;  ///< of a step; the last is g_inf u + sum g q at its start
  Lane work_{0.0}, power_{0.0};
  Lane last_step_s_{0.0};  ///< 0: not stepped yet
};

}  // namespace unbruised
