#pragma once

/// @file
/// Which products move by their modes (docs/theory.md, "Modes").

#include <string_view>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Why a scenario with `simulation.body = "modes"` is computed with every particle all the same; empty: it is not.
std::string_view needs_full_body_because(const Scenario& scenario);

/// In how many modes the product deforms; 0: its particles move.
int mode_count(const Scenario& scenario);

}  // namespace unbruised
