#include "core/body/static_solver.hpp"

#include <algorithm>

#include "core/algebra/lane_solve.hpp"
#include "core/algebra/shifted_entries.hpp"
#include "core/algebra/supernodal_cholesky.hpp"
#include "core/door/require.hpp"

namespace unbruised {

std::unique_ptr<StaticSolver> StaticSolver::build(const BlockMatrix& K, std::vector<double> mass_kg,
                                                  const std::vector<int>& freedom, double shift_1_s2,
                                                  std::string& error) {
  std::unique_ptr<StaticSolver> self(new StaticSolver());
  self->mass_kg_ = std::move(mass_kg);
  self->shift_ = shift_1_s2;
  const auto free = static_cast<int>(freedom.size()) - static_cast<int>(std::ranges::count(freedom, -1));
  const SymmetricMatrix matrix =
      symmetric_from_entries(free, shifted_entries(K, self->mass_kg_, self->shift_, freedom));
  auto factor = factor_supernodes(matrix, error);
  if (!factor) return nullptr;
  self->factor_ = std::move(*factor);
  self->slot_ = elimination_positions(self->factor_, freedom);
  return self;
}

void StaticSolver::shifted_solve(const LaneArray& force_N, LaneArray& displacement_m) const {
  require(force_N.rows() == slot_.size() && displacement_m.rows() == slot_.size(),
          "StaticSolver: forces on another body");
  LaneArray x(static_cast<std::size_t>(factor_.size));
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    if (slot_[i] >= 0) x.put(static_cast<std::size_t>(slot_[i]), force_N.get(i));
  }
  solve_forward(factor_, x.data());
  solve_backward(factor_, x.data());
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    displacement_m.put(i, slot_[i] >= 0 ? x.get(static_cast<std::size_t>(slot_[i])) : Lane(0.0));
  }
}

std::vector<double> StaticSolver::shifted_solve(std::span<const double> force_N) const {
  // One lane of all: these solves are few.
  LaneArray force(force_N.size()), displacement(slot_.size());
  for (std::size_t i = 0; i < force_N.size(); ++i) force.at(i, 0) = force_N[i];
  shifted_solve(force, displacement);
  std::vector<double> of_lane(force_N.size());
  for (std::size_t i = 0; i < of_lane.size(); ++i) of_lane[i] = displacement.at(i, 0);
  return of_lane;
}

std::vector<double> StaticSolver::compliance(std::span<const std::size_t> freedoms) const {
  for (std::size_t freedom : freedoms) require(freedom < slot_.size(), "StaticSolver: there is no such freedom");
  const std::size_t k = freedoms.size();
  std::vector<double> compliance(k * k, 0.0);
  LaneArray x(static_cast<std::size_t>(factor_.size));
  for (std::size_t first = 0; first < k; first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, k - first);
    x.fill(0.0);
    for (std::size_t j = 0; j < count; ++j) {
      const int slot = slot_[freedoms[first + j]];
      if (slot >= 0) x.at(static_cast<std::size_t>(slot), static_cast<int>(j)) = 1.0;
    }
    solve_forward(factor_, x.data());
    solve_backward(factor_, x.data());
    for (std::size_t i = 0; i < k; ++i) {
      const int slot = slot_[freedoms[i]];
      if (slot < 0) continue;
      for (std::size_t j = 0; j < count; ++j) {
        compliance[i * k + first + j] = x.at(static_cast<std::size_t>(slot), static_cast<int>(j));
      }
    }
  }
  return compliance;
}

std::vector<double> StaticSolver::free_shape(std::span<const double> force_N) const {
  std::vector<double> u = shifted_solve(force_N);
  std::vector<double> load(force_N.begin(), force_N.end());
  for (int round = 0; round < kStaticRefinements; ++round) {
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = force_N[i] + shift_ * mass_kg_[i / 3] * u[i];
    u = shifted_solve(load);
  }
  return u;
}

}  // namespace unbruised
