#pragma once

/// @file
/// All runs below a folder: what each found, and whether it is complete.

#include <filesystem>
#include <optional>
#include <vector>

#include "studies/report/shelf_page.hpp"

namespace unbruised::studies {

/// The folder itself and what lies below it, as far as they are run directories, by their paths. Reads only;
/// a run that cannot be read stands there as damaged.
std::vector<ShelfRun> runs_below(const std::filesystem::path& folder);

/// `list DIR`.
int shelf_command(const std::filesystem::path& folder);
/// `report --index DIR`. @param output none: index.html in the folder
int index_command(const std::filesystem::path& folder, const std::optional<std::filesystem::path>& output);

}  // namespace unbruised::studies
