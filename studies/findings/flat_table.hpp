#pragma once

/// @file
/// Everything a study holds as flat tables, one value a cell, and those as CSV: what other programs open at once.

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/findings/summary.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The grip windows, a row per combination of the varied keys.
ResultTable window_as_table(const WindowTable& window);
/// "scenarios", "window" where there is one, and what the kind found beside.
std::vector<std::string> table_names_of(const StudyTables& tables);
/// The table of that name; without columns: there is none.
ResultTable table_called(const StudyTables& tables, const std::string& name);

/// RFC 4180 with a header line: numbers with all their digits, nothing where there is none (NaN), texts quoted
/// where they need it.
std::string csv_text(const ResultTable& table);
/// The same of the table of that name, some rows of the scenarios at a time. @return number of its columns
std::size_t csv_in_pieces(const StudyTables& tables, const std::string& name,
                          const std::function<void(std::string_view)>& look);

}  // namespace unbruised::studies
