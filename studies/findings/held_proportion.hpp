#pragma once

/// @file
/// How many rows are held, and how sure that is.

#include <vector>

#include "core/scenario/scenario.hpp"
#include "studies/results/rows.hpp"
#include "studies/scenarios/product_sample.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {

/// P(held) of rows on products, in their order.
Proportion held_proportion(const std::vector<const ScenarioRow*>& rows, const ProductSample& products,
                           const LimitParameters& limits, double confidence);

}  // namespace unbruised::studies
