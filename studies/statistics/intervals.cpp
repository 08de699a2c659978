#include "studies/statistics/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "studies/statistics/design.hpp"

namespace unbruised::studies {
namespace {

namespace bm = boost::math;
using Policy = bm::policies::policy<bm::policies::promote_double<false>>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double normal_score(double confidence) {
  return bm::quantile(bm::normal_distribution<double, Policy>(0.0, 1.0), 0.5 + 0.5 * confidence);
}

struct Cluster {
  double sum = 0.0;
  std::size_t count = 0;
};

std::map<std::size_t, Cluster> clusters_of(std::span<const double> values, std::span<const std::size_t> cluster) {
  std::map<std::size_t, Cluster> clusters;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Cluster& own = clusters[cluster[i]];
    own.sum += values[i];
    ++own.count;
  }
  return clusters;
}

/// Student's interval of the mean of equally weighted observations.
MeanInterval student_interval(std::span<const double> values, double confidence) {
  MeanInterval out;
  out.count = values.size();
  const auto n = static_cast<double>(values.size());
  out.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() < 2) {
    out.interval = {-kInfinity, kInfinity};
    return out;
  }
  double squares = 0.0;
  for (const double value : values) squares += (value - out.mean) * (value - out.mean);
  const double error = std::sqrt(squares / (n - 1.0) / n);
  const double t = bm::quantile(bm::students_t_distribution<double, Policy>(n - 1.0), 0.5 + 0.5 * confidence);
  out.interval = {out.mean - t * error, out.mean + t * error};
  return out;
}

}  // namespace

Interval wilson_interval(double successes, double trials, double confidence) {
  const double z = normal_score(confidence);
  const double p = successes / trials;
  const double center = (p + z * z / (2.0 * trials)) / (1.0 + z * z / trials);
  const double half =
      z / (1.0 + z * z / trials) * std::sqrt(p * (1.0 - p) / trials + z * z / (4.0 * trials * trials));
  return {p <= 0.0 ? 0.0 : std::max(0.0, center - half), p >= 1.0 ? 1.0 : std::min(1.0, center + half)};
}

std::size_t trials_to_show(double probability, double confidence) {
  // All successes: the lower end is n / (n + z^2).
  const double z = normal_score(confidence);
  return static_cast<std::size_t>(std::ceil(z * z * probability / (1.0 - probability)));
}

double effective_size(std::span<const double> values, std::span<const std::size_t> cluster) {
  const auto n = static_cast<double>(values.size());
  const auto clusters = clusters_of(values, cluster);
  const auto g = static_cast<double>(clusters.size());
  if (clusters.size() < 2 || clusters.size() >= values.size()) return n;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double between = 0.0;
  double sizes_squared = 0.0;
  for (const auto& [key, own] : clusters) {
    const auto size = static_cast<double>(own.count);
    const double off = own.sum / size - mean;
    between += size * off * off;
    sizes_squared += size * size;
  }
  double total = 0.0;
  for (const double value : values) total += (value - mean) * (value - mean);
  if (!(total > 0.0)) return n;
  const double mean_between = between / (g - 1.0);
  const double mean_within = std::max(0.0, total - between) / (n - g);
  const double size = (n - sizes_squared / n) / (g - 1.0);
  const double icc = (mean_between - mean_within) / (mean_between + (size - 1.0) * mean_within);
  const double effect = 1.0 + (n / g - 1.0) * std::clamp(icc, 0.0, 1.0);
  return n / effect;
}

Proportion proportion(const std::vector<bool>& successes, std::span<const std::size_t> cluster, double confidence) {
  std::vector<double> values(successes.begin(), successes.end());
  Proportion out;
  const auto n = static_cast<double>(values.size());
  out.estimate = std::accumulate(values.begin(), values.end(), 0.0) / n;
  out.effective_size = cluster.empty() ? n : effective_size(values, cluster);
  out.interval = wilson_interval(out.estimate * out.effective_size, out.effective_size, confidence);
  return out;
}

MeanInterval mean_interval(std::span<const double> values, std::span<const std::size_t> cluster, double confidence) {
  if (values.empty()) return {std::numeric_limits<double>::quiet_NaN(), {-kInfinity, kInfinity}, 0};
  if (cluster.empty()) return student_interval(values, confidence);
  std::vector<double> means;
  for (const auto& [key, own] : clusters_of(values, cluster)) means.push_back(own.sum / static_cast<double>(own.count));
  if (means.size() < 2) return student_interval(values, confidence);
  MeanInterval out = student_interval(means, confidence);
  out.count = values.size();
  return out;
}

Interval bootstrap_interval(std::size_t count, std::size_t replicates, std::uint64_t seed, double confidence,
                            const std::function<double(std::span<const std::size_t>)>& statistic) {
  std::vector<double> values;
  std::vector<std::size_t> drawn(count);
  for (std::size_t b = 0; b < replicates; ++b) {
    for (std::size_t i = 0; i < count; ++i) {
      drawn[i] = static_cast<std::size_t>(unit_random(seed, b, i) * static_cast<double>(count));
    }
    values.push_back(statistic(drawn));
  }
  return {sample_quantile(values, 0.5 - 0.5 * confidence), sample_quantile(values, 0.5 + 0.5 * confidence)};
}

double sample_quantile(std::vector<double> values, double p) {
  if (values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto n = static_cast<double>(values.size());
  // A part that is a whole number but for rounding is that number.
  const double k = std::clamp(std::ceil(p * n - 1e-9), 1.0, n);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(k) - 1;
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace unbruised::studies
