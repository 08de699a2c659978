#pragma once

/// @file
/// The sizing sheet: what the rules of gripper makers ask for, beside what was simulated, and what else a gripper
/// has to bear. Forces are of one finger (docs/gripper.md, "The sizing sheet").

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/scenario/scenario.hpp"
#include "studies/findings/window_answer.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

inline constexpr const char* kSizingTable = "sizing";

/// The scenario behind a row of the window table.
using ScenarioOfRow = std::function<Scenario(std::size_t row)>;

/// Table `sizing` (docs/results.md): for every strategy its items, in the order in which they are read. Of several
/// products and cells that asks for most is taken.
ResultTable sizing_table(const WindowAnswer& answer, const ScenarioOfRow& scenario);

/// "sizing: ..." of the strategy that is answered with: the rules, and what is beyond its limit.
std::vector<std::string> sizing_lines(const std::vector<ResultTable>& tables);

}  // namespace unbruised::studies
