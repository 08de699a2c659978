#pragma once

/// @file
/// What `check` says of an arm, before anything runs.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Which limit binds most, how many scenarios are slowed down, and how many the arm cannot follow, of those that
/// are looked at: all, or a hundred spread over a large study. Empty without an arm.
std::vector<std::string> arm_lines(const Study& study);

}  // namespace unbruised::studies
