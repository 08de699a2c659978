#include "studies/estimate/cost_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/motion/profile.hpp"
#include "core/scenario/opening.hpp"
#include "studies/execution/build_info.hpp"

namespace unbruised::studies {
namespace {

constexpr double kBytes = sizeof(double);
/// Vectors of the length of the freedoms that one lane keeps (u, v, a, right-hand sides, loads, plastic state).
constexpr double kVectorsPerLane = 24.0;
/// Doubles that a particle of a lattice costs in the model: springs, cells, indices.
constexpr double kDoublesPerParticle = 300.0;

double duration_of(const StrategyParameters& strategy, double distance_m, double acceleration_m_s2) {
  if (distance_m == 0.0 || !(acceleration_m_s2 > 0.0) || !(strategy.speed_m_s > 0.0)) return 0.0;
  return MotionProfile::plan(strategy.profile, distance_m, acceleration_m_s2, strategy.speed_m_s).duration_s();
}

}  // namespace

LaneStepRate measured_lane_step_rate() {
  if (instruction_set() == "avx512f") return {1.5e-10, "an AVX-512 core (Zen 5)"};
  return {8.7e-10, "an AVX2 core (Zen 3 at 2.4 GHz)"};
}

double simulated_duration_s(const Scenario& scenario) {
  if (!scenario.gripper) return scenario.simulation.duration_s.value_or(0.0);
  const StrategyParameters& s = scenario.strategy;
  const CellParameters& cell = scenario.cell;
  const double lift = s.lift_acceleration_m_s2;
  const double gap = approach_gap_m(scenario);
  const double approach = s.approach_speed_m_s > 0.0 ? gap / s.approach_speed_m_s : 0.0;
  const double release = s.release_speed_m_s > 0.0 ? gap / s.release_speed_m_s : 0.0;
  const double lower_m = cell.lift_height_m - cell.place_height_m - s.release_height_m;
  const double whole =
      approach + s.grip_ramp_s + s.settle_s + duration_of(s, cell.lift_height_m, lift) + s.hold_s +
      duration_of(s, std::hypot(cell.transfer_m[0], cell.transfer_m[1]),
                  s.transfer_acceleration_m_s2.value_or(lift)) +
      duration_of(s, lower_m, s.lower_acceleration_m_s2.value_or(lift)) + s.place_settle_s + release + s.recover_s;
  return std::min(whole, scenario.simulation.duration_s.value_or(std::numeric_limits<double>::infinity()));
}

double estimated_steps(const Scenario& scenario) {
  return std::ceil(simulated_duration_s(scenario) / scenario.simulation.time_step_s);
}

double estimated_factor_entries(const ModelSize& size) {
  return kFactorEntriesPerFreedomPower * std::pow(static_cast<double>(size.freedom_count), 4.0 / 3.0);
}

double estimated_model_bytes(const ModelSize& size) {
  const double contact_freedoms = 3.0 * static_cast<double>(size.contact_candidate_count);
  return kBytes * (2.0 * estimated_factor_entries(size) + contact_freedoms * contact_freedoms +
                   kDoublesPerParticle * static_cast<double>(size.particle_count));
}

double estimated_lane_bytes(const ModelSize& size) {
  return kBytes * kVectorsPerLane * static_cast<double>(size.freedom_count);
}

double estimated_trace_rows(const Scenario& scenario) {
  const SimulationParameters& simulation = scenario.simulation;
  const double every = simulation.trace_interval_s.value_or(simulation.time_step_s) / simulation.time_step_s;
  return std::floor(estimated_steps(scenario) / std::max(std::round(every), 1.0)) + 1.0;
}

double estimated_trace_bytes(const Scenario& scenario, const ModelSize& size) {
  constexpr double kPerParticle = 9.0 * kBytes;  // displacement, velocity, acceleration
  return estimated_trace_rows(scenario) * kPerParticle * static_cast<double>(size.particle_count);
}

double estimated_lane_step_s(const ModelSize& size) {
  return measured_lane_step_rate().seconds_per_factor_entry * estimated_factor_entries(size);
}

}  // namespace unbruised::studies
