#pragma once

/// @file
/// Yield of single springs of a network, all lanes at once: f = k (e_0 + e - e_p), |f| <= F_y + h k p, with the
/// elongation e_0 it is mounted with, e since then, and plastic elongation e_p as initial elongation on the
/// right-hand side and p its accumulated amount (docs/theory.md, "Permanent deformation").

#include <vector>

#include "core/body/body_model.hpp"
#include "core/material/material.hpp"

namespace unbruised {

class SpringPlasticity final : public Material {
 public:
  /// @param body outlives it
  explicit SpringPlasticity(const BodyModel& body);

  void load(int lane, const Scenario& scenario) override;
  void archive(LaneArchive& lane) override;
  [[nodiscard]] const LaneArray* load_theta() const override { return &load_theta_; }
  void begin_step() override {}
  /// Return mapping of every spring. Plastic strain: accumulated plastic elongation over rest length.
  Mask update(const LaneArray& u_theta, const Mask& active) override;
  void end_step(const WilsonTheta& wilson, const Mask& running) override;

  /// sum 1/2 k e_p^2 - k e_0 e_p.
  [[nodiscard]] double self_energy(int lane) const override;
  [[nodiscard]] std::vector<double> plastic_load_N(int lane) const override;
  [[nodiscard]] std::optional<double> volume_above_m3(int, double) const override { return std::nullopt; }

 private:
  /// @param begin_m displacements at which the clock starts, [3n]
  void yield_as_mounted(int lane, std::size_t i, const std::vector<double>& begin_m);

  const BodyModel& body_;
  const std::vector<SpringGeometry>& springs_;
  std::vector<int> yielding_spring_;  ///< springs with a finite yield force
  LaneArray elongation_, elongation_theta_, accumulated_, accumulated_theta_;
  LaneArray load_, load_theta_;
};

}  // namespace unbruised
