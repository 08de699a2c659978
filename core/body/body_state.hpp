#pragma once

/// @file
/// What the parameters of a product, whatever its kind, say of its particles: how they begin and what pushes them.

#include <vector>

#include "core/body/body_model.hpp"

namespace unbruised {

/// The state of one lane, [3n] each.
struct BodyState {
  std::vector<double> displacement_m, velocity_m_s, acceleration_m_s2;
};

/// Displacements and velocities as they are written; accelerations are zero.
BodyState written_state(const ProductParameters& product, const BodyModel& body);

/// Forces of the loads in the parameters at a time, [3n].
std::vector<double> written_load_N(const ProductParameters& product, const BodyModel& body, double time_s,
                                   JumpSide side = JumpSide::right);

}  // namespace unbruised
