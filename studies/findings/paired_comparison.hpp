#pragma once

/// @file
/// Two strategies on the same products: who is held without damage more often, then who is better in a metric, and
/// who wins.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "studies/config/study.hpp"
#include "studies/findings/held_proportion.hpp"
#include "studies/results/rows.hpp"
#include "studies/scenarios/product_sample.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {

/// What two strategies, a and b, did to the same products, in one metric.
struct PairedComparison {
  std::size_t held_a = 0;  ///< products that a holds without damage
  std::size_t held_b = 0;
  MeanInterval held;        ///< the difference of these parts, b - a, of all products
  MeanInterval difference;  ///< b - a in the metric, over the products that both hold
  double relative = 0.0;    ///< its mean in parts of a's mean over the same products; NaN where that is zero
  std::size_t wins = 0;     ///< products on which a is better: held where b is not, else better in the metric
  std::size_t ties = 0;
  std::size_t losses = 0;
};

/// Which of two strategies wins, if one does.
enum class Winner { none, a, b };

/// Compares the candidates of a study, pair by pair. All pairs together keep the study's confidence (Bonferroni).
class CandidateComparison {
 public:
  /// @param rows all of the study's, by id
  CandidateComparison(const Study& study, const StudyRows& rows);

  [[nodiscard]] PairedComparison compare(std::size_t a, std::size_t b, Metric metric) const;
  /// Who is shown to be held more often; where neither is, who is shown to be better in the metric, unless the
  /// other one was held more often.
  [[nodiscard]] Winner winner(const PairedComparison& pair, Metric metric) const;
  /// Holding first, with its interval; then the metric with unit and per cent.
  [[nodiscard]] std::string verdict(std::size_t a, std::size_t b, Metric metric,
                                    const PairedComparison& pair) const;
  /// The candidate that wins against all others in the study's metric; their number when there is none.
  [[nodiscard]] std::size_t overall_winner() const;
  /// "winner: gentle, ..." or "no winner: ...".
  [[nodiscard]] std::string headline() const;

  [[nodiscard]] Outcome outcome(std::size_t product, std::size_t candidate) const;
  /// Of the study's metrics one.
  [[nodiscard]] double value(std::size_t product, std::size_t candidate, Metric metric) const;
  [[nodiscard]] Proportion held_proportion(std::size_t candidate) const;
  [[nodiscard]] const ProductSample& products() const { return products_; }
  [[nodiscard]] const std::string& name(std::size_t candidate) const;

 private:
  [[nodiscard]] std::string holding_text(std::size_t a, std::size_t b, const PairedComparison& pair) const;
  [[nodiscard]] std::string metric_text(std::size_t a, std::size_t b, Metric metric,
                                        const PairedComparison& pair) const;
  [[nodiscard]] std::size_t held_count(std::size_t candidate) const;
  /// "95 % interval"
  [[nodiscard]] std::string confidence_text() const;
  /// "28 of 32"
  [[nodiscard]] std::string count_text(std::size_t held) const;
  /// "old on 28, older on 25": all but the candidate
  [[nodiscard]] std::string others_text(std::size_t candidate) const;
  /// What the winner wins by: holding, or the metric.
  [[nodiscard]] std::string reason_text(std::size_t winner) const;

  const Study& study_;
  [[nodiscard]] std::size_t place(std::size_t product, std::size_t candidate) const;
  [[nodiscard]] bool is_held(std::size_t product, std::size_t candidate) const;

  // Of the rows what is compared, by place.
  std::vector<Outcome> outcomes_;
  std::map<Metric, std::vector<double>> values_;
  std::vector<HeldRows> held_;  ///< of each candidate
  const ProductSample products_;
  double confidence_ = 0.95;
  std::string held_words_;  ///< "held without damage", or "held" where damage is not judged
};

}  // namespace unbruised::studies
