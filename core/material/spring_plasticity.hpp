#pragma once

/// @file
/// Yield of single springs of a network, all lanes at once: f = k (e_0 + e - e_p), |f| <= F_y + h k p, with the
/// elongation e_0 it is mounted with, e since then, and plastic elongation e_p as initial elongation on the
/// right-hand side and p its accumulated amount (docs/theory.md, "Permanent deformation").
///
/// And springs whose stiffness fades: f = k (g_inf x + sum g q), x = e_0 + e - e_p, q what each branch remembers
/// of x. They begin as if just mounted and moved, with q = x.

#include <vector>

#include "core/body/body_model.hpp"
#include "core/material/material.hpp"

namespace unbruised {

class SpringPlasticity final : public Material {
 public:
  /// @param body outlives it
  SpringPlasticity(const BodyModel& body, const WilsonTheta& wilson);

  void load(int lane, const Scenario& scenario) override;
  void archive(LaneArchive& lane) override;
  [[nodiscard]] const LaneArray* load_theta() const override { return &load_theta_; }
  void settle(int lane, const LaneArray& u) override;
  void begin_step(const LaneArray& u) override;
  /// Return mapping of every spring. Plastic strain: accumulated plastic elongation over rest length.
  Mask update(const LaneArray& u_theta, const Mask& active) override;
  void end_step(const LaneArray& u, const WilsonTheta& wilson, const Mask& running) override;

  /// sum 1/2 k e_p^2 - k e_0 e_p, and what of the elastic energy is gone with the stiffness that has faded.
  [[nodiscard]] double self_energy(int lane, const LaneArray& u) const override;
  [[nodiscard]] double relaxed_J(int lane, const LaneArray&) const override { return relaxed_[lane]; }
  [[nodiscard]] bool flows() const override { return flows_; }
  /// Where springs that flow have flowed to, beside plastic elongations.
  [[nodiscard]] LastingShape lasting(int lane, const LaneArray& u) const override;
  [[nodiscard]] std::vector<double> plastic_load_N(int lane) const override;
  [[nodiscard]] std::optional<double> volume_above_m3(int, double) const override { return std::nullopt; }

 private:
  /// @param begin_m displacements at which the clock starts, [3n]
  void yield_as_mounted(int lane, std::size_t i, const std::vector<double>& begin_m);
  void end_branches(std::size_t i, const LaneArray& u, const WilsonTheta& wilson, const Mask& running);
  void pull(const SpringGeometry& spring, const Lane& force);
  [[nodiscard]] Lane elongation(const SpringGeometry& spring, const LaneArray& u) const;
  /// Forces along the springs as a load, [3n]. @param force_N of a spring by its index among those followed
  template <class Force>
  [[nodiscard]] std::vector<double> load_of(const Force& force_N) const;

  const BodyModel& body_;
  const std::vector<SpringGeometry>& springs_;
  std::vector<int> followed_;              ///< springs with a finite yield force, or a stiffness that fades
  std::vector<RelaxationStep> step_;       ///< of each of these
  std::vector<std::size_t> first_branch_;  ///< of each of these, in the rows of q_
  bool relaxes_ = false, flows_ = false;
  LaneArray stretch_, q_;  ///< x; of each branch
  LaneArray past_;         ///< of each spring in a step: sum g (exp(-theta dt / tau) q - xi x)
  Lane relaxed_{0.0};
  LaneArray elongation_, elongation_theta_, accumulated_, accumulated_theta_;
  LaneArray load_, load_theta_;
};

}  // namespace unbruised
