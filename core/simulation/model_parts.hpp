#pragma once

/// @file
/// The inside of a `Model`: everything scenarios of one factor key share, read-only once built.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/integration/sparse_cholesky.hpp"
#include "core/integration/static_equilibrium.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/supernodes.hpp"
#include "core/product/block_matrix.hpp"
#include "core/product/lattice.hpp"
#include "core/product/lattice_stiffness.hpp"
#include "core/product/network.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised {

struct Model::Parts {
  std::string key;  ///< factor_key of every scenario this model is for
  std::size_t particle_count = 0;
  std::vector<std::array<double, 3>> position_m;
  std::vector<double> mass_kg;
  std::vector<std::array<bool, 3>> fixed;
  double total_mass_kg = 0;
  std::array<double, 3> center_of_mass_m{};
  /// Inverse of the inertia tensor about the centre of mass (pseudo-inverse), row-major.
  std::array<double, 9> inverse_inertia{};

  BlockMatrix K;
  BlockMatrix C;                   ///< empty for lattices: C = relaxation_time_s K
  double relaxation_time_s = 0.0;  ///< lattices, and networks that can yield

  std::optional<Lattice> lattice;
  std::optional<CellStiffness> cell;
  std::vector<SpringGeometry> springs;  ///< networks
  std::vector<double> rest_force_N;     ///< networks, [3n]

  std::optional<WilsonTheta> wilson;
  SupernodalFactor factor;
  std::vector<int> slot;  ///< freedom (3 per particle) -> elimination position, -1: fixed
  ContactModel contact;
  std::unique_ptr<StaticSolver> statics;  ///< lattices, and networks that can yield
  double max_frequency_Hz = 0;
};

}  // namespace unbruised
