#include "studies/statistics/distribution.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>

#include "studies/statistics/boost_policy.hpp"

namespace unbruised::studies {
namespace {

namespace bm = boost::math;

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::min();
/// Least probability that truncation may leave: below it the ends of the truncated part have no digits in common.
constexpr double kLeastPart = 1e-12;
/// Widest lognormal: beyond, values run over more decades than any property has.
constexpr double kWidestLognormal = 1e6;

bool has_moments(const Distribution& d) {
  return d.kind == DistributionKind::normal || d.kind == DistributionKind::lognormal;
}

bool is_data(const Distribution& d) { return d.kind == DistributionKind::data; }

bool is_point(const Distribution& d) { return has_moments(d) && d.standard_deviation == 0.0; }

/// Mean and standard deviation of the logarithm: s^2 = log(1 + (sd / mean)^2), m = log(mean) - s^2 / 2.
struct Logarithm {
  double mean = 0.0;
  double standard_deviation = 0.0;
};
Logarithm logarithm_of(const Distribution& d) {
  const double ratio = d.standard_deviation / d.mean;
  // log(1 + r^2) = r^2 to all digits where r^2 could underflow.
  const double s = ratio < 1e-9 ? ratio : std::sqrt(std::log1p(ratio * ratio));
  return {std::log(d.mean) - 0.5 * s * s, s};
}

/// Calls `use` with the distribution before it is truncated. Points are handled before.
template <class Use>
double with_whole(const Distribution& d, Use use) {
  switch (d.kind) {
    case DistributionKind::uniform:
      return use(bm::uniform_distribution<double, QuietPolicy>(d.from, d.to));
    case DistributionKind::triangular:
      return use(bm::triangular_distribution<double, QuietPolicy>(d.from, d.mode, d.to));
    case DistributionKind::normal:
      return use(bm::normal_distribution<double, QuietPolicy>(d.mean, d.standard_deviation));
    case DistributionKind::lognormal: {
      const Logarithm logarithm = logarithm_of(d);
      return use(bm::lognormal_distribution<double, QuietPolicy>(logarithm.mean, logarithm.standard_deviation));
    }
    case DistributionKind::data:
      break;  // has a quantile function of its own
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Where the whole distribution begins and ends, as finite numbers.
double support_low(const Distribution& d) {
  if (d.kind == DistributionKind::normal) return -kLargest;
  return d.kind == DistributionKind::lognormal ? 0.0 : d.from;
}
double support_high(const Distribution& d) { return has_moments(d) ? kLargest : d.to; }

/// F(x) and 1 - F(x), each with all its digits where it is small.
double below(const Distribution& d, double x) {
  if (x <= support_low(d)) return 0.0;
  if (x >= support_high(d)) return 1.0;
  return with_whole(d, [x](const auto& whole) { return bm::cdf(whole, x); });
}
double above(const Distribution& d, double x) {
  if (x <= support_low(d)) return 1.0;
  if (x >= support_high(d)) return 0.0;
  return with_whole(d, [x](const auto& whole) { return bm::cdf(bm::complement(whole, x)); });
}

/// Where quantiles go over from F to 1 - F.
double center(const Distribution& d) {
  switch (d.kind) {
    case DistributionKind::uniform:
      return std::midpoint(d.from, d.to);
    case DistributionKind::triangular:
      return d.mode;
    case DistributionKind::normal:
      return d.mean;
    case DistributionKind::lognormal:
      return std::exp(logarithm_of(d).mean);
    case DistributionKind::data:
      break;
  }
  return 0.0;
}

/// F(high) - F(low) of the whole distribution, from the side where the two are small.
double part_between(const Distribution& d, double low, double high) {
  return low >= center(d) ? above(d, low) - above(d, high) : below(d, high) - below(d, low);
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

std::string kind_text(const Distribution& d) {
  const std::string moments = "(mean " + number_text(d.mean) + ", sd " + number_text(d.standard_deviation) + ")";
  const std::string range = number_text(d.from) + " to " + number_text(d.to);
  switch (d.kind) {
    case DistributionKind::uniform:
      return "uniform(" + range + ")";
    case DistributionKind::triangular:
      return "triangular(" + range + ", mode " + number_text(d.mode) + ")";
    case DistributionKind::normal:
      return "normal" + moments;
    case DistributionKind::lognormal:
      return "lognormal" + moments;
    case DistributionKind::data:
      return "data(" + std::to_string(d.values.size()) + " values, " + number_text(d.values.front()) + " to " +
             number_text(d.values.back()) + ")";
  }
  return {};
}

std::string truncation_text(const Distribution& d) {
  const bool low = std::isfinite(d.at_least);
  const bool high = std::isfinite(d.at_most);
  if (low && high) return ", " + number_text(d.at_least) + " to " + number_text(d.at_most);
  if (low) return ", at least " + number_text(d.at_least);
  return high ? ", at most " + number_text(d.at_most) : "";
}

const char* broken_rule_of_moments(const Distribution& d) {
  if (!std::isfinite(d.mean)) return "mean must be finite";
  if (!(d.standard_deviation >= 0.0)) return "standard_deviation must be >= 0";
  if (!std::isfinite(d.standard_deviation)) return "standard_deviation must be finite";
  if (d.kind != DistributionKind::lognormal) return nullptr;
  if (!(d.mean > 0.0)) return "mean of a lognormal must be > 0";
  const bool narrow = d.standard_deviation / kWidestLognormal <= d.mean;
  return narrow ? nullptr : "standard_deviation of a lognormal must be at most 1e6 times its mean";
}

const char* broken_rule_of_range(const Distribution& d) {
  if (!(d.from < d.to)) return "from must be < to";
  if (!std::isfinite(d.to - d.from)) return "from and to must be finite";
  const bool mode_inside = d.from <= d.mode && d.mode <= d.to;
  return d.kind == DistributionKind::triangular && !mode_inside ? "mode must lie between from and to" : nullptr;
}

const char* broken_rule_of_truncation(const Distribution& d) {
  if (!(d.at_least < d.at_most)) return "at_least must be < at_most";
  const bool something = is_point(d) ? d.at_least <= d.mean && d.mean <= d.at_most
                                     : part_between(d, d.at_least, d.at_most) > kLeastPart;
  return something ? nullptr : "nothing lies between at_least and at_most";
}

}  // namespace

std::optional<std::string> broken_rule(const Distribution& d) {
  if (is_data(d)) {
    const bool sound = !d.values.empty() && std::all_of(d.values.begin(), d.values.end(),
                                                        [](double value) { return std::isfinite(value); });
    return sound ? std::nullopt : std::optional<std::string>("data must be finite numbers");
  }
  const char* broken = has_moments(d) ? broken_rule_of_moments(d) : broken_rule_of_range(d);
  if (broken == nullptr) broken = broken_rule_of_truncation(d);
  return broken == nullptr ? std::nullopt : std::optional<std::string>(broken);
}

std::size_t row_of_number(double u, std::size_t rows) {
  return std::min(rows - 1, static_cast<std::size_t>(u * static_cast<double>(rows)));
}

double quantile(const Distribution& d, double u) {
  if (is_data(d)) return d.values[row_of_number(u, d.values.size())];
  if (is_point(d)) return d.mean;
  const double low = std::max(d.at_least, support_low(d));
  const double high = std::min(d.at_most, support_high(d));
  const double middle = center(d);
  const double low_below = below(d, low);
  const double p = low_below + u * (below(d, high) - low_below);
  // Both sides stop at the middle, so that rounding does not break the order there.
  double value = 0.0;
  if (p <= below(d, middle)) {
    const double part = std::max(p, kSmallest);
    value = std::min(middle, with_whole(d, [=](const auto& whole) { return bm::quantile(whole, part); }));
  } else {
    const double high_above = above(d, high);
    const double part = std::max(high_above + (1.0 - u) * (above(d, low) - high_above), kSmallest);
    value = std::max(middle,
                     with_whole(d, [=](const auto& whole) { return bm::quantile(bm::complement(whole, part)); }));
  }
  return std::clamp(value, low, high);
}

double cumulative(const Distribution& d, double value) {
  if (is_data(d)) {
    const auto not_above = std::upper_bound(d.values.begin(), d.values.end(), value) - d.values.begin();
    return static_cast<double>(not_above) / static_cast<double>(d.values.size());
  }
  if (is_point(d)) return value >= d.mean ? 1.0 : 0.0;
  if (value <= d.at_least) return 0.0;
  if (value >= d.at_most) return 1.0;
  return std::clamp(part_between(d, d.at_least, value) / part_between(d, d.at_least, d.at_most), 0.0, 1.0);
}

std::string distribution_text(const Distribution& d) { return kind_text(d) + truncation_text(d); }

MeanAndSpread mean_and_spread(std::span<const double> values) {
  if (values.empty()) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? 0.0 : std::sqrt(squares / (n - 1.0))};
}

}  // namespace unbruised::studies
