#pragma once

/// @file
/// J2 plasticity with linear hardening at the cells of a lattice, all lanes at once. Plastic strain is an initial
/// strain, a load on the right-hand side, V B^T D e_p; the factor never changes (docs/theory.md, "Permanent
/// deformation").
///
/// Yield: sqrt(3/2 s:s) <= Y + H p, s = 2 G dev(e - e_p), p the accumulated equivalent plastic strain, and
/// H = E E_t / (E - E_t), so that uniaxial loading past yield has the tangent modulus E_t.

#include <vector>

#include "core/body/lattice.hpp"
#include "core/body/lattice_stiffness.hpp"
#include "core/material/material.hpp"

namespace unbruised {

class CellPlasticity final : public Material {
 public:
  CellPlasticity(const Lattice& lattice, const CellStiffness& cell, ProductFrame frame);

  void load(int lane, const Scenario& scenario) override;
  void archive(LaneArchive& lane) override;
  [[nodiscard]] const LaneArray* load_theta() const override { return &load_theta_; }
  void begin_step() override;
  /// Return mapping of every cell.
  Mask update(const LaneArray& u_theta, const Mask& active) override;
  void end_step(const WilsonTheta& wilson, const Mask& running) override;

  /// 1/2 V e_p D e_p summed over the cells.
  [[nodiscard]] double self_energy(int lane) const override;
  [[nodiscard]] std::vector<double> plastic_load_N(int lane) const override;
  [[nodiscard]] std::optional<double> volume_above_m3(int lane, double threshold) const override;
  [[nodiscard]] std::vector<double> cell_strain(int lane) const override { return of_lane(strain_, lane); }
  [[nodiscard]] std::vector<double> accumulated_cell_strain(int lane) const override {
    return of_lane(accumulated_, lane);
  }

 private:
  /// Of all cells, at t + theta dt.
  struct Largest {
    Lane flow{0.0}, strain2{0.0}, rotation2{0.0};  ///< change of plastic strain; squares
  };
  void mean_gradient(std::size_t cell, const LaneArray& u_theta, Lane (&gradient)[3][3]) const;
  void map_cell(std::size_t cell, const LaneArray& u_theta, const Mask& active, Largest& largest);
  void add_load(std::size_t cell, const Lane (&stress)[6]);

  const Lattice& lattice_;
  double gradient_[3];  ///< 1 / (4 h)
  double volume_m3_;
  Lane shear_modulus_{1.0};
  Lane yield_stress_{1e300}, hardening_{0.0};
  std::vector<unsigned char> touched_;  ///< cell has plastic strain in some lane
  LaneArray strain_, strain_theta_;     ///< plastic, 6 per cell, Voigt xx yy zz yz xz xy, tensor shears
  LaneArray accumulated_, accumulated_theta_;
  LaneArray load_, load_theta_;
  bool flowing_ = false;
  bool measures_rotation_;
};

}  // namespace unbruised
