#pragma once

/// @file
/// Parts of a scenario as lines of TOML.

#include <string>
#include <string_view>

#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

/// The keys right below a table that the scenario looks at, one `key = value` a line. @param table with its dot:
/// "strategy." @param index of its place in a list
std::string key_lines(std::string_view table, Scenario& scenario, int index);

}  // namespace unbruised::studies
