#pragma once

/// @file
/// A strategy as a file that a compare study's `[[candidate]] use = "..."` takes.

#include <string>

#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

/// The [strategy] keys that the scenario looks at, one `key = value` a line, every value exact; its
/// waypoints as [[waypoint]].
std::string strategy_lines(const Scenario& scenario);

}  // namespace unbruised::studies
