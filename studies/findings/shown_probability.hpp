#pragma once

/// @file
/// Two things that are easily taken for one: a probability that the estimate meets, and one that its interval
/// shows. What is needed to get from the first to the second.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {

/// Is P >= wanted met by the estimate, and is it shown by the interval?
enum class Shown { broken, met_by_the_estimate, shown };
Shown shown(double wanted, const Proportion& found);

/// A sample as large as would show P >= wanted, were the estimate and the likeness of products the same.
struct NeededSample {
  std::size_t products = 0;       ///< sampling.count
  std::size_t factor_groups = 0;  ///< sampling.factor_groups; 0: every product its own
};
/// Is each product a factor group of its own, or do several share one, so that they are alike?
enum class FactorGroups { own, shared };
FactorGroups factor_groups_of(const Study& study);

/// @param sampling of the study
/// @return nothing where it is shown already, or where no sample would: the estimate does not lie above `wanted`
std::optional<NeededSample> needed_sample(double wanted, const Proportion& found, const SamplingSettings& sampling,
                                          FactorGroups groups);

/// "met by the estimate only: ...; sampling.count = 400 with sampling.factor_groups = 0 would show it", or "shown
/// by the interval"; of a broken one empty.
std::string shown_text(double wanted, const Proportion& found, const Study& study);

/// Before a run: the probability constraints that this many products cannot show, one sentence each.
std::vector<std::string> probability_doubts(const Study& study);
/// Before a run: those that they may not show, depending on how alike products of a factor group turn out; after
/// it the answer itself says what is shown.
std::vector<std::string> probability_notes(const Study& study);

}  // namespace unbruised::studies
