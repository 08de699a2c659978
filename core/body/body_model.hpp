#pragma once

/// @file
/// The product as everything that fixes its factored matrix: particles, K, C, M, the factor, static shapes.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/algebra/block_matrix.hpp"
#include "core/algebra/supernodes.hpp"
#include "core/body/lattice.hpp"
#include "core/body/lattice_stiffness.hpp"
#include "core/body/network.hpp"
#include "core/body/relaxation_step.hpp"
#include "core/body/static_solver.hpp"
#include "core/body/true_masses.hpp"
#include "core/integration/wilson_theta.hpp"

namespace unbruised {

/// Read-only once built; shared by all lanes and threads.
struct BodyModel {
  /// A solid has an inside and a shape: it starts undeformed, at rest where it has a support, and its strain and
  /// rotation must stay small. Else there are only particles, which start as their parameters say.
  bool is_solid = false;
  std::size_t particle_count = 0;
  std::vector<std::array<double, 3>> position_m;
  std::vector<double> mass_kg;
  std::vector<std::array<bool, 3>> fixed;
  double total_mass_kg = 0;
  std::array<double, 3> center_of_mass_m{};
  /// Inverse of the inertia tensor about the centre of mass (pseudo-inverse), row-major.
  std::array<double, 9> inverse_inertia{};

  BlockMatrix K;                   ///< instantaneous
  BlockMatrix C;                   ///< empty for lattices: C = relaxation_time_s K
  double relaxation_time_s = 0.0;  ///< lattices
  RelaxationStep relaxation;       ///< lattices; springs have their own
  std::optional<Lattice> lattice;
  std::vector<CellStiffness> cell;      ///< of each material; lattices
  std::vector<int> material;            ///< of each cell; empty: all are of the first
  std::vector<SpringGeometry> springs;  ///< networks
  std::vector<double> rest_force_N;     ///< networks, [3n]

  SupernodalFactor factor;  ///< of K at t + theta dt + a0 M + a1 C; of a body that moves by modes empty
  std::vector<int> slot;    ///< freedom (3 per particle) -> elimination position, -1: fixed
  /// Of K as it rests; solids, and networks that can yield or flow.
  std::shared_ptr<const StaticSolver> statics;
  double max_frequency_Hz = 0;  ///< Gershgorin bound on the fastest mode

  /// Is any freedom held?
  [[nodiscard]] bool is_anchored() const;
  /// Smallest extent of a solid's particles [m]; of a network, which has no body to measure closeness with, so
  /// large that all its few contacts are near.
  [[nodiscard]] double smallest_extent_m() const;
  [[nodiscard]] std::size_t material_of(std::size_t cell_number) const {
    return material.empty() ? 0 : static_cast<std::size_t>(material[cell_number]);
  }
  /// Middle of a lattice's true shape; of a network the centre of mass.
  [[nodiscard]] const std::array<double, 3>& center_m() const {
    return lattice ? lattice->center_m : center_of_mass_m;
  }
};

/// Is the matrix of a step asked for?
enum class BodyUse { by_particles, by_modes };

/// Assembles and factors. @return nothing, with `error` set, when the matrix cannot be factored.
/// @param statics of the same product, which do not depend on the step; null: they are made
/// @throws std::invalid_argument for products that break a rule
std::optional<BodyModel> build_body(const ProductParameters& product, const WilsonTheta& wilson,
                                    std::string& error, MassSpread spread = MassSpread::cells,
                                    std::shared_ptr<const StaticSolver> statics = nullptr,
                                    BodyUse use = BodyUse::by_particles);

/// A lattice whose particles on its side -x are held.
std::optional<BodyModel> build_held_body(const LatticeParameters& parameters, const WilsonTheta& wilson,
                                         std::string& error);

}  // namespace unbruised
