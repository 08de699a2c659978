#pragma once

/// @file
/// The strategy that each study kind answers with, as the scenario it stands for.

#include <optional>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/grid_answer.hpp"
#include "studies/findings/search_findings.hpp"
#include "studies/findings/strategy_file.hpp"
#include "studies/kinds/window_findings.hpp"

namespace unbruised::studies {

/// Of windows: the best strategy at its set-point, on the first product and cell that it holds over. Of several
/// grippers the one with the shortest cycle, and it says which. Nothing: no strategy has a set-point.
std::optional<AnsweredStrategy> window_strategy(const Study& study, const StudyWindow& window,
                                                const WindowAnswer& answer);

/// Of a sweep without windows. Nothing: no strategy is held in all combinations.
std::optional<AnsweredStrategy> grid_strategy(const Study& study, const GridAnswer& answer);

/// Of optimize and robust the best, of pareto the knee. Nothing: none is feasible.
std::optional<AnsweredStrategy> search_strategy(const Study& study, const SearchFindings& found);

/// Of compare the winner. @param tables of the study. Nothing: no candidate is shown to be better than all others.
std::optional<AnsweredStrategy> compare_strategy(const Study& study, const std::vector<ResultTable>& tables);

}  // namespace unbruised::studies
