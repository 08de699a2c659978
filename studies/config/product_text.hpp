#pragma once

/// @file
/// A product as a file that `[product] use = "..."` takes.

#include <string>

#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

/// The [product] keys of a scenario, one `key = value` a line, every value exact, its particles, springs and loads
/// as lists, and its [limits].
std::string product_lines(const Scenario& scenario);

}  // namespace unbruised::studies
