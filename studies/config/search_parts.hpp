#pragma once

/// @file
/// The parts of `complete_search`, each in a file of its own.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/searching.hpp"
#include "studies/statistics/distribution.hpp"

namespace unbruised::studies {

/// Quantiles that count as the ends of an unbounded distribution.
inline constexpr double kRareLow = 1e-6;
inline constexpr double kRareHigh = 1.0 - 1e-6;

/// What the parts work on: a study that is being completed, its blocks, the places of its keys.
struct SearchInput {
  StudyData& data;
  const ReadBlocks& read;
  const Assembly& base;
  Problems& problems;
};

/// Variables and random keys from their blocks.
void add_searched_keys(const SearchInput& input);
/// The distribution of block `i`: which keys it takes, which it needs. Nothing, and problems, where it has none.
std::optional<Distribution> distribution_of(const RandomBlock& block, std::size_t i,
                                            const std::vector<std::string>& given_keys, Problems& problems);
/// The correlations of the random keys, from their blocks; they are there already.
void add_correlations(const SearchInput& input);
/// Settings and measured curves of a calibration; the keys that are fitted are there already.
void add_curves(const SearchInput& input);
/// Goals and settings of [search], [compare] and [sensitivity].
void add_goals(const SearchInput& input);

}  // namespace unbruised::studies
