#include "core/contact/contact_effort.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/contact/layered_face.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {
namespace {

/// coupling = quadratic dt^2 + linear dt.
struct CouplingLaw {
  double quadratic_1_s2 = 0.0;
  double linear_1_s = 0.0;
};

/// Of layers of this stiffness in all that hold a mass. A viscous layer is 1 + 3 tau / (theta dt) as stiff in a
/// step.
CouplingLaw law_of(double stiffness_N_m, double relaxation_s, double mass_kg, double theta) {
  const double elastic = stiffness_N_m * theta * theta / (6.0 * mass_kg);
  return {elastic, elastic * 3.0 * relaxation_s / theta};
}

double coupling_at(const CouplingLaw& law, double dt) { return (law.quadratic_1_s2 * dt + law.linear_1_s) * dt; }

CouplingLaw coupling_law(const LatticeParameters& product, const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  const double mass_kg = lattice_mass_kg(product), theta = scenario.simulation.theta;
  CouplingLaw largest;
  if (jaw != nullptr) {
    const LayeredFace side = side_at_pad(product, *jaw, scenario.cell);
    const double all = finger_count(scenario) * side.layer_N_m(scenario.strategy.grip_force_N);
    largest = law_of(all, jaw->pad_relaxation_time_s, mass_kg, theta);
  }
  if (scenario.cell.support) {
    const LayeredFace base = side_at_support(product, scenario.cell);
    const double weight_N = mass_kg * std::abs(scenario.cell.gravity_m_s2[2]);
    const double layer = base.layer_N_m(weight_N);
    const CouplingLaw law = law_of(layer, scenario.cell.support_relaxation_time_s, mass_kg, theta);
    const double dt = scenario.simulation.time_step_s;
    if (coupling_at(law, dt) > coupling_at(largest, dt)) largest = law;
  }
  return largest;
}
/// Its few contacts converge in a handful of sweeps whatever they are.
CouplingLaw coupling_law(const NetworkParameters&, const Scenario&) { return {}; }

CouplingLaw coupling_law(const Scenario& scenario) {
  return std::visit([&](const auto& kind) { return coupling_law(kind, scenario); }, scenario.product);
}

/// Particles under a patch of a face of this cell, at least four.
double particles_under(double patch_m2, double cell_area_m2) {
  const double side = std::sqrt(patch_m2 / cell_area_m2) + 1.0;
  return std::max(4.0, side * side);
}

double contact_freedoms(const LatticeParameters& product, const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return 0.0;
  const LayeredFace side = side_at_pad(product, *jaw, scenario.cell);
  const std::array<double, 3> cell = lattice_cell_extent_m(product);
  const double nodes =
      finger_count(scenario) * particles_under(side.patch_m2(scenario.strategy.grip_force_N), cell[1] * cell[2]);
  return 3.0 * nodes;
}
double contact_freedoms(const NetworkParameters&, const Scenario&) { return 0.0; }

bool has_flat_sides(const LatticeParameters& product) { return product.shape == Shape::box; }
bool has_flat_sides(const NetworkParameters&) { return false; }

/// Are the sides of the product and what they meet flat, for good?
bool touches_flat(const Scenario& scenario) {
  const bool is_flat = std::visit([](const auto& kind) { return has_flat_sides(kind); }, scenario.product);
  return is_flat && product_frame(scenario) == ProductFrame::upright && !has_shaped_pads(scenario) &&
         !has_lattice_pads(scenario);
}

}  // namespace

double contact_coupling(const Scenario& scenario) {
  return coupling_at(coupling_law(scenario), scenario.simulation.time_step_s);
}

double time_step_of_coupling_s(const Scenario& scenario, double coupling) {
  const CouplingLaw law = coupling_law(scenario);
  const double root = std::sqrt(law.linear_1_s * law.linear_1_s + 4.0 * law.quadratic_1_s2 * coupling);
  return 2.0 * coupling / (law.linear_1_s + root);
}

double estimated_sweeps(const Scenario& scenario) {
  // Counted on plates of 3 to 50 g, coupling 0.2 to 61, steps of 0.07 to 1 ms: within a factor of 1.6. The sweeps
  // start from the forces of the last step, which are the nearer the shorter it is. On flat sides what sticks is
  // found at once (2026-11-29: coupling 1.3 to 37, steps of 0.2 to 2 ms, within 1.6).
  constexpr double kCountedStep_s = 1e-3;
  const double change = std::sqrt(std::min(1.0, scenario.simulation.time_step_s / kCountedStep_s));
  const double per_coupling = touches_flat(scenario) ? 0.3 : 2.0;
  return 5.0 + per_coupling * contact_coupling(scenario) * change;
}

double estimated_contact_freedoms(const Scenario& scenario) {
  return std::visit([&](const auto& kind) { return contact_freedoms(kind, scenario); }, scenario.product);
}

}  // namespace unbruised
