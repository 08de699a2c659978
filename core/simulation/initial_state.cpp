#include "core/simulation/initial_state.hpp"

#include <span>

namespace unbruised {

InitialState InitialStates::of(const Scenario& scenario, const std::vector<double>& plastic_load_N) {
  if (const auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
    return of_lattice(*lattice, scenario.cell);
  }
  return {of_network(std::get<NetworkParameters>(scenario.product), scenario, plastic_load_N), nullptr};
}

InitialState InitialStates::of_lattice(const LatticeParameters& lattice, const CellParameters& cell) {
  const std::size_t freedoms = 3 * model_.body.particle_count;
  const double down = -cell.gravity_m_s2[2];
  const bool rests = cell.support && down > 0.0;
  InitialState state{
      {std::vector<double>(freedoms, 0.0), std::vector<double>(freedoms), std::vector<double>(freedoms)}, nullptr};
  if (rests) {
    const std::array<double, 2> key = {down, cell.support_modulus_Pa / cell.support_thickness_m};
    if (key != rest_key_) {
      rest_ = model_.rest->under_gravity(key[0], key[1]);
      rest_key_ = key;
    }
    state.body.displacement_m = rest_.displacement_m;
    state.rest = &rest_;
  }
  for (std::size_t i = 0; i < freedoms; ++i) {
    const std::size_t axis = i % 3;
    state.body.velocity_m_s[i] = lattice.initial_velocity_m_s[axis];
    state.body.acceleration_m_s2[i] = rests && axis == 2 ? 0.0 : cell.gravity_m_s2[axis];
  }
  return state;
}

BodyState InitialStates::of_network(const NetworkParameters& network, const Scenario& scenario,
                                    const std::vector<double>& plastic_load_N) const {
  const BodyModel& body = model_.body;
  const std::size_t freedoms = 3 * body.particle_count;
  BodyState state{std::vector<double>(freedoms, 0.0), std::vector<double>(freedoms, 0.0),
                  std::vector<double>(freedoms, 0.0)};
  for (std::size_t i = 0; i < freedoms; ++i) {
    const std::size_t p = i / 3, axis = i % 3;
    if (body.fixed[p][axis]) continue;
    state.displacement_m[i] = network.particle[p].initial_displacement_m[axis];
    state.velocity_m_s[i] = network.particle[p].initial_velocity_m_s[axis];
  }
  if (scenario.simulation.initial_acceleration == InitialAcceleration::zero) return state;
  // M a = f - C v - K u, with what springs that yield as they are mounted keep.
  const std::vector<double> load = network_load_N(network, 0.0);
  std::vector<double> elastic(freedoms), damping(freedoms);
  multiply(body.K, std::span<const double>(state.displacement_m), std::span<double>(elastic));
  multiply(body.C, std::span<const double>(state.velocity_m_s), std::span<double>(damping));
  for (std::size_t i = 0; i < freedoms; ++i) {
    if (body.slot[i] < 0) continue;
    const double force = load[i] + body.rest_force_N[i] + plastic_load_N[i] - elastic[i] - damping[i];
    state.acceleration_m_s2[i] = force / body.mass_kg[i / 3] + scenario.cell.gravity_m_s2[i % 3];
  }
  return state;
}

}  // namespace unbruised
