#pragma once

/// @file
/// A page over the runs of a folder.

#include <filesystem>
#include <string>
#include <vector>

#include "studies/results/expected.hpp"

namespace unbruised::studies {

struct ShelfRun {
  std::filesystem::path directory;
  std::string study, kind;
  std::string answer;       ///< one line, or what is wrong with it
  std::string created_utc;  ///< empty where it is not complete
  std::string state;        ///< "complete", "unfinished", "damaged"
  bool has_report = false;
};

/// @param folder that the page stands in: links are relative to it
std::string shelf_page(const std::vector<ShelfRun>& runs, const std::filesystem::path& folder);

/// Writes it. An earlier page of this program is replaced, any other file refused (foreign).
MaybeError write_shelf_page(const std::filesystem::path& path, const std::vector<ShelfRun>& runs,
                            const std::filesystem::path& folder);

}  // namespace unbruised::studies
