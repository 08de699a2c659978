#include "core/integration/static_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "core/lanes/lane.hpp"
#include "core/lanes/lane_solve.hpp"

namespace unbruised {
namespace {

/// Each refinement shrinks the shift's influence on elastic modes by shift / omega^2 < 1e-3.
constexpr int kRefinements = 4;
/// Passes over the touching places of the support; a few suffice.
constexpr int kMaxPasses = 100;

}  // namespace

std::vector<MatrixEntry> shifted_entries(const BlockMatrix& K, std::span<const double> mass_kg, double mass_factor,
                                         std::span<const int> freedom) {
  std::vector<MatrixEntry> entries;
  entries.reserve(K.value.size() / 2 + 3 * mass_kg.size());
  for (int i = 0; i < K.particle_count; ++i) {
    for (int p = K.row_start[i]; p < K.row_start[i + 1]; ++p) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const int row = freedom[3 * static_cast<std::size_t>(i) + r];
          const int column = freedom[3 * static_cast<std::size_t>(K.column[p]) + c];
          if (row < 0 || column < 0 || row < column) continue;
          double value = K.value[9 * static_cast<std::size_t>(p) + 3 * r + c];
          if (row == column) value += mass_factor * mass_kg[i];
          entries.push_back({row, column, value});
        }
      }
    }
  }
  return entries;
}

std::unique_ptr<StaticSolver> StaticSolver::build(const BlockMatrix& K, std::vector<double> mass_kg,
                                                  std::vector<int> freedom, double shift_1_s2,
                                                  const ContactModel& contact, std::string& error) {
  std::unique_ptr<StaticSolver> self(new StaticSolver());
  self->mass_kg_ = std::move(mass_kg);
  self->shift_ = shift_1_s2;
  const auto free = static_cast<int>(freedom.size()) - static_cast<int>(std::ranges::count(freedom, -1));
  const SymmetricMatrix matrix =
      symmetric_from_entries(free, shifted_entries(K, self->mass_kg_, self->shift_, freedom));
  const auto factor = SparseCholesky::factor(matrix, error);
  if (!factor) return nullptr;
  self->factor_ = pack_supernodes(factor->extract());
  self->slot_ = elimination_positions(self->factor_, freedom);
  self->fill_support_compliance(contact);
  return self;
}

void StaticSolver::fill_support_compliance(const ContactModel& contact) {
  std::vector<int> slot;  // of the candidates' normal freedoms
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    if (contact.candidate[c].surface != static_cast<int>(Surface::support)) continue;
    support_candidate_.push_back(static_cast<int>(c));
    slot.push_back(slot_[3 * static_cast<std::size_t>(contact.candidate[c].node) + 2]);
  }
  const std::size_t k = slot.size();
  support_compliance_.resize(k * k);
  LaneArray x(static_cast<std::size_t>(factor_.size));
  for (std::size_t first = 0; first < k; first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, k - first);
    x.fill(0.0);
    for (std::size_t j = 0; j < count; ++j) {
      if (slot[first + j] >= 0) x.at(static_cast<std::size_t>(slot[first + j]), static_cast<int>(j)) = 1.0;
    }
    solve_forward(factor_, x.data());
    solve_backward(factor_, x.data());
    for (std::size_t i = 0; i < k; ++i) {
      if (slot[i] < 0) continue;
      for (std::size_t j = 0; j < count; ++j) {
        support_compliance_[i * k + first + j] = x.at(static_cast<std::size_t>(slot[i]), static_cast<int>(j));
      }
    }
  }
}

std::vector<double> StaticSolver::shifted_solve(std::span<const double> force_N) const {
  // One lane of all: these solves are few.
  LaneArray x(static_cast<std::size_t>(factor_.size));
  x.fill(0.0);
  for (std::size_t i = 0; i < force_N.size(); ++i) {
    if (slot_[i] >= 0) x.at(static_cast<std::size_t>(slot_[i]), 0) = force_N[i];
  }
  solve_forward(factor_, x.data());
  solve_backward(factor_, x.data());
  std::vector<double> displacement(force_N.size(), 0.0);
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    if (slot_[i] >= 0) displacement[i] = x.at(static_cast<std::size_t>(slot_[i]), 0);
  }
  return displacement;
}

std::vector<double> StaticSolver::free_shape(std::span<const double> force_N) const {
  std::vector<double> u = shifted_solve(force_N);
  std::vector<double> load(force_N.begin(), force_N.end());
  for (int round = 0; round < kRefinements; ++round) {
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = force_N[i] + shift_ * mass_kg_[i / 3] * u[i];
    u = shifted_solve(load);
  }
  return u;
}

/// Layer of one candidate at penetration p: stiffness of the touching places and their mean relief, so that
/// N = stiffness (p - relief).
struct LayerSecant {
  double stiffness = 0;
  double relief = 0;
  int touching = 0;
};

LayerSecant layer_at(const ContactCandidate& candidate, double layer_stiffness_N_m3, double penetration_m) {
  LayerSecant secant;
  double sum = 0.0;
  for (double relief : candidate.relief_m) {
    if (penetration_m <= relief) continue;
    ++secant.touching;
    sum += relief;
  }
  if (secant.touching == 0) return secant;
  secant.stiffness = normal_stiffness_N_m(candidate, layer_stiffness_N_m3) * secant.touching / kReliefPlaces;
  secant.relief = sum / secant.touching;
  return secant;
}

StaticRest StaticSolver::rest_on_support(const ContactModel& contact, double gravity_m_s2,
                                         double layer_stiffness_N_m3) const {
  const std::size_t size = 3 * mass_kg_.size();
  const std::size_t k = support_candidate_.size();
  StaticRest rest;
  rest.displacement_m.assign(size, 0.0);
  rest.normal_force_N.assign(contact.candidate.size(), 0.0);
  rest.penetration_m.assign(contact.candidate.size(), 0.0);
  if (k == 0 || gravity_m_s2 <= 0.0) return rest;
  const auto candidate = [&](std::size_t i) -> const ContactCandidate& {
    return contact.candidate[static_cast<std::size_t>(support_candidate_[i])];
  };
  const auto freedom = [&](std::size_t i) { return 3 * static_cast<std::size_t>(candidate(i).node) + 2; };
  std::vector<double> force(k, 0.0), penetration(k);
  std::vector<LayerSecant> layer(k);
  // Starts pressed in by the depth at which the layer of the whole body's footprint would carry it, at least.
  double weight = 0.0, area = 0.0;
  for (double mass : mass_kg_) weight += mass * gravity_m_s2;
  for (std::size_t i = 0; i < k; ++i) area += candidate(i).area_m2;
  for (std::size_t i = 0; i < k; ++i) {
    penetration[i] = 4.0 * weight / (area * layer_stiffness_N_m3) - candidate(i).surface_m;
    layer[i] = layer_at(candidate(i), layer_stiffness_N_m3, penetration[i]);
  }
  std::vector<double> load(size, 0.0);
  for (int round = 0; round <= kRefinements; ++round) {
    for (std::size_t i = 0; i < size; ++i) {
      load[i] = shift_ * mass_kg_[i / 3] * rest.displacement_m[i];
      if (i % 3 == 2) load[i] -= mass_kg_[i / 3] * gravity_m_s2;
    }
    const std::vector<double> free = shifted_solve(load);
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      std::vector<std::size_t> active;
      for (std::size_t i = 0; i < k; ++i) {
        if (layer[i].touching > 0) active.push_back(i);
      }
      const auto count = static_cast<Eigen::Index>(active.size());
      Eigen::MatrixXd A(count, count);
      Eigen::VectorXd b(count);
      for (Eigen::Index r = 0; r < count; ++r) {
        const std::size_t i = active[static_cast<std::size_t>(r)];
        for (Eigen::Index c = 0; c < count; ++c) {
          A(r, c) = support_compliance_[i * k + active[static_cast<std::size_t>(c)]];
        }
        A(r, r) += 1.0 / layer[i].stiffness;
        b[r] = -(candidate(i).surface_m + free[freedom(i)] + layer[i].relief);
      }
      const Eigen::VectorXd x = A.ldlt().solve(b);
      std::fill(force.begin(), force.end(), 0.0);
      for (Eigen::Index r = 0; r < count; ++r) force[active[static_cast<std::size_t>(r)]] = x[r];
      bool changed = false;
      for (std::size_t i = 0; i < k; ++i) {
        penetration[i] = -(candidate(i).surface_m + free[freedom(i)]);
        for (std::size_t j = 0; j < k; ++j) penetration[i] -= support_compliance_[i * k + j] * force[j];
        const LayerSecant next = layer_at(candidate(i), layer_stiffness_N_m3, penetration[i]);
        changed = changed || next.touching != layer[i].touching;
        layer[i] = next;
      }
      // Nothing touches: the guess lifted the body off; press the lowest places again.
      if (std::all_of(layer.begin(), layer.end(), [](const LayerSecant& l) { return l.touching == 0; })) {
        for (std::size_t i = 0; i < k; ++i) {
          layer[i] = layer_at(candidate(i), layer_stiffness_N_m3, 1e-6 - candidate(i).surface_m);
        }
      }
      if (!changed) break;
    }
    for (std::size_t i = 0; i < k; ++i) load[freedom(i)] += std::max(0.0, force[i]);
    rest.displacement_m = shifted_solve(load);
  }
  for (std::size_t i = 0; i < k; ++i) {
    const auto at = static_cast<std::size_t>(support_candidate_[i]);
    rest.normal_force_N[at] = std::max(0.0, force[i]);
    rest.penetration_m[at] = penetration[i];
  }
  return rest;
}

}  // namespace unbruised
