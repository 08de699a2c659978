#include "studies/statistics/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "studies/statistics/design.hpp"
#include "studies/statistics/scores.hpp"

namespace unbruised::studies {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// p n this close above a whole number is that number, but for the rounding of p.
constexpr double kRankRounding = 1e-9;

struct Cluster {
  double sum = 0.0;
  double size = 0.0;
  [[nodiscard]] double mean() const { return sum / size; }
};

/// In the order of their numbers, whatever the order of the values.
std::vector<Cluster> clusters_of(std::span<const double> values, std::span<const std::size_t> cluster) {
  if (cluster.size() != values.size()) throw std::invalid_argument("statistics: one cluster per value");
  std::map<std::size_t, Cluster> by_number;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Cluster& own = by_number[cluster[i]];
    own.sum += values[i];
    own.size += 1.0;
  }
  std::vector<Cluster> clusters;
  for (const auto& [number, own] : by_number) clusters.push_back(own);
  return clusters;
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// m = sum m_i^2 / n: the size of the cluster that a value is in, on average.
double mean_size_of(const std::vector<Cluster>& clusters) {
  double n = 0.0;
  double squares = 0.0;
  for (const Cluster& own : clusters) {
    n += own.size;
    squares += own.size * own.size;
  }
  return squares / n;
}

/// Correlation of two values of one cluster, from the one-way analysis of variance; 0 where nothing varies.
double intraclass_correlation(std::span<const double> values, const std::vector<Cluster>& clusters) {
  const auto n = static_cast<double>(values.size());
  const auto g = static_cast<double>(clusters.size());
  const double mean = mean_of(values);
  double total = 0.0;
  for (const double value : values) total += (value - mean) * (value - mean);
  double between = 0.0;
  for (const Cluster& own : clusters) between += own.size * (own.mean() - mean) * (own.mean() - mean);
  const double B = between / (g - 1.0);
  const double W = std::max(0.0, total - between) / (n - g);
  const double m_0 = (n - mean_size_of(clusters)) / (g - 1.0);
  const double denominator = B + (m_0 - 1.0) * W;
  return denominator > 0.0 ? (B - W) / denominator : 0.0;
}

/// Two clusters at least, and one of them with two values.
bool is_clustered(std::span<const double> values, const std::vector<Cluster>& clusters) {
  return clusters.size() >= 2 && clusters.size() < values.size();
}

double effective_size_of(std::span<const double> values, const std::vector<Cluster>& clusters) {
  const auto n = static_cast<double>(values.size());
  if (!is_clustered(values, clusters)) return n;
  const double icc = std::clamp(intraclass_correlation(values, clusters), 0.0, 1.0);
  return n / (1.0 + (mean_size_of(clusters) - 1.0) * icc);
}

bool all_alike(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
}

/// The effective size that a proportion may claim; intervals.hpp says why.
double claimed_size(std::span<const double> values, std::span<const double> measure,
                    std::span<const std::size_t> cluster, double confidence) {
  const auto n = static_cast<double>(values.size());
  const std::vector<Cluster> clusters = clusters_of(values, cluster);
  if (!is_clustered(values, clusters)) return n;
  const double least = n / mean_size_of(clusters);
  const bool tells = !measure.empty() && !all_alike(measure);
  if (all_alike(values) && !tells) return least;
  double size = n;
  if (!all_alike(values)) size = effective_size_of(values, clusters);
  if (tells) size = std::min(size, effective_size_of(measure, clusters_of(measure, cluster)));
  const auto g = static_cast<double>(clusters.size());
  const double t_ratio = student_score(n - 1.0, confidence) / student_score(g - 1.0, confidence);
  return std::max(least, size * t_ratio * t_ratio);
}

}  // namespace

Interval wilson_interval(double successes, double trials, double confidence) {
  if (!(trials > 0.0)) return {0.0, 1.0};
  const double z = normal_score(confidence);
  const double p = successes / trials;
  const double z2_n = z * z / trials;
  const double center = (p + 0.5 * z2_n) / (1.0 + z2_n);
  const double half = std::sqrt(z2_n * (p * (1.0 - p) + 0.25 * z2_n)) / (1.0 + z2_n);
  return {p <= 0.0 ? 0.0 : std::max(0.0, center - half), p >= 1.0 ? 1.0 : std::min(1.0, center + half)};
}

std::size_t trials_to_show(double probability, double confidence) {
  if (!(probability < 1.0)) return std::numeric_limits<std::size_t>::max();
  const double z = normal_score(confidence);
  const double least = z * z * std::max(0.0, probability) / (1.0 - probability);
  if (least >= 1e18) return std::numeric_limits<std::size_t>::max();
  return static_cast<std::size_t>(std::floor(least)) + 1;
}

double effective_size(std::span<const double> values, std::span<const std::size_t> cluster) {
  if (cluster.empty()) return static_cast<double>(values.size());
  return effective_size_of(values, clusters_of(values, cluster));
}

Proportion proportion(const std::vector<bool>& successes, std::span<const std::size_t> cluster, double confidence,
                      std::span<const double> measure) {
  if (successes.empty()) return {kNaN, {0.0, 1.0}, 0.0};
  const std::vector<double> values(successes.begin(), successes.end());
  Proportion out;
  out.estimate = mean_of(values);
  out.count = values.size();
  out.effective_size =
      cluster.empty() ? static_cast<double>(values.size()) : claimed_size(values, measure, cluster, confidence);
  out.interval = wilson_interval(out.estimate * out.effective_size, out.effective_size, confidence);
  return out;
}

MeanInterval mean_interval(std::span<const double> values, std::span<const std::size_t> cluster,
                           double confidence) {
  if (values.empty()) return {kNaN, {-kInfinity, kInfinity}, 0};
  const auto n = static_cast<double>(values.size());
  std::vector<Cluster> observations;
  if (!cluster.empty()) observations = clusters_of(values, cluster);
  if (observations.size() < 2) {
    observations.clear();
    for (const double value : values) observations.push_back({value, 1.0});
  }
  MeanInterval out{mean_of(values), {-kInfinity, kInfinity}, values.size()};
  if (observations.size() < 2) return out;
  const auto g = static_cast<double>(observations.size());
  double squares = 0.0;
  for (const Cluster& own : observations) {
    const double off = own.size / n * (own.mean() - out.mean);
    squares += off * off;
  }
  const double half = student_score(g - 1.0, confidence) * std::sqrt(g / (g - 1.0) * squares);
  out.interval = {out.mean - half, out.mean + half};
  return out;
}

std::vector<std::size_t> bootstrap_rows(std::size_t count, std::uint64_t seed, std::uint64_t replicate) {
  std::vector<std::size_t> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i] = random_index(seed, replicate, i, count);
  return rows;
}

Interval percentile_interval(std::vector<double> replicates, double confidence) {
  const bool has_nan = std::any_of(replicates.begin(), replicates.end(), [](double v) { return std::isnan(v); });
  if (replicates.empty() || has_nan) return {kNaN, kNaN};
  std::sort(replicates.begin(), replicates.end());
  const double part = 0.5 * (1.0 - confidence) * static_cast<double>(replicates.size());
  const auto k = static_cast<std::size_t>(std::max(1.0, std::floor(part + kRankRounding)));
  return {replicates[k - 1], replicates[replicates.size() - k]};
}

Interval bootstrap_interval(std::size_t count, std::size_t replicates, std::uint64_t seed, double confidence,
                            const std::function<double(std::span<const std::size_t>)>& statistic) {
  std::vector<double> values;
  values.reserve(replicates);
  for (std::size_t b = 0; b < replicates; ++b) values.push_back(statistic(bootstrap_rows(count, seed, b)));
  return percentile_interval(std::move(values), confidence);
}

double sample_quantile(std::vector<double> values, double p) {
  const bool has_nan = std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
  if (values.empty() || has_nan) return kNaN;
  const auto n = static_cast<double>(values.size());
  const double k = std::clamp(std::ceil(p * n - kRankRounding), 1.0, n);
  const auto kth = values.begin() + static_cast<std::ptrdiff_t>(k) - 1;
  std::nth_element(values.begin(), kth, values.end());
  return *kth;
}

}  // namespace unbruised::studies
