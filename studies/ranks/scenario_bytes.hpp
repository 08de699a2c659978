#pragma once

/// @file
/// A scenario as bytes, every field of core/scenario/fields.hpp bit by bit: for a process on another machine.

#include <optional>
#include <string>
#include <string_view>

#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

std::string scenario_bytes(const Scenario& scenario);
/// Nothing where the bytes are none of the above.
std::optional<Scenario> scenario_of_bytes(std::string_view bytes);

}  // namespace unbruised::studies
