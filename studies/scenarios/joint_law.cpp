#include "studies/scenarios/joint_law.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include "studies/statistics/correlation.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/statistics/scores.hpp"

namespace unbruised::studies {
namespace {

/// Largest number below one: the part of a normal distribution that no double tells from all of it.
constexpr double kAlmostOne = 1.0 - std::numeric_limits<double>::epsilon() / 2.0;
constexpr double kAlmostZero = std::numeric_limits<double>::min();

}  // namespace

JointLaw::JointLaw(const Study& study) : randoms_(study.randoms()), sources_(randoms_.size()) {
  place_numbers();
  place_copula(study.correlations());
}

void JointLaw::place_numbers() {
  for (std::size_t k = 0; k < randoms_.size(); ++k) {
    const auto in_row = [&](const RandomVariable& other) {
      return !other.zip.empty() && other.zip == randoms_[k].zip;
    };
    const auto first =
        static_cast<std::size_t>(std::find_if(randoms_.begin(), randoms_.end(), in_row) - randoms_.begin());
    if (first < k) {
      sources_[k] = sources_[first];
      continue;
    }
    const bool is_shared = randoms_[k].changes_factor ||
                           std::any_of(randoms_.begin(), randoms_.end(), [&](const RandomVariable& other) {
                             return in_row(other) && other.changes_factor;
                           });
    sources_[k] = {is_shared, is_shared ? shared_numbers_++ : own_numbers_++};
  }
}

void JointLaw::place_copula(const std::vector<RankCorrelation>& correlations) {
  std::set<std::size_t> keys;
  for (const RankCorrelation& c : correlations) keys.insert({c.first, c.second});
  std::vector<std::size_t> order(keys.begin(), keys.end());
  std::stable_partition(order.begin(), order.end(), [&](std::size_t k) { return sources_[k].is_shared; });
  CorrelationMatrix ranks(order.size());
  const auto row = [&](std::size_t key) {
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), key) - order.begin());
  };
  for (const RankCorrelation& c : correlations) ranks.set(row(c.first), row(c.second), c.value);
  const std::vector<double> L = cholesky(normal_correlations(ranks));
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto begin = L.begin() + static_cast<std::ptrdiff_t>(i * order.size());
    copula_.push_back({order[i], {begin, begin + static_cast<std::ptrdiff_t>(i) + 1}});
  }
}

std::vector<double> JointLaw::draw(const Number& shared, const Number& own) const {
  std::vector<double> numbers;
  for (const Source& source : sources_) {
    numbers.push_back(source.is_shared ? shared(source.place) : own(source.place));
  }
  std::vector<double> z;
  for (const CopulaRow& row : copula_) z.push_back(normal_quantile(numbers[row.key]));
  for (std::size_t i = 1; i < copula_.size(); ++i) {  // the first row of L is (1, 0, ...)
    double y = 0.0;
    for (std::size_t j = 0; j <= i; ++j) y += copula_[i].weights[j] * z[j];
    numbers[copula_[i].key] = std::clamp(normal_part(y), kAlmostZero, kAlmostOne);
  }
  std::vector<double> values;
  for (std::size_t k = 0; k < randoms_.size(); ++k) {
    const RandomVariable& random = randoms_[k];
    values.push_back(random.zip.empty() ? quantile(random.distribution, numbers[k])
                                        : random.rows[row_of_number(numbers[k], random.rows.size())]);
  }
  return values;
}

}  // namespace unbruised::studies
