#include "core/contact/contact_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "core/contact/layered_face.hpp"
#include "core/scenario/lattice_cells.hpp"

namespace unbruised {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Half a period of a mass that meets the face at this speed and is pressed with at least this force.
double half_period_s(const LayeredFace& face, double mass_kg, double speed_m_s, double least_force_N) {
  constexpr double kGravity_m_s2 = 9.80665;  // any start but zero serves
  double stiffness = face.stiffness_N_m(std::max(least_force_N, mass_kg * kGravity_m_s2));
  constexpr int kImpactIterations = 4;  // force and stiffness of a Hertz contact settle to per cents
  for (int i = 0; i < kImpactIterations; ++i) {
    stiffness = face.stiffness_N_m(std::max(least_force_N, speed_m_s * std::sqrt(mass_kg * stiffness)));
  }
  return std::numbers::pi * std::sqrt(mass_kg / stiffness);
}

/// With which the product meets the support; 0: it does not hit it.
double landing_speed_m_s(const Scenario& scenario, const LatticeParameters& product) {
  const double gravity_m_s2 = std::abs(scenario.cell.gravity_m_s2[2]);
  if (has_gripper(scenario)) return std::sqrt(2.0 * gravity_m_s2 * scenario.strategy.release_height_m);
  return std::abs(product.initial_velocity_m_s[2]);
}

double pad_time_s(const LatticeParameters& product, const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return kNever;
  return half_period_s(side_at_pad(product, *jaw, scenario.cell), jaw->finger_mass_kg,
                       scenario.strategy.approach_speed_m_s, scenario.strategy.grip_force_N);
}
double pad_time_s(const NetworkParameters&, const Scenario&) { return kNever; }

double landing_time_s(const LatticeParameters& product, const Scenario& scenario) {
  const double speed_m_s = landing_speed_m_s(scenario, product);
  if (!(speed_m_s > 0.0)) return kNever;
  const double mass_kg = lattice_mass_kg(product);
  return half_period_s(side_at_support(product, scenario.cell), mass_kg, speed_m_s,
                       mass_kg * std::abs(scenario.cell.gravity_m_s2[2]));
}
double landing_time_s(const NetworkParameters& network, const Scenario&) {
  double mass_kg = 0.0;
  double stiffness_N_m = 0.0;
  for (const NetworkParticle& particle : network.particle) {
    mass_kg += particle.mass_kg;
    stiffness_N_m += particle.contact_stiffness_N_m;
  }
  return stiffness_N_m > 0.0 ? std::numbers::pi * std::sqrt(mass_kg / stiffness_N_m) : kNever;
}

}  // namespace

double finger_contact_time_s(const Scenario& scenario) {
  return std::visit([&](const auto& kind) { return pad_time_s(kind, scenario); }, scenario.product);
}

double support_contact_time_s(const Scenario& scenario) {
  if (!scenario.cell.support) return kNever;
  return std::visit([&](const auto& kind) { return landing_time_s(kind, scenario); }, scenario.product);
}

double contact_time_s(const Scenario& scenario) {
  return std::min(finger_contact_time_s(scenario), support_contact_time_s(scenario));
}

}  // namespace unbruised
