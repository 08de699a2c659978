#pragma once

/// @file
/// Sound scenarios in which every number of the parameters exists.

#include <cmath>

#include "core/scenario/number_fields.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised::testing {

/// A gripped box of usual values, with every limit set.
inline Scenario usual_grip() {
  Scenario scenario;
  LatticeParameters product;
  product.mass_kg = 0.1;
  product.youngs_modulus_Pa = 1e6;
  product.yield_stress_Pa = 1e5;
  product.tangent_modulus_Pa = 2e5;
  product.loss_ratio = 0.2;
  product.at_frequency_Hz = 50.0;
  scenario.product = product;
  scenario.gripper = ParallelJawParameters{};
  scenario.limits.permanent_set_m = 1e-4;
  scenario.limits.plastic_strain = 0.01;
  scenario.limits.bruised_volume_m3 = 1e-7;
  scenario.limits.peak_pressure_Pa = 5e4;
  scenario.limits.absorbed_energy_J = 0.05;
  scenario.limits.finger_force_N = 20.0;
  scenario.limits.contact_yield_ratio = 1.0;
  return scenario;
}

/// A wall, a mass, a spring that can yield, a load.
inline Scenario usual_network() {
  Scenario scenario;
  NetworkParameters network;
  NetworkParticle wall;
  wall.fixed = {true, true, true};
  NetworkParticle particle;
  particle.position_m = {1.0, 0.0, 0.0};
  particle.mass_kg = 2.0;
  NetworkSpring spring;
  spring.between = {0, 1};
  spring.stiffness_N_m = 100.0;
  spring.yield_force_N = 3.0;
  network.particle = {wall, particle};
  network.spring = {spring};
  network.load = {{1, {0.0, 1.0}, {{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}}};
  scenario.product = network;
  scenario.cell.support = false;
  scenario.simulation.duration_s = 1.0;
  return scenario;
}

inline LatticeParameters& lattice_in(Scenario& s) { return std::get<LatticeParameters>(s.product); }
inline NetworkParameters& network_in(Scenario& s) { return std::get<NetworkParameters>(s.product); }

inline void set(NumberSlot slot, double value) {
  if (auto* const* number = std::get_if<double*>(&slot)) {
    **number = value;
  } else if (auto* const* maybe = std::get_if<std::optional<double>*>(&slot)) {
    **maybe = value;
  } else if (std::isfinite(value)) {
    *std::get<int*>(slot) = static_cast<int>(value);
  }
}

}  // namespace unbruised::testing
