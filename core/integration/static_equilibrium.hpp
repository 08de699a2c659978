#pragma once

/// @file
/// Static shapes of a product: at rest on its support, and what plastic strain alone leaves.

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/integration/sparse_cholesky.hpp"
#include "core/lanes/supernodes.hpp"
#include "core/product/block_matrix.hpp"

namespace unbruised {

/// The static state of a product that lies on the support.
struct StaticRest {
  std::vector<double> displacement_m;  ///< [3n]
  std::vector<double> normal_force_N;  ///< per contact candidate, zero but on the support
  std::vector<double> penetration_m;   ///< of the particle into the layer of the support, per contact candidate
};

/// Solves K u = f where nothing or not everything is held. K alone may be singular (rigid motions, mechanisms), so
/// K + s M is factored with a shift s far below every elastic mode, and the shift's own force is taken out again
/// by iterative refinement. Immutable once built: any number of threads may ask it at a time.
class StaticSolver {
 public:
  /// @param mass_kg per particle
  /// @param freedom number of each freedom (3 per particle), -1 where it is fixed
  /// @param shift_1_s2 square of an angular frequency far below the slowest elastic mode
  static std::unique_ptr<StaticSolver> build(const BlockMatrix& K, std::vector<double> mass_kg,
                                             std::vector<int> freedom, double shift_1_s2,
                                             const ContactModel& contact, std::string& error);

  /// The shape that forces leave, zero at fixed freedoms; on a body that nothing holds they must be in balance,
  /// and the rigid motion is arbitrary. f and result of shape [3n].
  [[nodiscard]] std::vector<double> free_shape(std::span<const double> force_N) const;

  /// Equilibrium under gravity along -z on a frictionless support with a compliant layer.
  /// @param gravity_m_s2 magnitude along -z
  /// @param layer_stiffness_N_m3 stiffness of the support's layer per area
  [[nodiscard]] StaticRest rest_on_support(const ContactModel& contact, double gravity_m_s2,
                                           double layer_stiffness_N_m3) const;

 private:
  StaticSolver() = default;
  void fill_support_compliance(const ContactModel& contact);
  [[nodiscard]] std::vector<double> shifted_solve(std::span<const double> force_N) const;

  SupernodalFactor factor_;
  std::vector<double> mass_kg_;
  std::vector<int> slot_;  ///< freedom (3 per particle) -> elimination position, -1: fixed
  double shift_ = 0;
  std::vector<int> support_candidate_;      ///< candidates on the support
  std::vector<double> support_compliance_;  ///< of the shifted matrix, normal freedoms, [k, k]
};

/// Lower entries of K + mass_factor M; `freedom` numbers the free freedoms (3 per particle, -1: left out).
std::vector<MatrixEntry> shifted_entries(const BlockMatrix& K, std::span<const double> mass_kg, double mass_factor,
                                         std::span<const int> freedom);

}  // namespace unbruised
