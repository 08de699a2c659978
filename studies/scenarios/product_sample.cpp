#include "studies/scenarios/product_sample.hpp"

#include <algorithm>
#include <utility>

#include "studies/scenarios/joint_law.hpp"
#include "studies/statistics/correlation.hpp"
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
  const SamplingSettings& sampling = study.sampling();
  ProductSample sample;
  for (const RandomVariable& random : study.randoms()) sample.keys.push_back(random.key);
  const JointLaw law(study);
  const std::size_t own = law.own_numbers();
  const std::size_t shared = law.shared_numbers();
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
    const auto shared_number = [&](std::size_t place) { return group_design.at(sample.group[product], place); };
    const auto own_number = [&](std::size_t place) { return own_design.at(product, place); };
    for (const double value : law.draw(shared_number, own_number)) sample.values.push_back(value);
  }
  return sample;
}

std::vector<ResultTable> random_tables(const Study& study, const ProductSample& sample) {
  std::vector<ResultTable> tables = {random_table(study, sample)};
  if (study.correlations().empty()) return tables;
  std::vector<std::string> first, second;
  std::vector<double> wanted, drawn;
  for (const RankCorrelation& c : study.correlations()) {
    first.push_back(sample.keys[c.first]);
    second.push_back(sample.keys[c.second]);
    wanted.push_back(c.value);
    drawn.push_back(spearman(sample.column(c.first), sample.column(c.second)));
  }
  tables.push_back({.name = "correlation",
                    .row = "correlation_pair",
                    .columns = {{"first", "", "random key", std::move(first)},
                                {"second", "", "random key", std::move(second)},
                                {"rank_correlation", "1", "wanted", std::move(wanted)},
                                {"drawn", "1", "of the values drawn", std::move(drawn)}},
                    .attributes = {}});
  return tables;
}

}  // namespace unbruised::studies
