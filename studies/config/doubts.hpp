#pragma once

/// @file
/// What a study says that is allowed, but probably not meant.

#include <string>
#include <vector>

#include "studies/config/study_data.hpp"

namespace unbruised::studies {

/// The limits that are set but can never act: "limits.permanent_set_m, limits.plastic_strain".
std::string idle_limits(const Scenario& scenario);

/// One sentence each: limits that can never act, and values outside core's list of plausible ones, in the
/// scenarios of every product and gripper that is used and at the ends of all values that are varied, searched or
/// drawn.
std::vector<std::string> doubts(const StudyData& data);

}  // namespace unbruised::studies
