#pragma once

/// @file
/// Elastic bodies that hit the support: the energy they keep and the peak of the force.

#include <algorithm>
#include <cmath>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

/// A soft bar of 1 MPa and 1000 kg/m3: c = 31.6 m/s, 20 cm long, 2 cm x 2 cm, so E A / L = 2 kN/m and 80 g.
struct Bar {
  static constexpr double kModulus_Pa = 1e6, kDensity_kg_m3 = 1000.0, kLength_m = 0.2, kArea_m2 = 4e-4;
  static constexpr double kSpeed_m_s = 0.1;
  static double wave_speed_m_s() { return std::sqrt(kModulus_Pa / kDensity_kg_m3); }
  /// The wave runs up and down once.
  static double rigid_contact_s() { return 2.0 * kLength_m / wave_speed_m_s(); }
  static double rigid_peak_N() { return kDensity_kg_m3 * wave_speed_m_s() * kArea_m2 * kSpeed_m_s; }
};

/// The bar as a chain of masses along z, falling onto the support without gravity.
/// @param phase share of a step after which it touches
inline Scenario falling_bar(int masses, double layer_N_m, double time_step_s, double phase, double duration_s) {
  NetworkParameters network;
  const double spacing = Bar::kLength_m / masses;
  for (int i = 0; i < masses; ++i) {
    NetworkParticle particle;
    particle.position_m = {0.0, 0.0, phase * time_step_s * Bar::kSpeed_m_s + i * spacing};
    particle.mass_kg = Bar::kDensity_kg_m3 * Bar::kArea_m2 * spacing;
    particle.fixed = {true, true, false};
    particle.initial_velocity_m_s = {0.0, 0.0, -Bar::kSpeed_m_s};
    if (i == 0) particle.contact_stiffness_N_m = layer_N_m;
    network.particle.push_back(particle);
    if (i == 0) continue;
    NetworkSpring& spring = network.spring.emplace_back();
    spring.between = {i - 1, i};
    spring.stiffness_N_m = Bar::kModulus_Pa * Bar::kArea_m2 / spacing;
  }
  Scenario scenario;
  scenario.product = network;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.simulation.time_step_s = time_step_s;
  scenario.simulation.duration_s = duration_s;
  return scenario;
}

struct Impact {
  double peak_N = 0;
  double most_energy = 0;  ///< largest on the way / before
  double last_energy = 0;  ///< after the rebound / before
  double contact_s = 0;    ///< from the first to the last contact force
};

inline Impact measure_impact(const Scenario& scenario) {
  Trace trace;
  run(scenario, &trace);
  const std::vector<double> force = column(trace, "support_force_N", 2);
  const std::vector<double> energy = column(trace, "stored_energy_J");
  Impact impact;
  impact.peak_N = largest(force);
  impact.most_energy = largest(energy) / energy.front();
  impact.last_energy = energy.back() / energy.front();
  double first = -1.0, last = 0.0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    EXPECT_GE(force[k], 0.0);
    if (!(force[k] > 1e-3 * impact.peak_N)) continue;
    if (first < 0.0) first = trace.time_s[k];
    last = trace.time_s[k];
  }
  impact.contact_s = last - first;
  EXPECT_LT(force.back(), 1e-3 * impact.peak_N) << "it has not left yet";
  return impact;
}

/// The worst of several phases between step and touch: largest peak and energies.
inline Impact worst_bar_impact(int masses, double layer_N_m, double contact_s, double steps_per_contact) {
  const double dt = contact_s / steps_per_contact;
  Impact worst;
  for (double phase : {0.1, 0.35, 0.6, 0.85}) {
    const double duration = std::ceil((3.0 * contact_s) / dt + 8.0) * dt;
    const Impact one = measure_impact(falling_bar(masses, layer_N_m, dt, phase, duration));
    worst.peak_N = std::max(worst.peak_N, one.peak_N);
    worst.most_energy = std::max(worst.most_energy, one.most_energy);
    worst.last_energy = std::max(worst.last_energy, one.last_energy);
    worst.contact_s = std::max(worst.contact_s, one.contact_s);
  }
  return worst;
}

}  // namespace unbruised::testing
