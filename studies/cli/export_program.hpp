#pragma once

/// @file
/// `export` of a strategy for a controller.

#include <array>
#include <string_view>

#include "studies/cli/commands.hpp"

namespace unbruised::studies {

inline constexpr std::string_view kJointTrajectory = "joint_trajectory";
inline constexpr std::array<std::string_view, 4> kProgramFormats = {kJointTrajectory, "urscript", "rapid", "krl"};
/// The path as CSV is the table of this name.
inline constexpr std::string_view kPathTable = "path";

bool is_program_format(std::string_view format);

/// The path of one scenario: the one asked for, or that of the answer.
int export_program(const ExportArguments& arguments);

}  // namespace unbruised::studies
