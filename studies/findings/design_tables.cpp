#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/findings/found_tables.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/goals/goal.hpp"
#include "studies/scenarios/product_sample.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/statistics/intervals.hpp"
#include "studies/statistics/sensitivity.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Stream of the study's seed for bootstrap draws.
constexpr std::uint64_t kBootstrap = 105;

const MetricInfo& info_of(Metric metric) { return kMetricTable[static_cast<std::size_t>(metric)]; }

bool is_held(const ScenarioRow& row) { return row.result.outcome == Outcome::held; }

/// P(held) of rows on products, in their order.
Proportion held_proportion(const std::vector<const ScenarioRow*>& rows, const ProductSample& products,
                           const LimitParameters& limits, double confidence) {
  std::vector<bool> held;
  std::vector<double> measure;
  for (const ScenarioRow* row : rows) {
    held.push_back(is_held(*row));
    measure.push_back(event_measure(held_event(), row->result, limits));
  }
  return proportion(held, products.group, confidence, measure);
}

// -- compare. ----------------------------------------------------------------------------------------------

/// What two strategies did to the same products, in one metric.
struct PairedDifference {
  MeanInterval difference;  ///< b - a over the products that both hold
  std::size_t wins = 0;     ///< products on which a is better
  std::size_t ties = 0;
  std::size_t losses = 0;
};

class Comparison {
 public:
  Comparison(const Study& study, const std::vector<ScenarioRow>& rows)
      : study_(study), rows_(rows), products_(study_products(study)) {
    const std::size_t n = study.candidates().size();
    // Bonferroni: all pairs together keep the confidence.
    const double pairs = static_cast<double>(n * (n - 1) / 2);
    confidence_ = 1.0 - (1.0 - study.sampling().confidence) / pairs;
  }

  std::vector<ResultTable> tables() {
    ResultTable differences = comparison();
    return {candidates(), std::move(differences), random_table(study_, products_)};
  }

 private:
  [[nodiscard]] const ScenarioRow& row(std::size_t product, std::size_t candidate) const {
    return rows_[product * study_.candidates().size() + candidate];
  }
  [[nodiscard]] const std::string& name(std::size_t candidate) const {
    return study_.candidates()[candidate].name;
  }

  ResultTable candidates() const {
    const std::size_t n = study_.candidates().size();
    std::vector<std::string> names;
    std::vector<std::vector<double>> counts(kOutcomeWords.size(), std::vector<double>(n, 0.0));
    std::vector<double> probability;
    std::vector<double> low;
    std::vector<double> high;
    for (std::size_t c = 0; c < n; ++c) {
      names.push_back(name(c));
      std::vector<const ScenarioRow*> own;
      for (std::size_t p = 0; p < products_.size(); ++p) {
        const Outcome outcome = row(p, c).result.outcome;
        if (outcome != Outcome::not_run) ++counts[static_cast<std::size_t>(outcome)][c];
        own.push_back(&row(p, c));
      }
      const Proportion estimate =
          held_proportion(own, products_, study_.candidates()[c].scenario.limits, study_.sampling().confidence);
      probability.push_back(estimate.estimate);
      low.push_back(estimate.interval.low);
      high.push_back(estimate.interval.high);
    }
    ResultTable table{.name = "candidates", .row = "candidate_number", .columns = {}, .attributes = {}};
    table.columns.push_back({"name", "", "strategy", std::move(names)});
    for (std::size_t k = 0; k < counts.size(); ++k) {
      table.columns.push_back({std::string(kOutcomeWords[k]), "1", "products with this outcome", counts[k]});
    }
    table.columns.push_back({"probability", "1", "estimated P(held)", std::move(probability)});
    table.columns.push_back({"probability_low", "1", "lower end of its interval", std::move(low)});
    table.columns.push_back({"probability_high", "1", "upper end of its interval", std::move(high)});
    for (const Metric metric : study_.compare().metrics) table.columns.push_back(mean_column(metric));
    table.attributes.emplace_back("confidence", study_.sampling().confidence);
    return table;
  }

  ResultColumn mean_column(Metric metric) const {
    std::vector<double> means;
    for (std::size_t c = 0; c < study_.candidates().size(); ++c) {
      double sum = 0.0;
      std::size_t count = 0;
      for (std::size_t p = 0; p < products_.size(); ++p) {
        const double value = row(p, c).result.metrics[metric];
        if (!is_held(row(p, c)) || std::isnan(value)) continue;
        sum += value;
        ++count;
      }
      means.push_back(count == 0 ? kAbsent : sum / static_cast<double>(count));
    }
    return {joined({"mean_", info_of(metric).name}), std::string(info_of(metric).units), "over the products held",
            std::move(means)};
  }

  /// A product that is held beats one that is not; of two held ones the metric decides.
  PairedDifference compared(std::size_t a, std::size_t b, Metric metric) const {
    PairedDifference pair;
    std::vector<double> differences;
    std::vector<std::size_t> groups;
    const double tie = metric == study_.compare().metric ? study_.compare().tie : 0.0;
    for (std::size_t p = 0; p < products_.size(); ++p) {
      const bool held_a = is_held(row(p, a));
      const bool held_b = is_held(row(p, b));
      const double difference = row(p, b).result.metrics[metric] - row(p, a).result.metrics[metric];
      const bool both = held_a && held_b && !std::isnan(difference);
      if (both) {
        differences.push_back(difference);
        groups.push_back(products_.group[p]);
      }
      if (held_a != held_b) {
        ++(held_a ? pair.wins : pair.losses);
      } else if (!both || std::abs(difference) <= tie) {
        ++pair.ties;
      } else {
        ++((difference > 0.0) != more_is_better(metric) ? pair.wins : pair.losses);
      }
    }
    pair.difference = differences.empty() ? MeanInterval{kAbsent, {kAbsent, kAbsent}, 0}
                                          : mean_interval(differences, groups, confidence_);
    return pair;
  }

  /// Difference of P(held), b - a, over the same products.
  MeanInterval held_difference(std::size_t a, std::size_t b) const {
    std::vector<double> differences;
    for (std::size_t p = 0; p < products_.size(); ++p) {
      differences.push_back((is_held(row(p, b)) ? 1.0 : 0.0) - (is_held(row(p, a)) ? 1.0 : 0.0));
    }
    return mean_interval(differences, products_.group, confidence_);
  }

  static int sign_of(const MeanInterval& difference) {
    if (difference.count == 0) return 0;
    if (difference.interval.low > 0.0) return 1;
    return difference.interval.high < 0.0 ? -1 : 0;
  }

  /// One sentence about a pair: who is held more often, who needs less of the metric, or that nothing is shown.
  std::string verdict_of(std::size_t a, std::size_t b, Metric metric, const PairedDifference& pair) const {
    const int held = sign_of(held_difference(a, b));
    const int better = (more_is_better(metric) ? 1 : -1) * sign_of(pair.difference);  // 1: b is better
    const std::string is_better = better == 0 ? std::string() : difference_text(a, b, metric, pair.difference);
    if (held == 0 && better == 0) return joined({name(a), " and ", name(b), ": no difference shown"});
    if (held == 0) return is_better;
    const std::string more = joined({name(held > 0 ? b : a), " is held more often (",
                                     percent(std::abs(held_difference(a, b).mean)), " of the products)"});
    if (better == 0) return joined({more, "; no difference shown in ", info_of(metric).name});
    return joined({more, held == better ? ", and " : ", but ", is_better});
  }

  std::string difference_text(std::size_t a, std::size_t b, Metric metric, const MeanInterval& difference) const {
    const bool more = more_is_better(metric);
    const bool b_better = (difference.mean > 0.0) == more;
    const double low = std::min(std::abs(difference.interval.low), std::abs(difference.interval.high));
    const double high = std::max(std::abs(difference.interval.low), std::abs(difference.interval.high));
    return joined({name(b_better ? b : a), more ? " has more " : " needs less ", info_of(metric).name, " than ",
                   name(b_better ? a : b), ": by ", short_number(std::abs(difference.mean)), " (",
                   percent(study_.sampling().confidence), " interval ", short_number(low), " to ",
                   short_number(high), ")"});
  }

  ResultTable comparison() const {
    std::vector<std::string> as, bs, metrics, verdicts;
    std::vector<double> pairs, means, lows, highs, wins, ties, losses;
    std::string all;
    const std::size_t n = study_.candidates().size();
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        for (const Metric metric : study_.compare().metrics) {
          const PairedDifference pair = compared(a, b, metric);
          as.push_back(name(a));
          bs.push_back(name(b));
          metrics.emplace_back(info_of(metric).name);
          pairs.push_back(static_cast<double>(pair.difference.count));
          means.push_back(pair.difference.mean);
          lows.push_back(pair.difference.interval.low);
          highs.push_back(pair.difference.interval.high);
          wins.push_back(static_cast<double>(pair.wins));
          ties.push_back(static_cast<double>(pair.ties));
          losses.push_back(static_cast<double>(pair.losses));
          verdicts.push_back(verdict_of(a, b, metric, pair));
          if (metric == study_.compare().metric) all += joined({all.empty() ? "" : "; ", verdicts.back()});
        }
      }
    }
    return {.name = "comparison",
            .row = "difference",
            .columns = {{"a", "", "one strategy", std::move(as)},
                        {"b", "", "the other strategy", std::move(bs)},
                        {"metric", "", "compared metric", std::move(metrics)},
                        {"pairs", "1", "products that both hold", std::move(pairs)},
                        {"mean_difference", "", "b - a over these products", std::move(means)},
                        {"low", "", "lower end of its interval", std::move(lows)},
                        {"high", "", "upper end of its interval", std::move(highs)},
                        {"wins", "1", "products on which a is better", std::move(wins)},
                        {"ties", "1", "products without a difference", std::move(ties)},
                        {"losses", "1", "products on which b is better", std::move(losses)},
                        {"verdict", "", "in one sentence", std::move(verdicts)}},
            .attributes = {{"verdict", all}, {"confidence", study_.sampling().confidence}}};
  }

  const Study& study_;
  const std::vector<ScenarioRow>& rows_;
  const ProductSample products_;
  double confidence_ = 0.95;
};

std::vector<double> answers_of(const std::vector<ScenarioRow>& rows, Metric metric) {
  std::vector<double> answers;
  answers.reserve(rows.size());
  for (const ScenarioRow& row : rows) answers.push_back(row.result.metrics[metric]);
  return answers;
}

/// Rows of a table that is filled line by line.
class EffectTable {
 public:
  explicit EffectTable(std::vector<std::pair<std::string, std::string>> columns) : columns_(std::move(columns)) {
    values_.resize(columns_.size());
  }
  void add(const std::string& key, const std::string& metric, const std::vector<double>& numbers) {
    keys_.push_back(key);
    metrics_.push_back(metric);
    for (std::size_t i = 0; i < numbers.size(); ++i) values_[i].push_back(numbers[i]);
  }
  ResultTable take() {
    ResultTable table{.name = "sensitivity", .row = "effect", .columns = {}, .attributes = {}};
    table.columns.push_back({"key", "", "random key", std::move(keys_)});
    table.columns.push_back({"metric", "", "metric", std::move(metrics_)});
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      table.columns.push_back({columns_[i].first, "", columns_[i].second, std::move(values_[i])});
    }
    return table;
  }

 private:
  std::vector<std::pair<std::string, std::string>> columns_;
  std::vector<std::string> keys_, metrics_;
  std::vector<std::vector<double>> values_;
};

ResultTable sobol_table(const Study& study, const std::vector<ScenarioRow>& rows, std::size_t& used) {
  EffectTable effects({{"first_order", "part of the variance that the key alone explains"},
                       {"first_order_low", "lower end of its interval"},
                       {"first_order_high", "upper end of its interval"},
                       {"total", "part of the variance that vanishes when the key is known last"},
                       {"total_low", "lower end of its interval"},
                       {"total_high", "upper end of its interval"}});
  const UnitDesign design = sensitivity_design(study);
  const SensitivitySettings& settings = study.sensitivity();
  for (const Metric metric : settings.metrics) {
    const SobolResult found = sobol_indices(design, answers_of(rows, metric), settings.bootstrap,
                                            settings.confidence, derived_seed(study.seed(), kBootstrap));
    used = std::min(used, found.used);
    for (std::size_t k = 0; k < found.indices.size(); ++k) {
      const SobolIndex& index = found.indices[k];
      effects.add(study.randoms()[k].key, std::string(info_of(metric).name),
                  {index.first, index.first_interval.low, index.first_interval.high, index.total,
                   index.total_interval.low, index.total_interval.high});
    }
  }
  return effects.take();
}

ResultTable morris_table(const Study& study, const std::vector<ScenarioRow>& rows, std::size_t& used) {
  EffectTable effects({{"mean", "mean elementary effect, in the metric's unit over the key's whole distribution"},
                       {"mean_absolute", "mean of its absolute value: how much the key matters"},
                       {"mean_absolute_low", "lower end of its interval"},
                       {"mean_absolute_high", "upper end of its interval"},
                       {"standard_deviation", "of the effects: bends and interactions"}});
  const UnitDesign design = sensitivity_design(study);
  const SensitivitySettings& settings = study.sensitivity();
  for (const Metric metric : settings.metrics) {
    const MorrisResult found = morris_effects(design, answers_of(rows, metric), settings.confidence,
                                              derived_seed(study.seed(), kBootstrap));
    used = std::min(used, found.used);
    for (std::size_t k = 0; k < found.effects.size(); ++k) {
      const MorrisEffect& effect = found.effects[k];
      effects.add(study.randoms()[k].key, std::string(info_of(metric).name),
                  {effect.mean, effect.mean_absolute, effect.mean_absolute_interval.low,
                   effect.mean_absolute_interval.high, effect.standard_deviation});
    }
  }
  return effects.take();
}

/// Mean, spread and quantiles of every metric that exists.
ResultTable statistics_table(const std::vector<ScenarioRow>& rows) {
  std::vector<std::string> names;
  std::vector<double> counts, means, deviations, lows, medians, highs;
  for (const MetricInfo& info : kMetricTable) {
    std::vector<double> values = answers_of(rows, info.metric);
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.size() < 2) continue;
    const MeanAndSpread moments = mean_and_spread(values);
    names.emplace_back(info.name);
    counts.push_back(static_cast<double>(values.size()));
    means.push_back(moments.mean);
    deviations.push_back(moments.standard_deviation);
    lows.push_back(sample_quantile(values, 0.05));
    medians.push_back(sample_quantile(values, 0.5));
    highs.push_back(sample_quantile(values, 0.95));
  }
  return {.name = "statistics",
          .row = "statistic",
          .columns = {{"metric", "", "metric", std::move(names)},
                      {"count", "1", "products that have it", std::move(counts)},
                      {"mean", "", "in the metric's unit", std::move(means)},
                      {"standard_deviation", "", "in the metric's unit", std::move(deviations)},
                      {"quantile_05", "", "5 % of the products lie below", std::move(lows)},
                      {"median", "", "half of the products lie below", std::move(medians)},
                      {"quantile_95", "", "95 % of the products lie below", std::move(highs)}},
          .attributes = {}};
}

}  // namespace

std::vector<ResultTable> compare_tables(const Study& study, const std::vector<ScenarioRow>& rows) {
  return Comparison(study, rows).tables();
}

std::vector<ResultTable> sensitivity_tables(const Study& study, const std::vector<ScenarioRow>& rows) {
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

std::vector<ResultTable> sample_tables(const Study& study, const std::vector<ScenarioRow>& rows) {
  const ProductSample products = study_products(study);
  ResultTable statistics = statistics_table(rows);
  std::vector<const ScenarioRow*> all;
  for (const ScenarioRow& row : rows) all.push_back(&row);
  const Proportion estimate =
      held_proportion(all, products, study.scenario(0).limits, study.sampling().confidence);
  statistics.attributes = {{"probability", estimate.estimate},
                           {"probability_low", estimate.interval.low},
                           {"probability_high", estimate.interval.high},
                           {"confidence", study.sampling().confidence}};
  return {std::move(statistics), random_table(study, products)};
}

}  // namespace unbruised::studies
