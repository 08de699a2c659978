#pragma once

/// @file
/// What the contact state register tells of a run, surface by surface.

#include <optional>
#include <string>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

inline constexpr const char* kContactTable = "contacts";

/// A row per surface that was touched: how often contacts were made, broke, stuck and slipped, and when something
/// touched it: first, last, and for longest at a stretch. Nothing where nothing touched.
std::optional<ResultTable> contact_table(const Trace& trace);

/// "contacts of the left pad: 9 makes, 9 breaks, ..." of such a table, a line per surface.
std::vector<std::string> contact_lines(const std::vector<ResultTable>& tables);

}  // namespace unbruised::studies
