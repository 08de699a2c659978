#pragma once

/// @file
/// Names inside a run directory and the equality of rows, shared by those who write it and who verify it.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The journals of a run directory, by name.
std::vector<std::filesystem::path> journal_files(const std::filesystem::path& directory);

/// `<results>.sha256`: the hash of the whole results file, in the form sha256sum checks.
std::filesystem::path hash_path(const std::filesystem::path& results);

/// What stands in that file for results of this hash, 64 hex digits.
std::string hash_line(std::string_view sha256_hex_digits);

/// Equal inputs, cause, and bits of outcome and metrics.
bool same_row(const ScenarioRow& a, const ScenarioRow& b);

}  // namespace unbruised::studies
