#include "studies/scenarios/product_sample.hpp"

#include <algorithm>
#include <utility>

#include "studies/statistics/design.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {
namespace {

/// Streams of the seed, one per use.
enum Purpose : std::uint64_t { kOwnValues = 1, kGroupValues = 2, kGroupOrder = 3 };

/// The numbers below `count` of one replicate.
std::vector<std::size_t> of_replicate(std::size_t count, std::size_t replicate, std::size_t replicates) {
  std::vector<std::size_t> own;
  for (std::size_t i = replicate; i < count; i += replicates) own.push_back(i);
  return own;
}

/// Products of a replicate share its groups evenly and in a random order: in the order of the design, its first
/// dimension would be confounded with the group.
std::vector<std::size_t> groups_of_products(std::size_t count, std::size_t groups, std::size_t replicates,
                                            std::uint64_t seed) {
  std::vector<std::size_t> group(count);
  for (std::size_t r = 0; r < replicates; ++r) {
    const std::vector<std::size_t> products = of_replicate(count, r, replicates);
    const std::vector<std::size_t> own = of_replicate(groups, r, replicates);
    const std::vector<std::size_t> order = random_order(products.size(), derived_seed(seed, kGroupOrder), r);
    for (std::size_t i = 0; i < products.size(); ++i) group[products[order[i]]] = own[i % own.size()];
  }
  return group;
}

}  // namespace

std::vector<double> ProductSample::column(std::size_t key) const {
  std::vector<double> numbers;
  numbers.reserve(size());
  for (std::size_t product = 0; product < size(); ++product) numbers.push_back(at(product)[key]);
  return numbers;
}

SampleStructure ProductSample::structure() const { return {group, replicate}; }

ProductSample ProductSample::first(std::size_t count) const {
  ProductSample some = *this;
  some.group.resize(std::min(count, size()));
  some.replicate.resize(std::min(count, replicate.size()));
  some.values.resize(some.size() * keys.size());
  return some;
}

ProductSample draw_products(const Study& study, std::size_t count, std::uint64_t seed) {
  const std::vector<RandomVariable>& randoms = study.randoms();
  const SamplingSettings& sampling = study.sampling();
  ProductSample sample;
  std::vector<std::size_t> place(randoms.size());  // of a key among those of its sort
  std::size_t own = 0;
  std::size_t shared = 0;
  for (std::size_t k = 0; k < randoms.size(); ++k) {
    sample.keys.push_back(randoms[k].key);
    place[k] = randoms[k].changes_factor ? shared++ : own++;
  }
  const std::size_t groups =
      sampling.factor_groups == 0 ? count : std::min<std::size_t>(sampling.factor_groups, count);
  const std::size_t replicates = replicate_count(sampling.design, shared > 0 ? groups : count);
  if (shared > 0) {
    sample.group = groups_of_products(count, groups, replicates, seed);
  } else {
    sample.group.resize(count);
  }
  if (sampling.design != DesignKind::random) {
    for (std::size_t product = 0; product < count; ++product) sample.replicate.push_back(product % replicates);
  }
  UnitDesign own_design;
  UnitDesign group_design;
  if (own > 0) {
    own_design = replicated_design({sampling.design, count, own, replicates}, derived_seed(seed, kOwnValues));
  }
  if (shared > 0) {
    group_design =
        replicated_design({sampling.design, groups, shared, replicates}, derived_seed(seed, kGroupValues));
  }
  for (std::size_t product = 0; product < count; ++product) {
    for (std::size_t k = 0; k < randoms.size(); ++k) {
      const double u = randoms[k].changes_factor ? group_design.at(sample.group[product], place[k])
                                                 : own_design.at(product, place[k]);
      sample.values.push_back(quantile(randoms[k].distribution, u));
    }
  }
  return sample;
}

ResultTable random_table(const Study& study, const ProductSample& sample) {
  std::vector<std::string> distributions;
  std::vector<double> means;
  std::vector<double> deviations;
  for (std::size_t k = 0; k < sample.keys.size(); ++k) {
    distributions.push_back(distribution_text(study.randoms()[k].distribution));
    const MeanAndSpread drawn = mean_and_spread(sample.column(k));
    means.push_back(drawn.mean);
    deviations.push_back(drawn.standard_deviation);
  }
  return {.name = "random",
          .row = "random_key",
          .columns = {{"key", "", "random key", sample.keys},
                      {"distribution", "", "what it was drawn from", std::move(distributions)},
                      {"mean", "", "of the values drawn, in the key's unit", std::move(means)},
                      {"standard_deviation", "", "of the values drawn, in the key's unit", std::move(deviations)}},
          .attributes = {}};
}

}  // namespace unbruised::studies
