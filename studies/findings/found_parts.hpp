#pragma once

/// @file
/// The parts of `found_lines`, and what they share.

#include <cstddef>
#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// "0.98 (95 % interval 0.91 to 1)"; without an end of the interval, or without the estimate, it says so.
std::string interval_text(double estimate, double low, double high, double confidence);
/// " (scenario 12)"; empty where the row names none.
std::string scenario_text(const ResultTable& table, std::size_t row);
/// " with grip_force_N = 2.1", or that the strategy is as written.
std::string at_keys(const ResultTable& table, std::size_t row);

/// optimize, robust: the best strategy and what is known of it.
void add_best_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines);
/// Kinds that search: the checks of the answer, then how the searches went.
void add_check_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines);
/// compare: the winner, the candidates, the pairs.
void add_compare_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines);

/// calibrate: the population, the specimens, what is predicted.
void add_calibration_lines(const std::vector<ResultTable>& tables, std::vector<std::string>& lines);

}  // namespace unbruised::studies
