#pragma once

/// @file
/// What a study will cost before it runs: rough, and honest about being rough.

#include <cstddef>
#include <string_view>

#include "core/scenario/scenario.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised::studies {

/// Core time of one step of one lane per estimated entry of the factor, all parts of the step included.
struct LaneStepRate {
  double seconds_per_factor_entry = 0.0;
  double seconds_per_contact_entry = 0.0;  ///< of the compliance, per sweep
  double seconds_per_contact_node = 0.0;   ///< of a product by modes, beside its products and sweeps
  std::string_view measured_on;            ///< kind of core
};

/// Entries of L of a lattice are about this times freedoms^(4/3) (nested dissection of a solid; 222,825 at 1536).
inline constexpr double kFactorEntriesPerFreedomPower = 12.6;

/// The rate of this build's instruction set, measured over 512 scenarios of a kiwi of 1,099 particles between two
/// pads (configs/kiwi_sweep.toml, 16 lanes, two threads): 84 s on Zen 5 with AVX-512, 455 s on Zen 3 at 2.4 GHz.
/// Without either set it is that of AVX2, which flatters the machine. By modes the same takes 24 s on Zen 3; with
/// AVX-512 that was not measured, and half is assumed.
LaneStepRate measured_lane_step_rate();

/// Of a run in which everything goes as planned.
double estimated_steps(const Scenario& scenario);

/// One model: factor, particles and springs, dense compliance of the contact freedoms.
double estimated_model_bytes(const ModelSize& size);
/// The state of one lane.
double estimated_lane_bytes(const ModelSize& size);
/// Rows of the trace that simulation.trace_interval_s leaves.
double estimated_trace_rows(const Scenario& scenario);
/// A trace in its file before it is compressed: displacement, velocity, acceleration of every particle.
double estimated_trace_bytes(const Scenario& scenario, const ModelSize& size);
/// Core time of one step of one lane: the solves, and the contact sweeps while something is held.
double estimated_lane_step_s(const Scenario& scenario, const ModelSize& size);

}  // namespace unbruised::studies
