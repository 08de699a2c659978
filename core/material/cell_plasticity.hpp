#pragma once

/// @file
/// J2 plasticity with linear hardening at the cells of a lattice, all lanes at once. Plastic strain is an initial
/// strain, a load on the right-hand side, V B^T D e_p; the factor never changes (docs/theory.md, "Permanent
/// deformation").
///
/// Yield: sqrt(3/2 s:s) <= Y + H p, s = 2 G dev(e - e_p), p the accumulated equivalent plastic strain, and
/// H = E E_t / (E - E_t), so that uniaxial loading past yield has the tangent modulus E_t.
///
/// Where the stiffness fades, s is the stress that is left: every branch remembers e - e_p in place of e, as the
/// displacement that `RelaxingRows` have and a plastic strain q_p of its own here.

#include <optional>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/body/booked_work.hpp"
#include "core/body/relaxing_rows.hpp"
#include "core/material/material.hpp"

namespace unbruised {

class CellPlasticity final : public Material {
 public:
  /// @param body a lattice; outlives it
  CellPlasticity(const BodyModel& body, const WilsonTheta& wilson, ProductFrame frame);

  void load(int lane, const Scenario& scenario) override;
  void archive(LaneArchive& lane) override;
  [[nodiscard]] const LaneArray* load_theta() const override { return &load_theta_; }
  void settle(int lane, const LaneArray& u) override;
  void begin_step(const LaneArray& u) override;
  [[nodiscard]] const LaneArray* remembered() const override {
    return relaxation_ ? &relaxation_->remembered() : nullptr;
  }
  void book_power(const LaneArray& rate, const LaneArray& stiffness_rate, const Mask& running) override;
  /// Return mapping of every cell.
  Mask update(const LaneArray& u_theta, const Mask& active) override;
  void end_step(const LaneArray& u, const WilsonTheta& wilson, const Mask& running) override;

  /// 1/2 V e_p D e_p summed over the cells; where the stiffness fades, what of the elastic energy is gone with it.
  [[nodiscard]] double self_energy(int lane, const LaneArray& u) const override;
  [[nodiscard]] double relaxed_J(int lane, const LaneArray& u) const override;
  [[nodiscard]] std::vector<double> plastic_load_N(int lane) const override;
  [[nodiscard]] bool flows() const override { return relaxation_ && relaxation_->step().flows(); }
  [[nodiscard]] LastingShape lasting(int lane, const LaneArray& u) const override;
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
  /// First row of a corner.
  [[nodiscard]] std::size_t row_of(std::size_t cell, int corner) const {
    return 3 * static_cast<std::size_t>(lattice_.cell[cell][static_cast<std::size_t>(corner)]);
  }
  void mean_gradient(const Lane (&u)[8], Lane (&gradient)[3]) const;
  void map_cell(std::size_t cell, const LaneArray& u_theta, const Mask& active, Largest& largest);
  void add_load(std::size_t cell, const Lane (&stress)[6], LaneArray& load) const;
  void remember(std::size_t cell);
  [[nodiscard]] double strain_energy(int lane, const LaneArray& strain) const;
  [[nodiscard]] double elastic_energy(int lane, const LaneArray& u, const LaneArray& strain) const;
  [[nodiscard]] double faded_energy(int lane, const LaneArray& u) const;
  [[nodiscard]] std::vector<double> load_of(int lane, const LaneArray& strain) const;

  const BodyModel& body_;
  const Lattice& lattice_;
  double time_step_s_;
  double gradient_[3];  ///< 1 / (4 h)
  double volume_m3_;
  struct CellMaterial {
    Lane shear_modulus{1.0};
    Lane yield_stress{1e300}, hardening{0.0};
  };
  [[nodiscard]] const CellMaterial& material_of(std::size_t cell) const {
    return material_[body_.material_of(cell)];
  }
  std::vector<CellMaterial> material_;
  std::vector<unsigned char> touched_;  ///< cell has plastic strain in some lane
  bool has_load_ = false;               ///< with relaxation: some cell had at the start of the step
  LaneArray strain_, strain_theta_;     ///< plastic, 6 per cell, Voigt xx yy zz yz xz xy, tensor shears
  LaneArray accumulated_, accumulated_theta_;
  LaneArray load_, load_theta_;
  bool flowing_ = false;
  bool may_yield_ = true;  ///< any lane
  bool measures_rotation_;
  // Where the stiffness fades.
  std::optional<RelaxingRows> relaxation_;
  BookedWork deformed_;                   ///< what the deformation does on the body
  double share_ = 1.0;                    ///< of the stiffness at t + theta dt
  std::vector<LaneArray> branch_strain_;  ///< q_p of each branch, rows as of strain_
  LaneArray past_strain_;                 ///< sum g (exp(-theta dt / tau) q_p - xi e_p)
  std::array<double, kLanes> start_energy_J_{};
};

}  // namespace unbruised
