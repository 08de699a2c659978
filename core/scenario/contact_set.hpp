#pragma once

/// @file
/// Which places of a product can meet the surfaces of its cell: what a scenario asks for, or what its strategy
/// and its cell need.

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Never `automatic`. Networks touch the support with their particles, whatever is asked for.
ContactSet contact_set(const Scenario& scenario);

/// Does a lattice meet a support with the particles of its bottom?
bool stands_on_its_bottom(const Scenario& scenario);

}  // namespace unbruised
