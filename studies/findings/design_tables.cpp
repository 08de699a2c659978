#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "studies/findings/found_tables.hpp"
#include "studies/findings/held_proportion.hpp"
#include "studies/scenarios/product_sample.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/statistics/intervals.hpp"
#include "studies/statistics/seed_purpose.hpp"
#include "studies/statistics/sensitivity.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// The metrics of all rows, column by column, with a few hundred megabytes of them in memory at a time.
class MetricColumns {
 public:
  /// @param metrics in the order in which they will be asked for
  MetricColumns(const StudyRows& rows, std::vector<Metric> metrics) : rows_(rows), metrics_(std::move(metrics)) {}

  [[nodiscard]] const std::vector<double>& next() {
    if (at_ == first_ + columns_.size()) read();
    return columns_[at_++ - first_];
  }

 private:
  static constexpr std::size_t kNumbersMost = 40'000'000;

  void read() {
    const std::size_t most = std::max<std::size_t>(1, kNumbersMost / std::max<std::size_t>(1, rows_.size()));
    first_ = at_;
    columns_.assign(std::min(most, metrics_.size() - first_), {});
    for (std::vector<double>& column : columns_) column.reserve(rows_.size());
    for (const ScenarioRow& row : rows_) {
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        columns_[i].push_back(row.result.metrics[metrics_[first_ + i]]);
      }
    }
  }

  const StudyRows& rows_;
  const std::vector<Metric> metrics_;
  std::vector<std::vector<double>> columns_;  ///< of the metrics from `first_` on
  std::size_t first_ = 0, at_ = 0;
};

/// Rows of a table that is filled line by line.
class EffectTable {
 public:
  explicit EffectTable(std::vector<std::pair<std::string, std::string>> columns) : columns_(std::move(columns)) {
    values_.resize(columns_.size());
  }
  void add(const std::string& key, Metric metric, const std::string& note, const std::vector<double>& numbers) {
    keys_.push_back(key);
    metrics_.emplace_back(info_of(metric).name);
    notes_.push_back(note);
    for (std::size_t i = 0; i < numbers.size(); ++i) values_[i].push_back(numbers[i]);
  }
  ResultTable take() {
    ResultTable table{.name = "sensitivity", .row = "effect", .columns = {}, .attributes = {}};
    table.columns.push_back({"key", "", "random key", std::move(keys_)});
    table.columns.push_back({"metric", "", "metric", std::move(metrics_)});
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      table.columns.push_back({columns_[i].first, "", columns_[i].second, std::move(values_[i])});
    }
    table.columns.push_back({std::string(kEffectNoteColumn), "",
                             "why the metric has no effects to tell; else empty", std::move(notes_)});
    return table;
  }

 private:
  std::vector<std::pair<std::string, std::string>> columns_;
  std::vector<std::string> keys_, metrics_, notes_;
  std::vector<std::vector<double>> values_;
};

/// Why effects on a metric cannot be told, behind its name; empty where they can.
/// @param found a MorrisResult or SobolResult
template <class Found>
std::string effect_note(const Found& found, std::size_t samples) {
  if (found.used == 0) {
    return joined({"has no effects that could be told: each of the ", with_thousands(samples),
                   " samples has a run in which it does not exist"});
  }
  return found.varies ? std::string() : std::string("does not vary, whatever the keys are");
}

ResultTable sobol_table(const Study& study, const StudyRows& rows, std::size_t& used) {
  EffectTable effects({{"first_order", "part of the variance that the key alone explains"},
                       {"first_order_low", "lower end of its interval"},
                       {"first_order_high", "upper end of its interval"},
                       {"total", "part of the variance that vanishes when the key is known last"},
                       {"total_low", "lower end of its interval"},
                       {"total_high", "upper end of its interval"}});
  const UnitDesign design = sensitivity_design(study);
  const SensitivitySettings& settings = study.sensitivity();
  MetricColumns columns(rows, settings.metrics);
  for (const Metric metric : settings.metrics) {
    const SobolResult found = sobol_indices(design, columns.next(), settings.bootstrap, settings.confidence,
                                            seed_for(study.seed(), SeedPurpose::bootstrap));
    used = std::min(used, found.used);
    const std::string note = effect_note(found, settings.samples);
    for (std::size_t k = 0; k < found.indices.size(); ++k) {
      const SobolIndex& index = found.indices[k];
      effects.add(study.randoms()[k].key, metric, note,
                  {index.first, index.first_interval.low, index.first_interval.high, index.total,
                   index.total_interval.low, index.total_interval.high});
    }
  }
  return effects.take();
}

ResultTable morris_table(const Study& study, const StudyRows& rows, std::size_t& used) {
  EffectTable effects({{"mean", "mean elementary effect, in the metric's unit over the key's whole distribution"},
                       {"mean_absolute", "mean of its absolute value: how much the key matters"},
                       {"mean_absolute_low", "lower end of its interval"},
                       {"mean_absolute_high", "upper end of its interval"},
                       {"standard_deviation", "of the effects: bends and interactions"}});
  const UnitDesign design = sensitivity_design(study);
  const SensitivitySettings& settings = study.sensitivity();
  MetricColumns columns(rows, settings.metrics);
  for (const Metric metric : settings.metrics) {
    const MorrisResult found = morris_effects(design, columns.next(), settings.confidence,
                                              seed_for(study.seed(), SeedPurpose::bootstrap));
    used = std::min(used, found.used);
    const std::string note = effect_note(found, settings.samples);
    for (std::size_t k = 0; k < found.effects.size(); ++k) {
      const MorrisEffect& effect = found.effects[k];
      effects.add(study.randoms()[k].key, metric, note,
                  {effect.mean, effect.mean_absolute, effect.mean_absolute_interval.low,
                   effect.mean_absolute_interval.high, effect.standard_deviation});
    }
  }
  return effects.take();
}

/// The values of a metric that exist, and how they depend on each other.
struct KnownValues {
  std::vector<double> values;
  std::vector<std::size_t> group, replicate;
  [[nodiscard]] SampleStructure structure() const { return {group, replicate}; }
};
KnownValues known_values(const std::vector<double>& column, const ProductSample& products) {
  KnownValues known;
  for (std::size_t product = 0; product < column.size(); ++product) {
    const double value = column[product];
    if (std::isnan(value)) continue;
    known.values.push_back(value);
    known.group.push_back(products.group[product]);
    if (!products.replicate.empty()) known.replicate.push_back(products.replicate[product]);
  }
  return known;
}

/// A number of every metric, with its interval.
struct Estimates {
  std::vector<double> value, low, high;
  void add(double estimate, const Interval& interval) {
    value.push_back(estimate);
    low.push_back(interval.low);
    high.push_back(interval.high);
  }
  void put_into(ResultTable& table, const std::string& name, const std::string& meaning) && {
    table.columns.push_back({name, "", meaning, std::move(value)});
    table.columns.push_back({name + "_low", "", "lower end of its interval", std::move(low)});
    table.columns.push_back({name + "_high", "", "upper end of its interval", std::move(high)});
  }
};

/// Mean, spread and quantiles of every metric that exists.
ResultTable statistics_table(const Study& study, const StudyRows& rows, const ProductSample& products) {
  constexpr std::array kParts{0.05, 0.5, 0.95};
  const double confidence = study.sampling().confidence;
  std::vector<std::string> names;
  std::vector<double> counts, deviations;
  Estimates means;
  std::array<Estimates, kParts.size()> quantiles;
  std::vector<Metric> all;
  for (const MetricInfo& info : kMetricTable) all.push_back(info.metric);
  MetricColumns columns(rows, std::move(all));
  for (const MetricInfo& info : kMetricTable) {
    const KnownValues known = known_values(columns.next(), products);
    if (known.values.size() < 2) continue;
    names.emplace_back(info.name);
    counts.push_back(static_cast<double>(known.values.size()));
    const MeanAndSpread moments = mean_and_spread(known.values);
    deviations.push_back(moments.standard_deviation);
    means.add(moments.mean, sampled_mean(known.values, known.structure(), confidence).interval);
    for (std::size_t q = 0; q < kParts.size(); ++q) {
      quantiles[q].add(sample_quantile(known.values, kParts[q]),
                       quantile_interval(known.values, kParts[q], known.structure(), confidence));
    }
  }
  ResultTable table{.name = "statistics", .row = "statistic", .columns = {}, .attributes = {}};
  table.columns.push_back({"metric", "", "metric", std::move(names)});
  table.columns.push_back({"count", "1", "products that have it", std::move(counts)});
  std::move(means).put_into(table, "mean", "in the metric's unit");
  table.columns.push_back({"standard_deviation", "", "in the metric's unit", std::move(deviations)});
  std::move(quantiles[0]).put_into(table, "quantile_05", "5 % of the products lie below");
  std::move(quantiles[1]).put_into(table, "median", "half of the products lie below");
  std::move(quantiles[2]).put_into(table, "quantile_95", "95 % of the products lie below");
  return table;
}

}  // namespace

std::vector<ResultTable> sensitivity_tables(const Study& study, const StudyRows& rows) {
  const bool morris = study.sensitivity().method == SensitivityMethod::morris;
  const std::size_t samples = study.sensitivity().samples;
  std::size_t used = samples;
  ResultTable table = morris ? morris_table(study, rows, used) : sobol_table(study, rows, used);
  table.attributes.emplace_back("method", morris ? std::string("morris") : std::string("sobol"));
  table.attributes.emplace_back("samples", static_cast<double>(samples));
  table.attributes.emplace_back("left_out", static_cast<double>(samples - used));
  table.attributes.emplace_back("confidence", study.sensitivity().confidence);
  return {std::move(table)};
}

std::vector<ResultTable> sample_tables(const Study& study, const StudyRows& rows) {
  const ProductSample products = study_products(study);
  ResultTable statistics = statistics_table(study, rows, products);
  const LimitParameters limits = study.scenario(0).limits;
  HeldRows held;
  for (const ScenarioRow& row : rows) held.add(row.result, limits);
  const Proportion estimate = held.proportion(products, study.sampling().confidence);
  statistics.attributes = {{"probability", estimate.estimate},
                           {"probability_low", estimate.interval.low},
                           {"probability_high", estimate.interval.high},
                           {"confidence", study.sampling().confidence}};
  std::vector<ResultTable> tables = {std::move(statistics)};
  for (ResultTable& table : random_tables(study, products)) tables.push_back(std::move(table));
  return tables;
}

}  // namespace unbruised::studies
