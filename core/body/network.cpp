#include "core/body/network.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace unbruised {
namespace {

double distance_m(const std::array<double, 3>& d) { return std::hypot(d[0], d[1], d[2]); }

SpringGeometry spring_geometry(const NetworkParameters& parameters, std::size_t index) {
  const NetworkSpring& spring = parameters.spring[index];
  const auto [a, b] = spring.between;
  const int particles = static_cast<int>(parameters.particle.size());
  if (a < 0 || b < 0 || a >= particles || b >= particles) {
    throw std::invalid_argument("build_network: spring " + std::to_string(index) + " joins no particle");
  }
  std::array<double, 3> d{};
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = parameters.particle[b].position_m[k] - parameters.particle[a].position_m[k];
  }
  const double distance = distance_m(d);
  if (!(distance > 0.0) || !std::isfinite(distance)) {
    throw std::invalid_argument("build_network: spring " + std::to_string(index) + " has no length");
  }
  SpringGeometry geometry;
  geometry.a = a;
  geometry.b = b;
  geometry.direction = {d[0] / distance, d[1] / distance, d[2] / distance};
  geometry.stiffness = instantaneous_stiffness_N_m(spring);
  geometry.rest_length = spring.rest_length_m.value_or(distance);
  geometry.initial_elongation = distance - geometry.rest_length;
  geometry.yield_force = spring.yield_force_N.value_or(geometry.yield_force);
  geometry.hardening_ratio = spring.hardening_ratio;
  geometry.branch = relaxation_branches(spring);
  return geometry;
}

/// Springs that flow give way to all that do not.
void share_rest(std::vector<SpringGeometry>& springs) {
  constexpr double kFlowing = 1e-6;
  const bool all_flow = std::ranges::all_of(
      springs, [](const SpringGeometry& spring) { return spring.flows() || spring.stiffness == 0.0; });
  for (SpringGeometry& spring : springs) {
    if (!spring.branch.empty()) {
      spring.rest_share = spring.flows() ? (all_flow ? 1.0 : kFlowing) : long_term_share(spring.branch);
    }
  }
}

/// Tension k (distance - rest length) of the undisplaced spring, as load on its ends.
void add_rest_force(const SpringGeometry& spring, std::vector<double>& force) {
  const double tension = spring.stiffness * spring.initial_elongation;
  for (std::size_t k = 0; k < 3; ++k) {
    force[3 * static_cast<std::size_t>(spring.a) + k] += tension * spring.direction[k];
    force[3 * static_cast<std::size_t>(spring.b) + k] -= tension * spring.direction[k];
  }
}

/// The value of one load; std::lerp is exact at both ends and for equal values.
std::array<double, 3> load_at(const NetworkLoad& load, double t, JumpSide side) {
  const std::vector<double>& time = load.time_s;
  // The first point that lies after t (right), or not before t (left).
  const auto next = side == JumpSide::right ? std::upper_bound(time.begin(), time.end(), t)
                                            : std::lower_bound(time.begin(), time.end(), t);
  if (next == time.begin()) return load.force_N.front();
  if (next == time.end()) return load.force_N.back();
  const auto i = static_cast<std::size_t>(next - time.begin());
  const double w = (t - time[i - 1]) / (time[i] - time[i - 1]);
  std::array<double, 3> force{};
  for (std::size_t k = 0; k < 3; ++k) force[k] = std::lerp(load.force_N[i - 1][k], load.force_N[i][k], w);
  return force;
}

}  // namespace

void add_axial(BlockMatrixBuilder& builder, const SpringGeometry& spring, double coefficient) {
  std::array<double, 9> plus{};
  std::array<double, 9> minus{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s < 3; ++s) {
      plus[3 * r + s] = coefficient * (spring.direction[r] * spring.direction[s]);
      minus[3 * r + s] = -plus[3 * r + s];
    }
  }
  builder.add(spring.a, spring.a, plus);
  builder.add(spring.b, spring.b, plus);
  builder.add(spring.a, spring.b, minus);
  builder.add(spring.b, spring.a, minus);
}

bool can_yield(const std::vector<SpringGeometry>& springs) {
  return std::any_of(springs.begin(), springs.end(),
                     [](const SpringGeometry& spring) { return std::isfinite(spring.yield_force); });
}

bool can_relax(const std::vector<SpringGeometry>& springs) {
  return std::any_of(springs.begin(), springs.end(),
                     [](const SpringGeometry& spring) { return !spring.branch.empty(); });
}

NetworkSystem build_network(const NetworkParameters& parameters) {
  const int particles = static_cast<int>(parameters.particle.size());
  NetworkSystem system;
  for (const NetworkParticle& particle : parameters.particle) {
    system.position_m.push_back(particle.position_m);
    system.mass_kg.push_back(particle.mass_kg);
    system.fixed.push_back(particle.fixed);
  }
  system.rest_force_N.assign(3 * parameters.particle.size(), 0.0);
  BlockMatrixBuilder stiffness(particles);
  BlockMatrixBuilder damping(particles);
  for (std::size_t i = 0; i < parameters.spring.size(); ++i) {
    const SpringGeometry spring = spring_geometry(parameters, i);
    add_axial(stiffness, spring, spring.stiffness);
    add_axial(damping, spring, parameters.spring[i].damping_N_s_m);
    if (parameters.spring[i].rest_length_m) add_rest_force(spring, system.rest_force_N);
    system.springs.push_back(spring);
  }
  share_rest(system.springs);
  system.K = stiffness.build();
  system.C = damping.build();
  return system;
}

std::vector<double> network_load_N(const NetworkParameters& parameters, double time_s, JumpSide side) {
  std::vector<double> force(3 * parameters.particle.size(), 0.0);
  for (const NetworkLoad& load : parameters.load) {
    if (load.particle < 0 || load.particle >= static_cast<int>(parameters.particle.size())) {
      throw std::invalid_argument("network_load_N: a load acts on no particle");
    }
    if (load.time_s.empty() || load.time_s.size() != load.force_N.size()) {
      throw std::invalid_argument("network_load_N: a load needs points, as many times as forces");
    }
    const std::array<double, 3> value = load_at(load, time_s, side);
    for (std::size_t k = 0; k < 3; ++k) force[3 * static_cast<std::size_t>(load.particle) + k] += value[k];
  }
  return force;
}

}  // namespace unbruised
