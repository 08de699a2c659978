#include "core/contact/contact_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "core/contact/layered_face.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/lattice_cells.hpp"

namespace unbruised {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Most that the force of a product's surface that is stopped by a layer comes to over v sqrt(m k), at 20 steps in
/// its period: what stands behind the surface presses on, and a viscous layer adds its part. Measured on the
/// silicone block, 0.2 m/s: 0.7 to 2.2 over cells, pads, springs, rubber and their relaxation (docs/contact.md).
constexpr double kSurfaceForce = 2.2;

/// A mass that meets a face.
struct Impact {
  double mass_kg;
  double speed_m_s;
  double least_force_N;  ///< with which it is pressed on
};

/// Half a period of the mass on the face.
double half_period_s(const LayeredFace& face, const Impact& impact) {
  const auto& [mass_kg, speed_m_s, least_force_N] = impact;
  constexpr double kGravity_m_s2 = 9.80665;  // any start but zero serves
  double stiffness = face.stiffness_N_m(std::max(least_force_N, mass_kg * kGravity_m_s2));
  constexpr int kImpactIterations = 4;  // force and stiffness of a Hertz contact settle to per cents
  for (int i = 0; i < kImpactIterations; ++i) {
    stiffness = face.stiffness_N_m(std::max(least_force_N, speed_m_s * std::sqrt(mass_kg * stiffness)));
  }
  return std::numbers::pi * std::sqrt(mass_kg / stiffness);
}

/// Particles of the flat face that meet the layer first: half a cell of the product along the axis.
double surface_mass_kg(const LatticeParameters& product, std::size_t axis, double area_m2) {
  const double density_kg_m3 = lattice_mass_kg(product) / true_volume_m3(product);
  return density_kg_m3 * area_m2 * 0.5 * lattice_cell_extent_m(product)[axis];
}

/// A whole period of the surface of a flat face on the layer that stops it, so that the rise of its peak gets a
/// quarter of the steps; never where the peak decides nothing, since the face is pressed with as much anyway.
/// @param surface_kg that swings on the layer
double surface_period_s(const LayeredFace& face, double surface_kg, const Impact& impact) {
  if (!face.is_flat || !(face.flat_area_m2 > 0.0)) return kNever;
  const double whole_N_m = face.stiffness_N_m(impact.least_force_N);
  const double layer_N_m = face.layer_N_m(impact.least_force_N);
  const double peak_N = kSurfaceForce * impact.speed_m_s * std::sqrt(surface_kg * layer_N_m);
  const double anyway_N = std::max(impact.least_force_N, impact.speed_m_s * std::sqrt(impact.mass_kg * whole_N_m));
  return peak_N > anyway_N ? 2.0 * std::numbers::pi * std::sqrt(surface_kg / layer_N_m) : kNever;
}

/// With which the product meets the support; 0: it does not hit it.
double landing_speed_m_s(const Scenario& scenario, const LatticeParameters& product) {
  const double gravity_m_s2 = std::abs(scenario.cell.gravity_m_s2[2]);
  if (has_gripper(scenario)) return std::sqrt(2.0 * gravity_m_s2 * scenario.strategy.release_height_m);
  const double start_m_s = product.initial_velocity_m_s[2];
  return std::sqrt(start_m_s * start_m_s + 2.0 * gravity_m_s2 * product.initial_height_m);
}

double pad_time_s(const LatticeParameters& product, const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return kNever;
  return half_period_s(
      side_at_pad(product, *jaw, scenario.cell),
      {jaw->finger_mass_kg, scenario.strategy.approach_speed_m_s, scenario.strategy.grip_force_N});
}
double pad_time_s(const NetworkParameters&, const Scenario&) { return kNever; }

bool judges_damage(const Scenario& scenario) { return scenario.limits.damage == DamageJudging::judged; }

/// No force that matters is below the one that carries the weight.
double least_grip_N(const LatticeParameters& product, const Scenario& scenario) {
  const double weight_N = lattice_mass_kg(product) * std::abs(scenario.cell.gravity_m_s2[2]);
  return std::max(scenario.strategy.grip_force_N, weight_N / finger_count(scenario) / product.friction);
}

double pad_surface_time_s(const LatticeParameters& product, const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return kNever;
  const LayeredFace face = side_at_pad(product, *jaw, scenario.cell);
  const double surface_kg = surface_mass_kg(product, 0, face.flat_area_m2);
  const double relative_kg = 1.0 / (1.0 / surface_kg + 1.0 / jaw->finger_mass_kg);
  return surface_period_s(
      face, relative_kg,
      {jaw->finger_mass_kg, scenario.strategy.approach_speed_m_s, least_grip_N(product, scenario)});
}
double pad_surface_time_s(const NetworkParameters&, const Scenario&) { return kNever; }

/// How the product meets the support; speed 0: it does not hit it.
Impact landing(const LatticeParameters& product, const Scenario& scenario) {
  const double mass_kg = lattice_mass_kg(product);
  return {mass_kg, landing_speed_m_s(scenario, product), mass_kg * std::abs(scenario.cell.gravity_m_s2[2])};
}

double landing_time_s(const LatticeParameters& product, const Scenario& scenario) {
  if (!(landing_speed_m_s(scenario, product) > 0.0)) return kNever;
  return half_period_s(side_at_support(product, scenario.cell), landing(product, scenario));
}

double landing_surface_time_s(const LatticeParameters& product, const Scenario& scenario) {
  if (!(landing_speed_m_s(scenario, product) > 0.0)) return kNever;
  const LayeredFace face = side_at_support(product, scenario.cell);
  return surface_period_s(face, surface_mass_kg(product, 2, face.flat_area_m2), landing(product, scenario));
}
double landing_surface_time_s(const NetworkParameters&, const Scenario&) { return kNever; }

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

double finger_surface_time_s(const Scenario& scenario) {
  if (!judges_damage(scenario)) return kNever;
  return std::visit([&](const auto& kind) { return pad_surface_time_s(kind, scenario); }, scenario.product);
}

double support_surface_time_s(const Scenario& scenario) {
  if (!scenario.cell.support || !judges_damage(scenario)) return kNever;
  return std::visit([&](const auto& kind) { return landing_surface_time_s(kind, scenario); }, scenario.product);
}

ShortestContact shortest_contact(const Scenario& scenario) {
  ShortestContact shortest;
  const auto look = [&shortest](ContactPart part, double time_s) {
    if (time_s < shortest.time_s) shortest = {time_s, part};
  };
  look(ContactPart::finger, finger_contact_time_s(scenario));
  look(ContactPart::support, support_contact_time_s(scenario));
  look(ContactPart::finger_surface, finger_surface_time_s(scenario));
  look(ContactPart::support_surface, support_surface_time_s(scenario));
  return shortest;
}

double contact_time_s(const Scenario& scenario) { return shortest_contact(scenario).time_s; }

}  // namespace unbruised
