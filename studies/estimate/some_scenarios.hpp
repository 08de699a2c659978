#pragma once

/// @file
/// A few scenarios that stand for all of a study.

#include <cstddef>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Calls look(scenario) with at most so many of them, evenly spread over the study from the first one on.
template <class Look>
void look_at_some(const Study& study, std::size_t most, Look&& look) {
  const std::size_t stride = 1 + (study.scenario_count() - 1) / most;
  for (std::size_t id = 0; id < study.scenario_count(); id += stride) look(study.scenario(id));
}

/// For what takes microseconds of each.
inline constexpr std::size_t kLookedAt = 64;

}  // namespace unbruised::studies
