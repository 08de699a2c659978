#include "core/body/body_state.hpp"

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// All of it moves at one speed.
void write_motion(const LatticeParameters& lattice, const BodyModel& body, BodyState& state) {
  for (std::size_t i = 0; i < 3 * body.particle_count; ++i) {
    state.velocity_m_s[i] = lattice.initial_velocity_m_s[i % 3];
  }
}

void write_motion(const NetworkParameters& network, const BodyModel& body, BodyState& state) {
  require(network.particle.size() == body.particle_count, "written_state: the particles of another body");
  for (std::size_t i = 0; i < 3 * body.particle_count; ++i) {
    const std::size_t p = i / 3, axis = i % 3;
    if (body.fixed[p][axis]) continue;
    state.displacement_m[i] = network.particle[p].initial_displacement_m[axis];
    state.velocity_m_s[i] = network.particle[p].initial_velocity_m_s[axis];
  }
}

std::vector<double> load_of(const LatticeParameters&, const BodyModel& body, double /*time_s*/,
                            JumpSide /*side*/) {
  return std::vector<double>(3 * body.particle_count, 0.0);
}

std::vector<double> load_of(const NetworkParameters& network, const BodyModel&, double time_s, JumpSide side) {
  return network_load_N(network, time_s, side);
}

}  // namespace

BodyState written_state(const ProductParameters& product, const BodyModel& body) {
  const std::vector<double> zero(3 * body.particle_count, 0.0);
  BodyState state{zero, zero, zero, {}};
  std::visit([&](const auto& kind) { write_motion(kind, body, state); }, product);
  return state;
}

std::vector<double> written_load_N(const ProductParameters& product, const BodyModel& body, double time_s,
                                   JumpSide side) {
  return std::visit([&](const auto& kind) { return load_of(kind, body, time_s, side); }, product);
}

}  // namespace unbruised
