#pragma once

/// @file
/// Which scenarios can share a factored matrix.

#include <string>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Everything that fixes the model, as bytes that compare equal exactly when it can be shared: all fields that
/// core/scenario/fields.hpp marks with `Decides::model`, in which frame the product moves, which of its places can
/// touch what, and all that makes pads which are bodies.
std::string factor_key(const Scenario& scenario);

}  // namespace unbruised
