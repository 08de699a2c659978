#pragma once

/// @file
/// How many rows are held, and how sure that is.

#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/scenarios/product_sample.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {

/// What is needed of rows on products, in their order, to say P(held).
class HeldRows {
 public:
  void add(const ScenarioResult& result, const LimitParameters& limits);
  [[nodiscard]] Proportion proportion(const ProductSample& products, double confidence) const;

 private:
  std::vector<bool> held_;
  std::vector<double> measure_;
};

}  // namespace unbruised::studies
