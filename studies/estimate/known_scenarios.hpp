#pragma once

/// @file
/// The scenarios of a study that are known before it runs.

#include "studies/config/study.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {

/// All scenarios; of a window study one per combination; of a search the strategy as written, on some of its
/// products.
ScenarioSet known_scenarios(const Study& study);

}  // namespace unbruised::studies
