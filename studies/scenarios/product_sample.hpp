#pragma once

/// @file
/// Random products: one value per random key and product, the same products for every strategy that is judged on
/// them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"
#include "studies/statistics/replicates.hpp"

namespace unbruised::studies {

/// A drawn set of products. Keys that change the factored matrix (stiffness, size, mass) take few joint values, so
/// that the products form few factor groups; all other keys take a value of their own in each product.
struct ProductSample {
  std::vector<std::string> keys;
  std::vector<double> values;          ///< [product][key]
  std::vector<std::size_t> group;      ///< of each product: which joint value of the keys that change the factor
  std::vector<std::size_t> replicate;  ///< of each product: which of the independent designs; empty: all are drawn
                                       ///< independently

  [[nodiscard]] std::size_t size() const { return group.size(); }
  [[nodiscard]] std::span<const double> at(std::size_t product) const {
    return {values.data() + product * keys.size(), keys.size()};
  }
  /// What the products share: what an interval of them needs to know. Of the sample, which must outlive it.
  [[nodiscard]] SampleStructure structure() const;
  /// The first products, at most `count`.
  [[nodiscard]] ProductSample first(std::size_t count) const;
  /// All values of one key.
  [[nodiscard]] std::vector<double> column(std::size_t key) const;
};

/// Draws `count` products by the study's [sampling] and [[random]]. @param seed products of other seeds are
/// independent
ProductSample draw_products(const Study& study, std::size_t count, std::uint64_t seed);

/// Table `random`: the keys, their distributions, and mean and standard deviation of what was drawn. Of studies
/// with correlations table `correlation` too: wanted and drawn.
std::vector<ResultTable> random_tables(const Study& study, const ProductSample& sample);

}  // namespace unbruised::studies
