#pragma once

/// @file
/// A window study from its first force to its answer: the search of both ends at every combination, then the ends
/// that decide the answer again at half the time step.

#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/kinds/half_step.hpp"
#include "studies/kinds/window_findings.hpp"

namespace unbruised::studies {

struct WindowRun {
  StudyWindow window;
  WindowAnswer answer;
  std::vector<std::string> warnings;  ///< ends that move at half the time step
};

/// All combinations of a study.
std::vector<SearchedCombination> combinations_of(const Study& study);
WindowSearchSettings window_search_settings(const Study& study, std::vector<SearchedCombination> combinations);
/// The ends of some combinations, without inputs; nothing when interrupted.
std::optional<std::vector<WindowRow>> search_study_windows(const Study& study,
                                                           std::vector<SearchedCombination> combinations,
                                                           const ForceRunner& run);

/// @param columns the input columns of all rows
/// @return nothing when interrupted
std::optional<WindowRun> run_window_study(const Study& study, const std::vector<ColumnInfo>& columns,
                                          const ForceRunner& run);

}  // namespace unbruised::studies
