#pragma once

/// @file
/// What the candidates of a comparison are: the keys in which their strategies differ.

#include <vector>

#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// One column per key of [strategy] whose value is not the same for all, in the order of the key reference; of
/// numbers with their unit, of words as texts.
std::vector<ResultColumn> candidate_settings(const std::vector<StrategyCandidate>& candidates);

}  // namespace unbruised::studies
