#include <cmath>
#include <utility>

#include "studies/findings/candidate_settings.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/paired_comparison.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

class CompareTables {
 public:
  CompareTables(const Study& study, const StudyRows& rows) : study_(study), comparison_(study, rows) {}

  std::vector<ResultTable> all() const {
    std::vector<ResultTable> tables = {candidates(), differences()};
    for (ResultTable& table : random_tables(study_, comparison_.products())) tables.push_back(std::move(table));
    return tables;
  }

 private:
  [[nodiscard]] std::size_t count() const { return study_.candidates().size(); }

  ResultTable candidates() const {
    ResultTable table{.name = "candidates", .row = "candidate_number", .columns = {}, .attributes = {}};
    std::vector<std::string> names;
    for (std::size_t c = 0; c < count(); ++c) names.push_back(comparison_.name(c));
    table.columns.push_back({"name", "", "strategy", std::move(names)});
    for (ResultColumn& column : candidate_settings(study_.candidates()))
      table.columns.push_back(std::move(column));
    add_outcomes(table);
    add_probabilities(table);
    for (const Metric metric : study_.compare().metrics) add_means(table, metric);
    table.attributes.emplace_back("confidence", study_.sampling().confidence);
    table.attributes.emplace_back("products", static_cast<double>(comparison_.products().size()));
    return table;
  }

  void add_outcomes(ResultTable& table) const {
    std::vector<std::vector<double>> counts(kOutcomeWords.size(), std::vector<double>(count(), 0.0));
    for (std::size_t c = 0; c < count(); ++c) {
      for (std::size_t p = 0; p < comparison_.products().size(); ++p) {
        const Outcome outcome = comparison_.outcome(p, c);
        if (outcome != Outcome::not_run) ++counts[static_cast<std::size_t>(outcome)][c];
      }
    }
    for (std::size_t k = 0; k < counts.size(); ++k) {
      table.columns.push_back({std::string(kOutcomeWords[k]), "1", "products with this outcome", counts[k]});
    }
  }

  void add_probabilities(ResultTable& table) const {
    std::vector<double> estimate, low, high;
    for (std::size_t c = 0; c < count(); ++c) {
      const Proportion found = comparison_.held_proportion(c);
      estimate.push_back(found.estimate);
      low.push_back(found.interval.low);
      high.push_back(found.interval.high);
    }
    table.columns.push_back({"probability", "1", "estimated P(held)", std::move(estimate)});
    table.columns.push_back({"probability_low", "1", "lower end of its interval", std::move(low)});
    table.columns.push_back({"probability_high", "1", "upper end of its interval", std::move(high)});
  }

  void add_means(ResultTable& table, Metric metric) const {
    std::vector<double> means, products;
    for (std::size_t c = 0; c < count(); ++c) {
      double sum = 0.0;
      double number = 0.0;
      for (std::size_t p = 0; p < comparison_.products().size(); ++p) {
        const double value = comparison_.value(p, c, metric);
        if (comparison_.outcome(p, c) != Outcome::held || std::isnan(value)) continue;
        sum += value;
        number += 1.0;
      }
      means.push_back(number == 0.0 ? kAbsent : sum / number);
      products.push_back(number);
    }
    const std::string name(info_of(metric).name);
    table.columns.push_back(
        {joined({"mean_", name}), std::string(info_of(metric).units), "over the products held", std::move(means)});
    table.columns.push_back({joined({"products_", name}), "1", "products the mean is over", std::move(products)});
  }

  ResultTable differences() const;

  const Study& study_;
  const CandidateComparison comparison_;
};

/// The rows of /comparison, filled pair by pair.
struct DifferenceRows {
  std::vector<std::string> as, bs, metrics, units, verdicts, winners;
  std::vector<double> pairs, means, lows, highs, relatives, wins, ties, losses, helds, held_lows, held_highs;

  void add(const PairedComparison& pair, Metric metric) {
    metrics.emplace_back(info_of(metric).name);
    units.emplace_back(info_of(metric).units);
    pairs.push_back(static_cast<double>(pair.difference.count));
    means.push_back(pair.difference.mean);
    lows.push_back(pair.difference.interval.low);
    highs.push_back(pair.difference.interval.high);
    relatives.push_back(pair.relative);
    wins.push_back(static_cast<double>(pair.wins));
    ties.push_back(static_cast<double>(pair.ties));
    losses.push_back(static_cast<double>(pair.losses));
    helds.push_back(pair.held.mean);
    held_lows.push_back(pair.held.interval.low);
    held_highs.push_back(pair.held.interval.high);
  }

  std::vector<ResultColumn> take() {
    return {{"a", "", "one strategy", std::move(as)},
            {"b", "", "the other strategy", std::move(bs)},
            {"held_difference", "1", "part of the products held, b - a, paired", std::move(helds)},
            {"held_low", "1", "lower end of its interval", std::move(held_lows)},
            {"held_high", "1", "upper end of its interval", std::move(held_highs)},
            {"metric", "", "compared metric", std::move(metrics)},
            {"metric_units", "", "its unit", std::move(units)},
            {"pairs", "1", "products that both hold", std::move(pairs)},
            {"mean_difference", "", "b - a over these products", std::move(means)},
            {"low", "", "lower end of its interval", std::move(lows)},
            {"high", "", "upper end of its interval", std::move(highs)},
            {"relative_difference", "1", "mean_difference in parts of a's mean", std::move(relatives)},
            {"wins", "1", "products on which a is better", std::move(wins)},
            {"ties", "1", "products without a difference", std::move(ties)},
            {"losses", "1", "products on which b is better", std::move(losses)},
            {"winner", "", "holding first, then the metric; empty: none", std::move(winners)},
            {"verdict", "", "in one sentence", std::move(verdicts)}};
  }
};

ResultTable CompareTables::differences() const {
  DifferenceRows rows;
  std::vector<std::string> all;
  for (std::size_t a = 0; a < count(); ++a) {
    for (std::size_t b = a + 1; b < count(); ++b) {
      for (const Metric metric : study_.compare().metrics) {
        const PairedComparison pair = comparison_.compare(a, b, metric);
        const Winner winner = comparison_.winner(pair, metric);
        rows.add(pair, metric);
        rows.as.push_back(comparison_.name(a));
        rows.bs.push_back(comparison_.name(b));
        rows.winners.push_back(winner == Winner::none ? "" : comparison_.name(winner == Winner::a ? a : b));
        rows.verdicts.push_back(comparison_.verdict(a, b, metric, pair));
        if (metric == study_.compare().metric) all.push_back(rows.verdicts.back());
      }
    }
  }
  const std::size_t best = comparison_.overall_winner();
  return {.name = "comparison",
          .row = "difference",
          .columns = rows.take(),
          .attributes = {{"headline", comparison_.headline()},
                         {"winner", best == count() ? std::string() : comparison_.name(best)},
                         {"verdict", separated(all, "; ")},
                         {"confidence", study_.sampling().confidence}}};
}

}  // namespace

std::vector<ResultTable> compare_tables(const Study& study, const StudyRows& rows) {
  return CompareTables(study, rows).all();
}

}  // namespace unbruised::studies
