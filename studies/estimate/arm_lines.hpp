#pragma once

/// @file
/// What `check` says of an arm, before anything runs.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Which limit binds in the first scenario, and how many scenarios the arm cannot follow, of those that are looked
/// at: all, or kArmScenariosMost spread over a large study. Empty without an arm.
std::vector<std::string> arm_lines(const Study& study);

}  // namespace unbruised::studies
