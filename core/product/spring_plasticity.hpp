#pragma once

/// @file
/// Yield of single springs of a network, all lanes at once: f = k (e - e_p), |f| <= F_y + h k p, with plastic
/// elongation e_p as initial elongation on the right-hand side and p its accumulated amount (docs/theory.md,
/// "Permanent deformation").

#include <vector>

#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/product/network.hpp"

namespace unbruised {

class SpringPlasticity {
 public:
  SpringPlasticity(const std::vector<SpringGeometry>& springs, std::size_t particle_count);

  void load(int lane);
  /// The load of the plastic elongations at t + theta dt so far, rows 3 x particle + axis.
  [[nodiscard]] const LaneArray& load_theta() const { return load_theta_; }
  /// Return mapping of every spring; the lanes that must be solved again.
  Mask update(const LaneArray& u_theta, const Mask& active);
  void end_step(const WilsonTheta& wilson, const Mask& running);

  [[nodiscard]] bool exists() const { return !yielding_spring_.empty(); }
  /// Largest accumulated plastic elongation over rest length.
  [[nodiscard]] const Lane& largest_plastic_strain() const { return largest_plastic_; }
  [[nodiscard]] const Lane& plastic_work() const { return plastic_work_; }
  [[nodiscard]] const Lane& hardening_energy() const { return hardening_energy_; }
  /// sum 1/2 k e_p^2 of one lane.
  [[nodiscard]] double self_energy(int lane) const;
  [[nodiscard]] std::vector<double> plastic_load_N(int lane) const;

 private:
  const std::vector<SpringGeometry>& springs_;
  std::vector<int> yielding_spring_;  ///< springs with a finite yield force
  LaneArray elongation_, elongation_theta_, accumulated_, accumulated_theta_;
  LaneArray load_, load_theta_;
  Lane largest_plastic_{0.0}, plastic_work_{0.0}, hardening_energy_{0.0};
};

}  // namespace unbruised
