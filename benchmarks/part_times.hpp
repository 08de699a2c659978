#pragma once

/// @file
/// What benchmarks make of the parts of a step.

#include "core/simulation/simulation.hpp"

namespace unbruised::benchmarks {

/// All parts together [s].
inline double total_s(const LaneSimulation::PartTimes& part) {
  return part.right_hand_side_s + part.solve_s + part.contact_s + part.plasticity_s + part.update_s;
}

}  // namespace unbruised::benchmarks
