#pragma once

/// @file
/// What a study draws at random, each from a stream of its own (`derived_seed`). The numbers are a part of every
/// recorded study: new uses take new ones.

#include <cstdint>

#include "studies/statistics/design.hpp"

namespace unbruised::studies {

enum class SeedPurpose : std::uint64_t {
  products = 101,         ///< that a study samples, compares on or searches with
  other_products = 102,   ///< on which the answer of a search is checked
  starts = 103,           ///< where searches begin
  sensitivity = 104,      ///< the design over the random keys
  bootstrap = 105,        ///< intervals of statistics
  front_positions = 106,  ///< where a front of three objectives is looked for
  later_starts = 110,     ///< where the second stage of a pareto study begins
  searches = 1000,        ///< and on: one for each search
};

/// The seed of a purpose. @param number of several streams of one purpose
inline std::uint64_t seed_for(std::uint64_t study_seed, SeedPurpose purpose, std::uint64_t number = 0) {
  return derived_seed(study_seed, static_cast<std::uint64_t>(purpose) + number);
}

}  // namespace unbruised::studies
