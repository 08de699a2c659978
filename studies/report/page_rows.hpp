#pragma once

/// @file
/// Which scenarios a page holds: all of them, or of millions a choice.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

inline constexpr std::size_t kPageRowsMost = 200000;

/// @param ids of scenarios that are to be among them
/// @return all rows where they are no more than `most`; else about as many, chosen by their ids alone and so that
///   no key of a grid is left out, with the best one
std::vector<ScenarioRow> page_rows(const StudyRows& rows, const std::vector<std::uint64_t>& ids,
                                   std::size_t most = kPageRowsMost);

/// What the page says of it; empty where it holds all.
std::string page_rows_note(std::size_t shown, std::size_t all);

}  // namespace unbruised::studies
