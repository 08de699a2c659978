#pragma once

/// @file
/// What the parameters of a product, whatever its kind, say of its particles: how they begin and what pushes them.

#include <array>
#include <vector>

#include "core/body/body_model.hpp"

namespace unbruised {

/// The state of one lane, [3n] each.
struct BodyState {
  std::vector<double> displacement_m, velocity_m_s, acceleration_m_s2;
  /// Of a body in a floating frame: the attitude that it has but for its deformation, about this vector by its
  /// length. All else is along x, y, z.
  std::array<double, 3> rotation_rad{};
};

/// Displacements and velocities as they are written; accelerations are zero.
BodyState written_state(const ProductParameters& product, const BodyModel& body);

/// Forces of the loads in the parameters at a time, [3n].
std::vector<double> written_load_N(const ProductParameters& product, const BodyModel& body, double time_s,
                                   JumpSide side = JumpSide::right);

}  // namespace unbruised
