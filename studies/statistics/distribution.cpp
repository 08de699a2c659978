#include "studies/statistics/distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>

namespace unbruised::studies {
namespace {

namespace bm = boost::math;

/// Plain doubles, and no exceptions: arguments are kept inside their ranges here.
using Policy = bm::policies::policy<bm::policies::promote_double<false>,
                                    bm::policies::domain_error<bm::policies::ignore_error>,
                                    bm::policies::pole_error<bm::policies::ignore_error>,
                                    bm::policies::overflow_error<bm::policies::ignore_error>,
                                    bm::policies::evaluation_error<bm::policies::ignore_error>>;

/// Calls `use` with the distribution before it is truncated; a spread of zero is handled before.
template <class Use>
double with_whole(const Distribution& d, Use use) {
  switch (d.kind) {
    case DistributionKind::uniform:
      return use(bm::uniform_distribution<double, Policy>(d.from, d.to));
    case DistributionKind::triangular:
      return use(bm::triangular_distribution<double, Policy>(d.from, d.mode, d.to));
    case DistributionKind::normal:
      return use(bm::normal_distribution<double, Policy>(d.mean, d.standard_deviation));
    case DistributionKind::lognormal: {
      const double ratio = d.standard_deviation / d.mean;
      const double variance = std::log1p(ratio * ratio);
      return use(bm::lognormal_distribution<double, Policy>(std::log(d.mean) - 0.5 * variance, std::sqrt(variance)));
    }
  }
  return 0.0;
}

bool by_moments(const Distribution& d) {
  return d.kind == DistributionKind::normal || d.kind == DistributionKind::lognormal;
}

bool is_point(const Distribution& d) { return by_moments(d) && d.standard_deviation == 0.0; }

/// Where the whole distribution begins and ends.
double support_low(const Distribution& d) {
  if (d.kind == DistributionKind::normal) return -std::numeric_limits<double>::infinity();
  return d.kind == DistributionKind::lognormal ? 0.0 : d.from;
}
double support_high(const Distribution& d) {
  return by_moments(d) ? std::numeric_limits<double>::infinity() : d.to;
}

/// F(x) and 1 - F(x), each accurate where it is small.
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

/// The truncated part lies in the upper half: work with complements there.
bool is_upper(const Distribution& d) { return below(d, d.at_least) > 0.5; }

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

std::optional<std::string> broken_rule(const Distribution& d) {
  if (by_moments(d)) {
    if (!std::isfinite(d.mean)) return "mean must be finite";
    if (!(d.standard_deviation >= 0.0) || !std::isfinite(d.standard_deviation)) {
      return "standard_deviation must be >= 0";
    }
    if (d.kind == DistributionKind::lognormal && !(d.mean > 0.0)) return "mean of a lognormal must be > 0";
  } else {
    if (!(d.from < d.to)) return "from must be < to";
    if (d.kind == DistributionKind::triangular && !(d.from <= d.mode && d.mode <= d.to)) {
      return "mode must lie between from and to";
    }
  }
  if (!(d.at_least < d.at_most)) return "at_least must be < at_most";
  if (is_point(d)) {
    const bool inside = d.at_least <= d.mean && d.mean <= d.at_most;
    return inside ? std::nullopt : std::optional<std::string>("nothing lies between at_least and at_most");
  }
  const double left = is_upper(d) ? above(d, d.at_least) - above(d, d.at_most)
                                  : below(d, d.at_most) - below(d, d.at_least);
  if (!(left > 1e-12)) return "nothing lies between at_least and at_most";
  return std::nullopt;
}

double quantile(const Distribution& d, double u) {
  if (is_point(d)) return d.mean;
  const double low = std::max(d.at_least, support_low(d));
  const double high = std::min(d.at_most, support_high(d));
  double value = 0.0;
  if (is_upper(d)) {
    const double q = above(d, d.at_least) + u * (above(d, d.at_most) - above(d, d.at_least));
    value = q <= 0.0 ? high : with_whole(d, [q](const auto& whole) { return bm::quantile(bm::complement(whole, q)); });
  } else {
    const double p = below(d, d.at_least) + u * (below(d, d.at_most) - below(d, d.at_least));
    value = p <= 0.0   ? low
            : p >= 1.0 ? high
                       : with_whole(d, [p](const auto& whole) { return bm::quantile(whole, p); });
  }
  return std::clamp(value, low, high);
}

double cumulative(const Distribution& d, double value) {
  if (is_point(d)) return value >= d.mean ? 1.0 : 0.0;
  if (value <= d.at_least) return 0.0;
  if (value >= d.at_most) return 1.0;
  if (is_upper(d)) {
    const double all = above(d, d.at_least) - above(d, d.at_most);
    return (above(d, d.at_least) - above(d, value)) / all;
  }
  return (below(d, value) - below(d, d.at_least)) / (below(d, d.at_most) - below(d, d.at_least));
}

std::string distribution_text(const Distribution& d) {
  std::string text;
  switch (d.kind) {
    case DistributionKind::uniform:
      text = "uniform(" + number(d.from) + " to " + number(d.to) + ")";
      break;
    case DistributionKind::triangular:
      text = "triangular(" + number(d.from) + ", " + number(d.mode) + ", " + number(d.to) + ")";
      break;
    case DistributionKind::normal:
    case DistributionKind::lognormal:
      text = std::string(d.kind == DistributionKind::normal ? "normal" : "lognormal") + "(mean " + number(d.mean) +
             ", sd " + number(d.standard_deviation) + ")";
      break;
  }
  if (std::isfinite(d.at_least)) text += ", >= " + number(d.at_least);
  if (std::isfinite(d.at_most)) text += ", <= " + number(d.at_most);
  return text;
}

MeanAndSpread mean_and_spread(std::span<const double> values) {
  double mean = 0.0;
  for (const double value : values) mean += value;
  mean /= static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? 0.0 : std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

}  // namespace unbruised::studies
