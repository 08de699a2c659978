#pragma once

/// @file
/// Which scenarios of a study are worth seeing: the best one, and its nearest neighbours that went wrong.

#include <cstdint>
#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct ChosenReplay {
  std::uint64_t id = 0;
  std::string why;  ///< "best held", "nearest damaged", "nearest dropped", "asked for"
};

/// Those that are asked for come first, then the best: of the held rows with the inputs of the shortest cycle the
/// one in the middle of its grip forces. Then of those that were not held and of the damaged ones the nearest:
/// which differ in the fewest inputs beside the grip force, and then the least, each input measured by its range
/// over all rows. Without a held row the least damaged one takes its place, or the first. Each id once.
std::vector<ChosenReplay> chosen_replays(const std::vector<ColumnInfo>& inputs,
                                         const std::vector<ScenarioRow>& rows,
                                         const std::vector<std::uint64_t>& asked);

}  // namespace unbruised::studies
