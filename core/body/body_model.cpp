#include "core/body/body_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/algebra/shifted_entries.hpp"
#include "core/algebra/supernodal_cholesky.hpp"
#include "core/body/layers.hpp"
#include "core/door/eigen.hpp"

namespace unbruised {
namespace {

double relaxation_time(const LatticeParameters& parameters) {
  if (parameters.relaxation_time_s) return *parameters.relaxation_time_s;
  if (parameters.loss_ratio && parameters.at_frequency_Hz) {
    return *parameters.loss_ratio / (2.0 * std::numbers::pi * *parameters.at_frequency_Hz);
  }
  return 0.0;
}

void add_product(const LatticeParameters& parameters, MassSpread spread, const WilsonTheta& wilson,
                 BodyModel& body) {
  body.is_solid = true;
  body.lattice = build_lattice(parameters);
  body.cell = material_cells(parameters, body.lattice->cell_extent_m);
  body.material = cell_materials(parameters, *body.lattice);
  body.K = assemble_stiffness(*body.lattice, body.cell, body.material, cell_skins(parameters, *body.lattice));
  body.relaxation_time_s = relaxation_time(parameters);
  body.relaxation = relaxation_step(relaxation_branches(parameters), wilson);
  body.position_m = body.lattice->position_m;
  body.mass_kg = spread == MassSpread::cells ? body.lattice->mass_kg : true_masses(parameters, *body.lattice);
  body.fixed.assign(body.position_m.size(), {false, false, false});
}

void add_product(const NetworkParameters& parameters, MassSpread, const WilsonTheta&, BodyModel& body) {
  NetworkSystem system = build_network(parameters);
  body.K = std::move(system.K);
  body.C = std::move(system.C);
  body.position_m = std::move(system.position_m);
  body.mass_kg = std::move(system.mass_kg);
  body.fixed = std::move(system.fixed);
  body.springs = std::move(system.springs);
  body.rest_force_N = std::move(system.rest_force_N);
}

/// Mass, centre of mass and inverse inertia of the particles.
void add_inertia(BodyModel& body) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < body.particle_count; ++i) {
    body.total_mass_kg += body.mass_kg[i];
    moment += body.mass_kg[i] * Eigen::Map<const Eigen::Vector3d>(body.position_m[i].data());
  }
  const Eigen::Vector3d center = moment / body.total_mass_kg;
  Eigen::Map<Eigen::Vector3d>(body.center_of_mass_m.data()) = center;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < body.particle_count; ++i) {
    const Eigen::Vector3d r = Eigen::Map<const Eigen::Vector3d>(body.position_m[i].data()) - center;
    inertia += body.mass_kg[i] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(inertia);
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.eigenvalues()[k];
    if (value > 1e-12 * eigen.eigenvalues().maxCoeff()) inverse[k] = 1.0 / value;
  }
  const Eigen::Matrix3d result = eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  std::copy_n(result.data(), 9, body.inverse_inertia.begin());
}

/// Numbers the free freedoms; returns how many there are.
int number_freedoms(const BodyModel& body, std::vector<int>& freedom) {
  int count = 0;
  freedom.assign(3 * body.particle_count, -1);
  for (std::size_t i = 0; i < body.particle_count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!body.fixed[i][axis]) freedom[3 * i + axis] = count++;
    }
  }
  return count;
}

/// Gershgorin's bound: omega_max^2 <= max_i sum_j |K_ij| / m_i over the free freedoms.
double frequency_bound(const BodyModel& body, const std::vector<int>& freedom) {
  double largest = 0.0;
  for (int i = 0; i < body.K.particle_count; ++i) {
    for (std::size_t r = 0; r < 3; ++r) {
      if (freedom[3 * static_cast<std::size_t>(i) + r] < 0) continue;
      double sum = 0.0;
      for (int p = body.K.row_start[i]; p < body.K.row_start[i + 1]; ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
          if (freedom[3 * static_cast<std::size_t>(body.K.column[p]) + c] < 0) continue;
          sum += std::abs(body.K.value[9 * static_cast<std::size_t>(p) + 3 * r + c]);
        }
      }
      largest = std::max(largest, sum / body.mass_kg[i]);
    }
  }
  return std::sqrt(largest) / (2.0 * std::numbers::pi);
}

/// Square of a frequency far below every elastic mode that yet holds rigid motions well above round-off: for a
/// product a gripper can grasp 0.16 Hz, for a network, whose scale can be any, a thirty-thousandth of its fastest
/// frequency.
double static_shift(const BodyModel& body) {
  if (body.is_solid) return 1.0;
  const double omega = 2.0 * std::numbers::pi * body.max_frequency_Hz;
  return omega > 0.0 ? 1e-9 * omega * omega : 1.0;  // springs between walls only: no elastic mode to stay below
}

BlockMatrix times(double factor, BlockMatrix matrix) {
  for (double& value : matrix.value) value *= factor;
  return matrix;
}

/// K at t + theta dt over what is remembered, which is a load.
BlockMatrix stiffness_theta(const BodyModel& body, const WilsonTheta& w) {
  if (!can_relax(body.springs)) return times(body.relaxation.stiffness_theta, body.K);
  return spring_matrix(body.particle_count, body.springs, [&w](const SpringGeometry& spring) {
    return relaxation_step(spring.branch, w).stiffness_theta;
  });
}

/// K once nothing fades any more.
BlockMatrix stiffness_at_rest(const BodyModel& body) {
  if (!can_relax(body.springs)) return times(body.relaxation.rest_share(), body.K);
  return spring_matrix(body.particle_count, body.springs,
                       [](const SpringGeometry& spring) { return spring.rest_share; });
}

/// A solid of no more is solved in double precision: half of so small a factor is no faster to go through.
constexpr int kFewFreedoms = 700;

/// K + a0 M + a1 C, factored and packed.
/// @param count of the freedoms that are numbered
bool factor_effective_stiffness(const WilsonTheta& w, int count, const std::vector<int>& freedom, BodyModel& body,
                                std::string& error) {
  BlockMatrix effective = stiffness_theta(body, w);
  for (std::size_t p = 0; p < effective.value.size(); ++p) {
    const double damping = body.C.value.empty() ? body.relaxation_time_s * body.K.value[p] : body.C.value[p];
    effective.value[p] += w.a1 * damping;
  }
  const auto entries = shifted_entries(effective, body.mass_kg, w.a0, freedom);
  auto factor = factor_supernodes(symmetric_from_entries(count, entries), error);
  if (!factor) return false;
  body.factor = std::move(*factor);
  body.slot = elimination_positions(body.factor, freedom);
  if (body.lattice && !body.is_anchored() && body.factor.size > kFewFreedoms) body.factor.round_values();
  return true;
}

}  // namespace

bool BodyModel::is_anchored() const {
  return std::any_of(fixed.begin(), fixed.end(), [](const auto& f) { return f[0] || f[1] || f[2]; });
}

double BodyModel::smallest_extent_m() const {
  if (!is_solid) return 1e6;
  std::array<double, 3> low = position_m.front(), high = low;
  for (const auto& p : position_m) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  return std::min({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

namespace {

/// What its particles, their masses and what holds them make of it.
std::optional<BodyModel> complete(BodyModel body, const WilsonTheta& wilson, BodyUse use, std::string& error) {
  body.particle_count = body.position_m.size();
  add_inertia(body);
  std::vector<int> freedom;
  const int count = number_freedoms(body, freedom);
  if (count == 0) {
    error = "the product has no freedom that can move";
    return std::nullopt;
  }
  body.max_frequency_Hz = frequency_bound(body, freedom);
  const bool factored =
      use == BodyUse::by_modes || factor_effective_stiffness(wilson, count, freedom, body, error);
  if (!factored) return std::nullopt;
  const bool rests = body.is_solid || can_yield(body.springs) || can_relax(body.springs);
  if (rests && !body.statics) {
    body.statics = StaticSolver::build(stiffness_at_rest(body), body.mass_kg, freedom, static_shift(body), error);
    if (!body.statics) return std::nullopt;
  }
  return body;
}

}  // namespace

std::optional<BodyModel> build_body(const ProductParameters& product, const WilsonTheta& wilson,
                                    std::string& error, MassSpread spread,
                                    std::shared_ptr<const StaticSolver> statics, BodyUse use) {
  BodyModel body;
  body.statics = std::move(statics);
  std::visit([&](const auto& kind) { add_product(kind, spread, wilson, body); }, product);
  return complete(std::move(body), wilson, use, error);
}

std::optional<BodyModel> build_held_body(const LatticeParameters& parameters, const WilsonTheta& wilson,
                                         std::string& error) {
  BodyModel body;
  add_product(parameters, MassSpread::cells, wilson, body);
  for (const SurfacePoint& point : body.lattice->side[0]) {
    body.fixed[static_cast<std::size_t>(point.node)] = {true, true, true};
  }
  return complete(std::move(body), wilson, BodyUse::by_particles, error);
}

}  // namespace unbruised
