#pragma once

/// @file
/// Studies whose scenarios are known beforehand, at half the time step: what their answer rests on and has an
/// impact that the step does not resolve is run again. These runs are no rows of the study; after an interruption
/// they are made again.

#include <vector>

#include "studies/findings/grid_answer.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/kinds/window_findings.hpp"

namespace unbruised::studies {

/// The answer of a sweep's window with such ends looked for again, on forces as far apart as those of the grid.
/// Adds warnings; nothing: interrupted.
/// @param columns, rows of all scenarios
std::optional<WindowAnswer> sweep_window_answer(const KindInput& input, const std::vector<ColumnInfo>& columns,
                                                const StudyRows& rows, StudyWindow& window,
                                                std::vector<std::string>& warnings);

/// Adds the table `verification` and its warning where the best strategy of a sweep, or the winner of a
/// comparison, rests on such a run. @return false: interrupted
bool check_grid_winner(const KindInput& input, const GridAnswer& found, const StudyRows& rows, KindAnswer& answer);
bool check_compare_winner(const KindInput& input, const StudyRows& rows, KindAnswer& answer);

}  // namespace unbruised::studies
