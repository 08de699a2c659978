#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Dense>

#include "core/lanes/lane.hpp"
#include "core/simulation/model_parts.hpp"

namespace unbruised {
namespace {

double relaxation_time(const LatticeParameters& parameters) {
  if (parameters.relaxation_time_s) return *parameters.relaxation_time_s;
  if (parameters.loss_ratio && parameters.at_frequency_Hz) {
    return *parameters.loss_ratio / (2.0 * std::numbers::pi * *parameters.at_frequency_Hz);
  }
  return 0.0;
}

void add_lattice(const LatticeParameters& parameters, const Scenario& scenario, Model::Parts& parts) {
  parts.lattice = build_lattice(parameters);
  parts.cell =
      cell_stiffness(parameters.youngs_modulus_Pa, parameters.poisson_ratio, parts.lattice->cell_extent_m);
  parts.K = assemble_stiffness(*parts.lattice, *parts.cell);
  parts.relaxation_time_s = relaxation_time(parameters);
  parts.position_m = parts.lattice->position_m;
  parts.mass_kg = parts.lattice->mass_kg;
  parts.fixed.assign(parts.position_m.size(), {false, false, false});
  parts.contact = lattice_contact(parameters, *parts.lattice, scenario.simulation.pressure_patch_m);
}

void add_network(const NetworkParameters& parameters, Model::Parts& parts) {
  NetworkSystem system = build_network(parameters);
  parts.K = std::move(system.K);
  parts.C = std::move(system.C);
  parts.position_m = std::move(system.position_m);
  parts.mass_kg = std::move(system.mass_kg);
  parts.fixed = std::move(system.fixed);
  parts.springs = std::move(system.springs);
  parts.rest_force_N = std::move(system.rest_force_N);
  parts.contact = network_contact(parameters);
}

/// Mass, centre of mass and inverse inertia of the particles.
void add_inertia(Model::Parts& parts) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < parts.particle_count; ++i) {
    parts.total_mass_kg += parts.mass_kg[i];
    moment += parts.mass_kg[i] * Eigen::Map<const Eigen::Vector3d>(parts.position_m[i].data());
  }
  const Eigen::Vector3d center = moment / parts.total_mass_kg;
  Eigen::Map<Eigen::Vector3d>(parts.center_of_mass_m.data()) = center;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < parts.particle_count; ++i) {
    const Eigen::Vector3d r = Eigen::Map<const Eigen::Vector3d>(parts.position_m[i].data()) - center;
    inertia += parts.mass_kg[i] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(inertia);
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.eigenvalues()[k];
    if (value > 1e-12 * eigen.eigenvalues().maxCoeff()) inverse[k] = 1.0 / value;
  }
  const Eigen::Matrix3d result = eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  std::copy_n(result.data(), 9, parts.inverse_inertia.begin());
}

/// Numbers the free freedoms; returns how many there are.
int number_freedoms(const Model::Parts& parts, std::vector<int>& freedom) {
  int count = 0;
  freedom.assign(3 * parts.particle_count, -1);
  for (std::size_t i = 0; i < parts.particle_count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!parts.fixed[i][axis]) freedom[3 * i + axis] = count++;
    }
  }
  return count;
}

/// Gershgorin's bound: omega_max^2 <= max_i sum_j |K_ij| / m_i over the free freedoms.
double frequency_bound(const Model::Parts& parts, const std::vector<int>& freedom) {
  double largest = 0.0;
  for (int i = 0; i < parts.K.particle_count; ++i) {
    for (std::size_t r = 0; r < 3; ++r) {
      if (freedom[3 * static_cast<std::size_t>(i) + r] < 0) continue;
      double sum = 0.0;
      for (int p = parts.K.row_start[i]; p < parts.K.row_start[i + 1]; ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
          if (freedom[3 * static_cast<std::size_t>(parts.K.column[p]) + c] < 0) continue;
          sum += std::abs(parts.K.value[9 * static_cast<std::size_t>(p) + 3 * r + c]);
        }
      }
      largest = std::max(largest, sum / parts.mass_kg[i]);
    }
  }
  return std::sqrt(largest) / (2.0 * std::numbers::pi);
}

/// Does a network have springs with a yield force?
bool can_yield(const Model::Parts& parts) {
  return std::any_of(parts.springs.begin(), parts.springs.end(),
                     [](const SpringGeometry& spring) { return std::isfinite(spring.yield_force); });
}

/// Square of a frequency far below every elastic mode that yet holds rigid motions well above round-off: for a
/// product a gripper can grasp 0.16 Hz, for a network, whose scale can be any, a thirty-thousandth of its fastest
/// frequency.
double static_shift(const Model::Parts& parts) {
  if (parts.lattice) return 1.0;
  const double omega = 2.0 * std::numbers::pi * parts.max_frequency_Hz;
  return omega > 0.0 ? 1e-9 * omega * omega : 1.0;  // springs between walls only: no elastic mode to stay below
}

/// K + a0 M + a1 C, factored and packed.
bool factor_effective_stiffness(Model::Parts& parts, std::vector<int>& freedom, std::string& error) {
  const int count = number_freedoms(parts, freedom);
  if (count == 0) {
    error = "the product has no freedom that can move";
    return false;
  }
  const WilsonTheta& w = *parts.wilson;
  BlockMatrix effective = parts.K;
  for (std::size_t p = 0; p < effective.value.size(); ++p) {
    const double damping = parts.C.value.empty() ? parts.relaxation_time_s * parts.K.value[p] : parts.C.value[p];
    effective.value[p] += w.a1 * damping;
  }
  const auto entries = shifted_entries(effective, parts.mass_kg, w.a0, freedom);
  const auto factor = SparseCholesky::factor(symmetric_from_entries(count, entries), error);
  if (!factor) return false;
  parts.factor = pack_supernodes(factor->extract());
  parts.slot = elimination_positions(parts.factor, freedom);
  parts.max_frequency_Hz = frequency_bound(parts, freedom);
  return true;
}

}  // namespace

Model::Model() : parts_(std::make_unique<Parts>()) {}
Model::~Model() = default;

std::shared_ptr<const Model> Model::build(const Scenario& scenario, std::string& error) {
  std::shared_ptr<Model> model(new Model());
  Parts& parts = *model->parts_;
  parts.key = factor_key(scenario);
  try {
    if (const auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
      add_lattice(*lattice, scenario, parts);
    } else {
      add_network(std::get<NetworkParameters>(scenario.product), parts);
    }
  } catch (const std::invalid_argument& refused) {
    error = refused.what();
    return nullptr;
  }
  parts.particle_count = parts.position_m.size();
  parts.wilson.emplace(scenario.simulation.time_step_s, scenario.simulation.theta);
  add_inertia(parts);
  std::vector<int> freedom;
  if (!factor_effective_stiffness(parts, freedom, error)) return nullptr;
  fill_compliance(parts.factor, parts.slot, parts.contact);
  if (parts.lattice || can_yield(parts)) {
    parts.statics =
        StaticSolver::build(parts.K, parts.mass_kg, std::move(freedom), static_shift(parts), parts.contact, error);
    if (!parts.statics) return nullptr;
  }
  return model;
}

std::size_t Model::particle_count() const { return parts_->particle_count; }
std::size_t Model::freedom_count() const { return static_cast<std::size_t>(parts_->factor.size); }
std::size_t Model::contact_candidate_count() const { return parts_->contact.candidate.size(); }
std::size_t Model::factor_entry_count() const { return parts_->factor.entry_count; }
double Model::max_frequency_Hz() const { return parts_->max_frequency_Hz; }

std::size_t Model::memory_bytes() const {
  const Parts& p = *parts_;
  const std::size_t doubles = p.K.value.size() + p.C.value.size() + p.factor.value.size() +
                              p.contact.compliance.size() +
                              4 * p.factor.entry_count / 2;  // the static factor, about as large, with its indices
  return doubles * sizeof(double);
}

std::size_t Model::lane_memory_bytes() const {
  const Parts& p = *parts_;
  const std::size_t cells = p.lattice ? p.lattice->cell.size() : p.springs.size();
  return sizeof(double) * (14 * 3 * p.particle_count + 14 * cells + 40 * p.contact.candidate.size());
}

}  // namespace unbruised
