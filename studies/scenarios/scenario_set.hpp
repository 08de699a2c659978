#pragma once

/// @file
/// The scenarios of the kinds whose number is known before anything runs: grids (simulate, sweep), random products
/// (sample), strategies on the same products (compare), designs (sensitivity).

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/results/digest.hpp"
#include "studies/results/scenario_row.hpp"
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

/// Numbers factor groups in the order in which their first scenarios come. Of more than a million groups those
/// that come later are not known again: each of their scenarios is a group of its own.
class GroupNumbers {
 public:
  static constexpr std::size_t kKnownMost = std::size_t{1} << 20;
  std::size_t number_of(const Scenario& scenario);
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  struct Hash {
    std::size_t operator()(const WideDigest& key) const { return key.low; }
  };
  std::unordered_map<WideDigest, std::size_t, Hash> known_;
  std::size_t count_ = 0;
};

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
