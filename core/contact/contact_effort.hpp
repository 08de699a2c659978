#pragma once

/// @file
/// How hard the contact solve of a scenario will be, from closed forms (docs/contact.md, "Light products").

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Layers against the inertia of what they hold, over one step: sum of the pads' (or the support's) stiffness,
/// viscous part included, x compliance of the free product, (theta dt)^2 / (6 m). Sweeps slow down in proportion.
/// 0 where nothing is held.
double contact_coupling(const Scenario& scenario);

/// Couplings above this may end without contact forces: without modes of patches (patch_modes.hpp) a step needs
/// more sweeps than there are at 140, 150 on average at 60.
inline constexpr double kLargestCoupling = 60.0;

/// The time step at which a scenario has this coupling [s].
double time_step_of_coupling_s(const Scenario& scenario, double coupling);

/// Sweeps of an average step in which something is held: 5, and for each unit of the coupling 2, of flat sides
/// 0.3, or fewer in steps below a millisecond (docs/contact.md, "Light products").
double estimated_sweeps(const Scenario& scenario);

/// Contact freedoms that are active while the product is held.
double estimated_contact_freedoms(const Scenario& scenario);

}  // namespace unbruised
