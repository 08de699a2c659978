#pragma once

/// @file
/// An arm as what carries the palm of a plan: how it stops, and how the palm goes where the arm gives way.

#include <memory>

#include "core/motion/palm_carrier.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// nullptr where the scenario has no robot: the palm goes as planned and stops evenly. A palm whose arm is rigid
/// goes as planned too.
std::shared_ptr<const PalmCarrier> arm_carrier(const Scenario& scenario);

}  // namespace unbruised
