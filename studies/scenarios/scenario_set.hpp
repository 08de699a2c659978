#pragma once

/// @file
/// The scenarios of the kinds whose number is known before anything runs: grids (simulate, sweep), random products
/// (sample), strategies on the same products (compare), designs (sensitivity).

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"
#include "studies/scenarios/product_sample.hpp"
#include "studies/statistics/design.hpp"

namespace unbruised::studies {

/// Scenarios 0 .. count - 1; safe to use from several threads at once.
struct ScenarioSet {
  std::size_t count = 0;
  std::vector<ColumnInfo> columns;
  std::function<Scenario(std::size_t id)> scenario;
  std::function<std::vector<InputValue>(std::size_t id)> inputs;
};

/// The values of the varied keys at one point of a study's [[vary]] grid.
std::vector<InputValue> grid_inputs(const Study& study, std::size_t point);

/// Of any kind but window and those that search; of a window study the points of its grid.
ScenarioSet scenario_set(const Study& study);

/// The factor group of each scenario, numbered in the order of their first ones.
std::vector<std::size_t> factor_groups(const ScenarioSet& set);

/// compare: number of the candidate, and of the product, of a scenario. The product is the slower one.
struct CompareIndex {
  std::size_t product = 0;
  std::size_t candidate = 0;
};
CompareIndex compare_index(const Study& study, std::size_t id);

/// The random products of a sample or compare study.
ProductSample study_products(const Study& study);

/// The design of a sensitivity study in the unit cube, before it is mapped onto values. Keys that change the
/// factored matrix are moved to the middles of `levels` equally likely parts.
UnitDesign sensitivity_design(const Study& study);

/// The input column of a compare study that names the strategy.
inline constexpr const char* kCandidateColumn = "candidate";

}  // namespace unbruised::studies
