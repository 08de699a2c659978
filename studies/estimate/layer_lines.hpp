#pragma once

/// @file
/// What `check` says of a product of several materials.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// How many cells each layer of the first scenario has. Empty where there are no layers.
std::vector<std::string> layer_lines(const Study& study);

/// Layers that have no cell: too thin for the lattice.
std::vector<std::string> layer_warnings(const Study& study);

}  // namespace unbruised::studies
