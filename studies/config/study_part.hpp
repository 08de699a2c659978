#pragma once

/// @file
/// A part of a study: what it says about one scenario, without what it varies, draws and searches.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// As `read_study`; a study of kind simulate with that one scenario.
StudyOrError read_single_scenario(const std::filesystem::path& file, const std::vector<std::string>& sets,
                                  const std::filesystem::path& config_root);
/// As `read_study_text`.
StudyOrError read_single_scenario_text(std::string_view text, const std::string& display_name,
                                       const std::vector<std::string>& sets, const std::filesystem::path& folder,
                                       const std::filesystem::path& config_root);

}  // namespace unbruised::studies
