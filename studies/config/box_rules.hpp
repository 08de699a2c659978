#pragma once

/// @file
/// The rules over the box of values that a study searches or draws from.

#include <span>
#include <string>
#include <vector>

#include "studies/config/searching.hpp"
#include "studies/config/study_data.hpp"

namespace unbruised::studies {

/// A key of the box with its two ends.
struct BoxSide {
  std::string key;
  double low;
  double high;
  Origin origin;
  std::string zip = {};               ///< sides with the same word take the same row
  std::span<const double> rows = {};  ///< of such a side, in place of the ends
};

std::vector<BoxSide> box_sides(const StudyData& data, const ReadBlocks& read);

/// Checks the rules between values for every candidate, at the corners of the box and at places inside it.
void check_box_rules(const StudyData& data, const ReadBlocks& read, Problems& problems);

}  // namespace unbruised::studies
