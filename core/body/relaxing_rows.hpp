#pragma once

/// @file
/// The memory of a body whose stiffness fades, all lanes at once. All its moduli fade alike, so that a branch
/// remembers a displacement q for every row of displacements, of particles or of modes, and its force is g K q:
/// what all branches remember at t + theta dt is one displacement, which K multiplies with what it multiplies
/// anyway (docs/theory.md, "Relaxation and creep").

#include <vector>

#include "core/body/relaxation_step.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

class RelaxingRows {
 public:
  /// @param step outlives it; has branches
  RelaxingRows(const RelaxationStep& step, std::size_t rows);

  void load(int lane);
  /// A body that has a long-term modulus has stood for long, one that flows has been laid down just now.
  void settle(int lane, const LaneArray& u);
  void begin_step(const LaneArray& u);
  /// Moves q to t + dt. @param u the displacement there
  void end_step(const LaneArray& u, const Mask& running);

  [[nodiscard]] const RelaxationStep& step() const { return step_; }
  /// sum g (exp(-theta dt / tau) q - xi u).
  [[nodiscard]] const LaneArray& remembered() const { return remembered_; }
  /// g_inf u + sum g q at the start of the step.
  [[nodiscard]] const LaneArray& stressed() const { return stressed_; }
  /// q of a branch.
  [[nodiscard]] const LaneArray& branch(std::size_t i) const { return q_[i]; }
  /// By how much the body has flowed: u - sum g tau q / sum g tau, of all rows.
  [[nodiscard]] std::vector<double> flowed_m(int lane, const LaneArray& u) const;

  /// All that one lane has from step to step.
  void archive(LaneArchive& lane) {
    for (LaneArray& q : q_) lane(q);
  }

 private:
  const RelaxationStep& step_;
  std::vector<LaneArray> q_;                   ///< of each branch
  LaneArray remembered_, u_start_, stressed_;  ///< of a step
};

}  // namespace unbruised
