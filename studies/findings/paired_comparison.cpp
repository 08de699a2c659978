#include "studies/findings/paired_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "studies/config/schema.hpp"
#include "studies/findings/claims.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/goals/goal.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// " s", " m/s2"; empty without a unit.
std::string unit_text(Metric metric) {
  const Unit* unit = unit_of(info_of(metric).name);
  return unit == nullptr ? std::string() : joined({" ", unit->display});
}

/// 1: shown to be above zero; -1: below; 0: neither.
int sign_of(const MeanInterval& difference) {
  if (difference.count == 0) return 0;
  if (difference.interval.low > 0.0) return 1;
  return difference.interval.high < 0.0 ? -1 : 0;
}

/// The ends of an interval of a difference whose sign is said in words.
Interval sizes_of(const Interval& interval) {
  return {std::min(std::abs(interval.low), std::abs(interval.high)),
          std::max(std::abs(interval.low), std::abs(interval.high))};
}

Winner winner_of(int sign) { return sign == 0 ? Winner::none : (sign > 0 ? Winner::b : Winner::a); }

}  // namespace

CandidateComparison::CandidateComparison(const Study& study, const StudyRows& rows)
    : study_(study),
      held_(study.candidates().size()),
      products_(study_products(study)),
      held_words_(held_words(damage_sentence(damage_claim(study)))) {
  const std::size_t n = study.candidates().size();
  const double pairs = static_cast<double>(n * (n - 1) / 2);
  confidence_ = 1.0 - (1.0 - study.sampling().confidence) / pairs;
  for (const Metric metric : study.compare().metrics) values_[metric].reserve(rows.size());
  values_[study.compare().metric].reserve(rows.size());
  outcomes_.reserve(rows.size());
  for (const ScenarioRow& row : rows) {
    const std::size_t candidate = outcomes_.size() % n;
    outcomes_.push_back(row.result.outcome);
    for (auto& [metric, values] : values_) values.push_back(row.result.metrics[metric]);
    held_[candidate].add(row.result, study.candidates()[candidate].scenario.limits);
  }
}

std::size_t CandidateComparison::place(std::size_t product, std::size_t candidate) const {
  return product * study_.candidates().size() + candidate;
}

Outcome CandidateComparison::outcome(std::size_t product, std::size_t candidate) const {
  return outcomes_[place(product, candidate)];
}

bool CandidateComparison::is_held(std::size_t product, std::size_t candidate) const {
  return outcome(product, candidate) == Outcome::held;
}

double CandidateComparison::value(std::size_t product, std::size_t candidate, Metric metric) const {
  return values_.at(metric)[place(product, candidate)];
}

Proportion CandidateComparison::held_proportion(std::size_t candidate) const {
  return held_[candidate].proportion(products_, study_.sampling().confidence);
}

const std::string& CandidateComparison::name(std::size_t candidate) const {
  return study_.candidates()[candidate].name;
}

PairedComparison CandidateComparison::compare(std::size_t a, std::size_t b, Metric metric) const {
  PairedComparison pair;
  std::vector<double> held, differences;
  std::vector<std::size_t> groups, replicates;
  double sum_a = 0.0;
  const double tie = metric == study_.compare().metric ? study_.compare().tie : 0.0;
  for (std::size_t p = 0; p < products_.size(); ++p) {
    const bool held_a = is_held(p, a);
    const bool held_b = is_held(p, b);
    pair.held_a += held_a ? 1 : 0;
    pair.held_b += held_b ? 1 : 0;
    held.push_back((held_b ? 1.0 : 0.0) - (held_a ? 1.0 : 0.0));
    const double value_a = value(p, a, metric);
    const double difference = value(p, b, metric) - value_a;
    const bool both = held_a && held_b && !std::isnan(difference);
    if (both) {
      differences.push_back(difference);
      groups.push_back(products_.group[p]);
      if (!products_.replicate.empty()) replicates.push_back(products_.replicate[p]);
      sum_a += value_a;
    }
    if (held_a != held_b) {
      ++(held_a ? pair.wins : pair.losses);
    } else if (!both || std::abs(difference) <= tie) {
      ++pair.ties;
    } else {
      ++((difference > 0.0) != more_is_better(metric) ? pair.wins : pair.losses);
    }
  }
  pair.held = sampled_mean(held, products_.structure(), confidence_);
  pair.difference = differences.empty() ? MeanInterval{kAbsent, {kAbsent, kAbsent}, 0}
                                        : sampled_mean(differences, {groups, replicates}, confidence_);
  const double mean_a = sum_a / static_cast<double>(differences.size());
  pair.relative = differences.empty() || mean_a == 0.0 ? kAbsent : pair.difference.mean / std::abs(mean_a);
  return pair;
}

Winner CandidateComparison::winner(const PairedComparison& pair, Metric metric) const {
  if (const int held = sign_of(pair.held); held != 0) return winner_of(held);
  const Winner better = winner_of((more_is_better(metric) ? 1 : -1) * sign_of(pair.difference));
  const bool other_holds_more =
      (better == Winner::a && pair.held_b > pair.held_a) || (better == Winner::b && pair.held_a > pair.held_b);
  return other_holds_more ? Winner::none : better;
}

std::string CandidateComparison::confidence_text() const {
  return joined({percent(study_.sampling().confidence), " interval"});
}

std::string CandidateComparison::count_text(std::size_t held) const {
  return joined({with_thousands(held), " of ", with_thousands(products_.size())});
}

std::string CandidateComparison::holding_text(std::size_t a, std::size_t b, const PairedComparison& pair) const {
  const std::string counts =
      joined({name(a), " ", count_text(pair.held_a), ", ", name(b), " ", count_text(pair.held_b)});
  const int held = sign_of(pair.held);
  if (held == 0) {
    if (pair.held_a == 0 && pair.held_b == 0) return joined({"neither is ", held_words_, " on any product"});
    if (pair.held.mean == 0.0) return joined({held_words_, " equally often (", counts, ")"});
    return joined({held_words_, ": no difference shown (", counts, "; ", confidence_text(), " of the difference ",
                   percent(pair.held.interval.low), " to ", percent(pair.held.interval.high), ")"});
  }
  const Interval sizes = sizes_of(pair.held.interval);
  return joined({name(held > 0 ? b : a), " is ", held_words_, " more often than ", name(held > 0 ? a : b), ": ",
                 counts, "; on ", percent(std::abs(pair.held.mean)), " more of the products (", confidence_text(),
                 " ", percent(sizes.low), " to ", percent(sizes.high), ")"});
}

std::string CandidateComparison::metric_text(std::size_t a, std::size_t b, Metric metric,
                                             const PairedComparison& pair) const {
  const std::string metric_name(info_of(metric).name);
  if (pair.difference.count == 0)
    return joined({"no product tells about ", metric_name, ": none is held by both"});
  if (sign_of(pair.difference) == 0) return joined({"no difference shown in ", metric_name});
  const bool more = more_is_better(metric);
  const bool b_better = (pair.difference.mean > 0.0) == more;
  const Interval sizes = sizes_of(pair.difference.interval);
  const std::string relative =
      std::isnan(pair.relative) ? std::string() : joined({" or ", percent(std::abs(pair.relative))});
  const std::string low = short_number(sizes.low);
  const std::string high = short_number(sizes.high);
  const std::string unit = unit_text(metric);
  const std::string spread = low == high ? std::string("the same on each of the ")
                                         : joined({confidence_text(), " ", low, " to ", high, unit, ", on the "});
  return joined({name(b_better ? b : a), more ? " has more " : " needs less ", metric_name, " than ",
                 name(b_better ? a : b), ": by ", short_number(std::abs(pair.difference.mean)), unit, relative,
                 " (", spread, with_thousands(pair.difference.count), " products that both hold)"});
}

std::string CandidateComparison::verdict(std::size_t a, std::size_t b, Metric metric,
                                         const PairedComparison& pair) const {
  const int held = sign_of(pair.held);
  const int better = (more_is_better(metric) ? 1 : -1) * sign_of(pair.difference);
  if (held == 0 && better == 0 && pair.held.mean == 0.0 && pair.held_a > 0) {
    return joined({name(a), " and ", name(b), ": no difference shown"});
  }
  const bool contradicts = held != 0 && better != 0 && held != better;
  return joined({holding_text(a, b, pair), contradicts ? "; but " : "; ", metric_text(a, b, metric, pair)});
}

std::size_t CandidateComparison::overall_winner() const {
  const std::size_t n = study_.candidates().size();
  const Metric metric = study_.compare().metric;
  for (std::size_t c = 0; c < n; ++c) {
    bool beats_all = true;
    for (std::size_t other = 0; other < n && beats_all; ++other) {
      beats_all = other == c || winner(compare(c, other, metric), metric) == Winner::a;
    }
    if (beats_all) return c;
  }
  return n;
}

std::string CandidateComparison::headline() const {
  const std::size_t best = overall_winner();
  if (best == study_.candidates().size()) {
    return joined({"no winner: no strategy is shown to be better than ", best == 2 ? "the other" : "all others",
                   ", holding first, then ", info_of(study_.compare().metric).name});
  }
  return joined({"winner: ", name(best), ", ", held_words_, " on ", count_text(held_count(best)), " products (",
                 others_text(best), "); ", reason_text(best)});
}

std::size_t CandidateComparison::held_count(std::size_t candidate) const {
  std::size_t held = 0;
  for (std::size_t p = 0; p < products_.size(); ++p) held += is_held(p, candidate) ? 1 : 0;
  return held;
}

std::string CandidateComparison::others_text(std::size_t candidate) const {
  std::vector<std::string> others;
  for (std::size_t other = 0; other < study_.candidates().size(); ++other) {
    if (other != candidate) others.push_back(joined({name(other), " on ", with_thousands(held_count(other))}));
  }
  return comma_list(others);
}

std::string CandidateComparison::reason_text(std::size_t winner) const {
  const Metric metric = study_.compare().metric;
  bool by_holding = true;
  for (std::size_t other = 0; other < study_.candidates().size(); ++other) {
    if (other != winner && sign_of(compare(winner, other, metric).held) == 0) by_holding = false;
  }
  if (by_holding) return "holding more often is shown";
  return joined({more_is_better(metric) ? "more " : "less ", info_of(metric).name, " decides"});
}

}  // namespace unbruised::studies
