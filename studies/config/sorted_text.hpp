#pragma once

/// @file
/// The entries of a study's text and of the command line, sorted by who reads them; unknown tables are refused.

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

struct SortedText {
  std::vector<Entry> study;         ///< of the scenario and of the study's settings
  std::vector<Entry> command_line;  ///< the same, from --set
  std::vector<Entry> own_sources;   ///< [product.source] and [gripper.source]
  std::vector<Entry> vary_entries, vary_tables;
  std::vector<Entry> block_entries, block_tables;  ///< [[variable]], [[random]], [[candidate]]
  std::unordered_map<std::string, Origin> tables;  ///< where each starts
  bool is_other_kind = false;  ///< study.kind is none of this program's: its keys are not known

  /// The text that has the last word about a key; nullptr where there is none.
  [[nodiscard]] const Entry* last(std::string_view path) const;
};

/// @param sets the values of --set, each `key=value` with a TOML literal (strings may be bare)
SortedText sort_text(const Document& document, const std::vector<std::string>& sets, Problems& problems);

}  // namespace unbruised::studies
