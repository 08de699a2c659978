#pragma once

/// @file
/// What the kinds that search or draw products need beside a scenario: [[variable]], [[random]],
/// [[correlation]] and [[candidate]] blocks, and the goals of [search], [compare] and [sensitivity].

#include <string>
#include <vector>

#include "studies/config/assemble.hpp"
#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"
#include "studies/config/schema.hpp"
#include "studies/config/study_data.hpp"

namespace unbruised::studies {

/// The blocks of a study as written.
struct ReadBlocks {
  StudyBlocks blocks;
  /// Keys given in each [[random]] block.
  std::vector<std::vector<std::string>> random_keys;
  /// Does each [[random]] block have all it needs, and right values only?
  std::vector<bool> random_sound;
  /// The same of each [[correlation]] block.
  std::vector<bool> correlation_sound;
  /// Of each [[candidate]]: its strategy keys, under "strategy.".
  std::vector<std::vector<Entry>> candidate_entries;

  [[nodiscard]] bool empty() const {
    return blocks.variable.empty() && blocks.parameter.empty() && blocks.random.empty() &&
           blocks.candidate.empty();
  }
  /// The keys of [[variable]] and [[random]] with the places of their blocks.
  [[nodiscard]] std::vector<std::pair<std::string, Origin>> keys() const;
};

/// Reads the blocks from entries and tables "variable[i]...", "random[i]...", "correlation[i]...",
/// "candidate[i]..." (later entries override); every value is checked against its key.
ReadBlocks read_blocks(const std::vector<Entry>& entries, const std::vector<Entry>& tables, Problems& problems);

/// Fills variables, random keys and settings of a study from its blocks and tables. `data.bases` and
/// `data.settings` are there; random keys that the base does not have get their median.
void complete_search(StudyData& data, const ReadBlocks& read, const Assembly& base, Problems& problems);

}  // namespace unbruised::studies
