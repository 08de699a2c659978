#include <cstring>

#include "core/contact/contact_model.hpp"
#include "core/product/lattice.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised {
namespace {

/// Appends values as bytes; equal bytes mean equal keys.
class KeyWriter {
 public:
  void add(double value) {
    value += 0.0;  // -0 and 0 are the same
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    key_.append(bytes, sizeof value);
  }
  void add(const std::optional<double>& value) {
    add(value ? 1.0 : 0.0);
    add(value.value_or(0.0));
  }
  template <std::size_t N>
  void add(const std::array<double, N>& values) {
    for (double value : values) add(value);
  }
  [[nodiscard]] std::string take() { return std::move(key_); }

 private:
  std::string key_;
};

void add_lattice(const LatticeParameters& p, KeyWriter& key) {
  key.add(static_cast<double>(p.shape));
  key.add(p.size_m);
  key.add(static_cast<double>(p.axis));
  key.add(p.cell_size_m);
  key.add(p.mass_kg);
  key.add(p.density_kg_m3);
  key.add(p.youngs_modulus_Pa);
  key.add(p.poisson_ratio);
  key.add(p.relaxation_time_s);
  key.add(p.loss_ratio);
  key.add(p.at_frequency_Hz);
}

void add_network(const NetworkParameters& p, KeyWriter& key) {
  for (const NetworkParticle& particle : p.particle) {
    key.add(particle.position_m);
    key.add(particle.mass_kg);
    for (bool fixed : particle.fixed) key.add(fixed ? 1.0 : 0.0);
    key.add(particle.contact_stiffness_N_m);
  }
  for (const NetworkSpring& spring : p.spring) {
    key.add(static_cast<double>(spring.between[0]));
    key.add(static_cast<double>(spring.between[1]));
    key.add(spring.stiffness_N_m);
    key.add(spring.damping_N_s_m);
    key.add(spring.rest_length_m);
    key.add(spring.yield_force_N);
    key.add(spring.hardening_ratio);
  }
}

}  // namespace

std::string factor_key(const Scenario& scenario) {
  KeyWriter key;
  key.add(static_cast<double>(scenario.product.index()));
  if (const auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
    add_lattice(*lattice, key);
  } else {
    add_network(std::get<NetworkParameters>(scenario.product), key);
  }
  key.add(scenario.simulation.time_step_s);
  key.add(scenario.simulation.theta);
  key.add(scenario.simulation.pressure_patch_m);
  return key.take();
}

ModelSize model_size(const Scenario& scenario) {
  ModelSize size;
  if (const auto* parameters = std::get_if<LatticeParameters>(&scenario.product)) {
    const Lattice lattice = build_lattice(*parameters);
    size.particle_count = lattice.position_m.size();
    size.freedom_count = 3 * size.particle_count;
    size.contact_candidate_count =
        lattice_contact(*parameters, lattice, scenario.simulation.pressure_patch_m).candidate.size();
    return size;
  }
  const auto& network = std::get<NetworkParameters>(scenario.product);
  size.particle_count = network.particle.size();
  for (const NetworkParticle& particle : network.particle) {
    for (bool fixed : particle.fixed) size.freedom_count += fixed ? 0 : 1;
    size.contact_candidate_count += particle.contact_stiffness_N_m > 0.0 ? 1 : 0;
  }
  return size;
}

}  // namespace unbruised
