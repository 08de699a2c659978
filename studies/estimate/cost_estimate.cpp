#include "studies/estimate/cost_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/contact_effort.hpp"
#include "core/motion/motion_plan.hpp"
#include "core/scenario/body_modes.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/guard.hpp"
#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/product_frame.hpp"
#include "core/simulation/step_level.hpp"
#include "core/simulation/step_levels.hpp"
#include "core/surface/surfaces.hpp"
#include "studies/execution/build_info.hpp"

namespace unbruised::studies {
namespace {

constexpr double kBytes = sizeof(double);
/// Vectors of the length of the freedoms that one lane keeps (u, v, a, right-hand sides, loads, plastic state).
constexpr double kVectorsPerLane = 24.0;
/// Rows of the contact register and the sweep, per candidate.
constexpr double kRowsPerCandidate = 48.0;
/// Doubles that a contact candidate costs in the model.
constexpr double kDoublesPerCandidate = 50.0;
/// Doubles that a particle of a lattice costs in the model: springs, cells, indices.
constexpr double kDoublesPerParticle = 300.0;

/// Steps of products that turn, and of those that touch with their whole surface, over an upright one, contact
/// aside (docs/surfaces.md).
constexpr double kTurningStep = 1.2, kPlacesStep = 1.4;
/// Solutions of a step of a product that falls and yields, on average until it rests (configs/drop_attitude.toml).
constexpr double kFallingRounds = 1.5;

/// What a step takes over an upright one of the same product.
double step_factor(const Scenario& scenario) {
  const bool has_places = contact_set(scenario) != ContactSet::pads_and_support;
  const double step = has_places                                          ? kPlacesStep
                      : product_frame(scenario) == ProductFrame::floating ? kTurningStep
                                                                          : 1.0;
  const bool flows = starts_in_the_air(scenario.product) && can_yield(scenario.product) && scenario.cell.support;
  return flows ? kFallingRounds * step : step;
}

double estimated_factor_entries(double freedoms) {
  return kFactorEntriesPerFreedomPower * std::pow(freedoms, 4.0 / 3.0);
}
double estimated_factor_entries(const ModelSize& size) {
  return estimated_factor_entries(static_cast<double>(size.freedom_count));
}

/// Both pads' where they are bodies; their backs are held.
double pad_factor_entries(const Scenario& scenario) {
  if (!has_lattice_pads(scenario)) return 0.0;
  const auto cells = lattice_cell_count(pad_lattice(*parallel_jaw(scenario)));
  const double face = (cells[1] + 1.0) * (cells[2] + 1.0);
  return kJawFingers * estimated_factor_entries(3.0 * cells[0] * face);
}

}  // namespace

LaneStepRate measured_lane_step_rate() {
  // As kiwi_sweep took (2026-11-28 and -29): 63 s with AVX-512, 169 s with AVX2, two threads of each.
  if (instruction_set() == "avx512f") return {3.2e-10, 4.7e-11, 3e-7, "an AVX-512 core (Zen 5)"};
  return {8.7e-10, 1.27e-10, 6e-7, "an AVX2 core (Zen 3 at 2.4 GHz)"};
}

double estimated_steps(const Scenario& scenario) {
  if (step_levels(scenario).any()) return planned_steps(scenario, planned_approach(scenario).time_s);
  return std::ceil(planned_end_s(scenario) / scenario.simulation.time_step_s);
}

double estimated_model_bytes(const ModelSize& size) {
  return size.compliance_bytes() +
         kBytes * (2.0 * estimated_factor_entries(size) +
                   kDoublesPerParticle * static_cast<double>(size.particle_count) +
                   kDoublesPerCandidate * static_cast<double>(size.contact_candidate_count));
}

double estimated_lane_bytes(const ModelSize& size) {
  return kBytes * (kVectorsPerLane * static_cast<double>(size.freedom_count) +
                   kRowsPerCandidate * static_cast<double>(size.contact_candidate_count));
}

double estimated_trace_rows(const Scenario& scenario) {
  const SimulationParameters& simulation = scenario.simulation;
  const double every = simulation.trace_interval_s.value_or(simulation.time_step_s) / simulation.time_step_s;
  const double ticks = planned_end_s(scenario) / simulation.time_step_s;
  return std::floor(std::min(estimated_steps(scenario), ticks / std::max(std::round(every), 1.0))) + 1.0;
}

double estimated_trace_bytes(const Scenario& scenario, const ModelSize& size) {
  constexpr double kPerParticle = 9.0 * kBytes;  // displacement, velocity, acceleration
  return estimated_trace_rows(scenario) * kPerParticle * static_cast<double>(size.particle_count);
}

double estimated_lane_step_s(const Scenario& scenario, const ModelSize& size) {
  const LaneStepRate rate = measured_lane_step_rate();
  const double freedoms =
      std::min(estimated_contact_freedoms(scenario), 3.0 * static_cast<double>(size.contact_node_count));
  const double contact = estimated_sweeps(scenario) * freedoms * freedoms;
  if (const int modes = mode_count(scenario); modes > 0) {
    const double at_nodes = 3.0 * static_cast<double>(size.contact_node_count);
    const double products = modes * (2.0 * at_nodes + freedoms) + at_nodes * freedoms;
    return rate.seconds_per_contact_entry * (products + contact) +
           rate.seconds_per_contact_node * static_cast<double>(size.contact_node_count);
  }
  // Half of the contacts of a grip face the other pad.
  const double answering = has_lattice_pads(scenario) ? 1.5 * contact : contact;
  return step_factor(scenario) * rate.seconds_per_factor_entry *
             (estimated_factor_entries(size) + pad_factor_entries(scenario)) +
         rate.seconds_per_contact_entry * answering;
}

}  // namespace unbruised::studies
