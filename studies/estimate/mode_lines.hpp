#pragma once

/// @file
/// What `check` says of a product that moves by its modes.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Their number, how fast they are, and what they leave out, of the first scenario. Empty where its particles
/// move.
std::vector<std::string> mode_lines(const Study& study);

}  // namespace unbruised::studies
