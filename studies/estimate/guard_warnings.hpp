#pragma once

/// @file
/// Guards that leave the drives no room to brake.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// A guard by range that comes so late that the fingers still touch faster than it tells them to.
std::vector<std::string> guard_warnings(const Study& study);

}  // namespace unbruised::studies
