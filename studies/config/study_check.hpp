#pragma once

/// @file
/// The rules of a study that has been put together: its kind's, and those of its scenarios, each looked at over
/// the varied keys that it depends on.

#include <vector>

#include "studies/config/assemble.hpp"
#include "studies/config/searching.hpp"
#include "studies/config/study_data.hpp"

namespace unbruised::studies {

struct StudyCheck {
  const StudyData& data;
  const std::vector<Assembly>& assemblies;  ///< one per base
  const ReadBlocks& read;
  Origin start;  ///< of the file
  bool has_gripper = false;
  Problems& problems;
};

/// Adds every rule that is broken, of each the first scenario that breaks it.
void check_study(const StudyCheck& input);

}  // namespace unbruised::studies
