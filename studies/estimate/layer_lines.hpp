#pragma once

/// @file
/// What `check` says of a product of several materials.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// How many cells each layer of the first layered product has. Empty where none is found.
std::vector<std::string> layer_lines(const Study& study);

/// Layers that have no cell: too thin for the lattice.
std::vector<std::string> layer_warnings(const Study& study);

}  // namespace unbruised::studies
