#pragma once

/// @file
/// Looking into result tables, and saying their rows in words.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// "grip_force_N = 2.1, lift_acceleration_m_s2 = 4"
std::string values_text(const std::vector<SearchVariable>& variables, std::span<const double> values);

/// The table of that name; nullptr: there is none.
const ResultTable* find_table(const std::vector<ResultTable>& tables, std::string_view name);
std::size_t row_count(const ResultTable& table);
/// A cell; NaN or "" where there is no such column or row.
double number_in(const ResultTable& table, std::string_view column, std::size_t row);
std::string text_in(const ResultTable& table, std::string_view column, std::size_t row);
/// An attribute; nothing where there is none.
std::optional<double> number_attribute(const ResultTable& table, std::string_view name);
std::string text_attribute(const ResultTable& table, std::string_view name);

/// The columns that hold keys ("strategy.grip_force_N") of one row: "grip_force_N = 2.1" and so on.
std::vector<std::string> key_texts(const ResultTable& table, std::size_t row);
/// The same as values_text.
std::string keys_text(const ResultTable& table, std::size_t row);

}  // namespace unbruised::studies
