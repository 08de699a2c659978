#pragma once

/// @file
/// J2 plasticity with linear hardening at the cells of a lattice, all lanes at once. Plastic strain is an initial
/// strain, a load on the right-hand side, V B^T D e_p; the factor never changes (docs/theory.md, "Permanent
/// deformation").
///
/// Yield: sqrt(3/2 s:s) <= Y + H p, s = 2 G dev(e - e_p), p the accumulated equivalent plastic strain, and
/// H = E E_t / (E - E_t), so that uniaxial loading past yield has the tangent modulus E_t.

#include <vector>

#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/product/lattice.hpp"
#include "core/product/lattice_stiffness.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

class CellPlasticity {
 public:
  CellPlasticity(const Lattice& lattice, const CellStiffness& cell);

  void load(int lane, const LatticeParameters& parameters);

  /// The load of the plastic strain that holds at t + theta dt so far, rows 3 x particle + axis.
  [[nodiscard]] const LaneArray& load_theta() const { return load_theta_; }

  /// Starts a step from the plastic strain at t.
  void begin_step();

  /// Return mapping of every cell for the displacement at t + theta dt, in the lanes of `active`.
  /// @return the lanes whose plastic strain still moved by more than the tolerance: they must be solved again
  Mask update(const LaneArray& u_theta, const Mask& active);

  /// Moves the plastic strain to t + dt in the lanes of `running`.
  void end_step(const WilsonTheta& wilson, const Mask& running);

  /// Largest strain, sqrt(e:e), of any cell at the last update.
  [[nodiscard]] const Lane& largest_strain() const { return largest_strain_; }
  /// Largest accumulated plastic strain of any cell.
  [[nodiscard]] const Lane& largest_plastic_strain() const { return largest_plastic_; }
  /// Plastic work since load, and the part of it that hardening stores, [J].
  [[nodiscard]] const Lane& plastic_work() const { return plastic_work_; }
  [[nodiscard]] const Lane& hardening_energy() const { return hardening_energy_; }
  /// Energy of the plastic strains themselves, 1/2 V e_p D e_p summed over the cells of one lane: with it the
  /// elastic energy is 1/2 u K u - u f_p + this.
  [[nodiscard]] double self_energy(int lane) const;
  /// Volume of the cells with more accumulated plastic strain than `threshold`.
  [[nodiscard]] double volume_above(int lane, double threshold) const;
  /// The load of the present plastic strain of one lane, [3n].
  [[nodiscard]] std::vector<double> plastic_load_N(int lane) const;

 private:
  void map_cell(std::size_t cell, const LaneArray& u_theta, const Mask& active, Lane& change, Lane& strain2);
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
  Lane largest_strain_{0.0}, largest_plastic_{0.0}, plastic_work_{0.0}, hardening_energy_{0.0};
};

}  // namespace unbruised
