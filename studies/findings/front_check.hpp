#pragma once

/// @file
/// Points of a Pareto front that rest on an impact which the step does not resolve, at half the time step: columns
/// of
/// `/pareto`, and what they say.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/findings/strategy_judge.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The points of a front that are looked at again, by their places in it.
std::vector<std::size_t> points_on_impacts(const std::vector<const Candidate*>& front);

/// Columns `half_step_objective_1`, ..., `half_step_violation`; NaN of points that were not looked at.
/// @param again of points_on_impacts, in their order; empty: no columns
void add_half_step_columns(const std::vector<const Candidate*>& front, const std::vector<Candidate>& again,
                           ResultTable& pareto);

/// "3 points of the front rest on impacts ...: at half the time step objective_1 moves by up to 12 %, ...".
/// Nothing without the columns.
std::optional<std::string> front_check_line(const ResultTable& pareto);
/// Where such a point breaks a constraint.
std::optional<std::string> front_check_warning(const ResultTable& pareto);

}  // namespace unbruised::studies
