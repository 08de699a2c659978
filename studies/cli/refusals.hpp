#pragma once

/// @file
/// What is not done with every study, nor by every process.

#include <optional>
#include <string>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Says that this is not done by several ranks (mpirun), where they are. @return true then
bool refuse_ranks(const std::string& what);
/// Of a study whose scenarios ask for one another, that it has no parts; nothing where it has.
std::optional<std::string> has_no_parts(const Study& study);

}  // namespace unbruised::studies
