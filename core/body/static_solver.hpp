#pragma once

/// @file
/// Static shapes of a product under given forces, such as what plastic strain alone leaves.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/algebra/block_matrix.hpp"
#include "core/algebra/supernodes.hpp"
#include "core/lanes/lane.hpp"

namespace unbruised {

/// Each refinement shrinks the influence of the shift on elastic modes by shift / omega^2 < 1e-3.
inline constexpr int kStaticRefinements = 4;

/// Solves K u = f where nothing or not everything is held. K alone may be singular (rigid motions, mechanisms), so
/// K + s M is factored with a shift s far below every elastic mode, and the shift's own force is taken out again
/// by iterative refinement. Immutable once built: any number of threads may ask it at a time.
class StaticSolver {
 public:
  /// @param mass_kg per particle
  /// @param freedom number of each freedom (3 per particle), -1 where it is fixed
  /// @param shift_1_s2 square of an angular frequency far below the slowest elastic mode
  static std::unique_ptr<StaticSolver> build(const BlockMatrix& K, std::vector<double> mass_kg,
                                             const std::vector<int>& freedom, double shift_1_s2,
                                             std::string& error);

  /// The shape that forces leave, zero at fixed freedoms; on a body that nothing holds they must be in balance,
  /// and the rigid motion is arbitrary. f and result of shape [3n].
  [[nodiscard]] std::vector<double> free_shape(std::span<const double> force_N) const;

  /// (K + shift M)^-1 f, [3n]; zero at fixed freedoms.
  [[nodiscard]] std::vector<double> shifted_solve(std::span<const double> force_N) const;
  /// The same for all lanes; rows 3 x particle + axis of both.
  void shifted_solve(const LaneArray& force_N, LaneArray& displacement_m) const;
  /// The entries of (K + shift M)^-1 in these freedoms (3 x particle + axis), row-major [k, k]; zero where one is
  /// fixed.
  [[nodiscard]] std::vector<double> compliance(std::span<const std::size_t> freedoms) const;

  [[nodiscard]] double shift_1_s2() const { return shift_; }
  [[nodiscard]] const std::vector<double>& mass_kg() const { return mass_kg_; }

 private:
  StaticSolver() = default;
  SupernodalFactor factor_;
  std::vector<double> mass_kg_;
  std::vector<int> slot_;  ///< freedom (3 per particle) -> elimination position, -1: fixed
  double shift_ = 0;
};

}  // namespace unbruised
