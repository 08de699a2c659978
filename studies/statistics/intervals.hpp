#pragma once

/// @file
/// How sure a number is: confidence intervals of probabilities, means, quantiles and paired differences.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace unbruised::studies {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Wilson's score interval of a probability (Wilson 1927): all p with |p - successes / trials| <= z sqrt(p (1 - p)
/// / trials). No successes: its low end is 0; successes alone: its high end is 1.
/// @param successes may be a fraction (after a design effect); 0 <= successes <= trials
/// @param trials > 0; otherwise [0, 1]
/// @param confidence in (0, 1), e.g. 0.95
Interval wilson_interval(double successes, double trials, double confidence);
/// Least number of trials, all of them successes, whose Wilson interval lies above `probability`: the least n with
/// n / (n + z^2) > probability. @param probability < 1; from 1 on no number is enough, and the largest comes back
std::size_t trials_to_show(double probability, double confidence);

/// Kish's effective size of a clustered sample: n / deff, deff = 1 + (m - 1) icc, m = sum m_i^2 / n the size of
/// the cluster of a value on average, icc = (B - W) / (B + (m_0 - 1) W) from the one-way analysis of variance
/// (mean squares B between and W within, m_0 = (n - sum m_i^2 / n) / (clusters - 1)), deff >= 1. n where nothing
/// can be told: all clusters different, one only, or all values equal.
/// @param cluster of each value; empty: none @throws std::invalid_argument when the lengths differ
double effective_size(std::span<const double> values, std::span<const std::size_t> cluster);

/// A probability estimated from outcomes, with its interval widened by the clusters' design effect: Wilson's at
/// the size
///   max(n / m, effective_size (t(n - 1) / t(g - 1))^2)
/// with the t of Korn and Graubard (1998), because icc comes from g - 1 degrees of freedom only; n / m, the number
/// of g equal clusters, is what is left when a cluster's values are all the same. Outcomes all alike say nothing
/// of icc, and the size is n / m: with n, an interval of 20 clusters of 20 at p = 0.99 and icc = 0.7 covers it
/// once in three times. A continuous measure behind the outcomes (how far each was from the other outcome) tells
/// more: the icc of what it decides is not larger than its own, so the smaller of both effective sizes is taken.
/// All clusters different, or one only: n. No outcomes: estimate NaN, interval [0, 1].
struct Proportion {
  double estimate = 0.0;
  Interval interval;
  double effective_size = 0.0;  ///< the size the interval is of
  std::size_t count = 0;        ///< outcomes
};
/// @param cluster of each outcome; empty: none @param measure of each outcome, finite; empty: not known
/// @throws std::invalid_argument when the lengths differ
Proportion proportion(const std::vector<bool>& successes, std::span<const std::size_t> cluster, double confidence,
                      std::span<const double> measure = {});

/// Mean of differences and Student's interval; clusters (mean of each, weighted by its size) count as one
/// observation each where they are given and there are at least two. With g clusters of m_i values and mean d_i
/// about the mean d of all n: error^2 = g / (g - 1) sum (m_i / n)^2 (d_i - d)^2 with g - 1 degrees of freedom;
/// equally large, these are Student's of the g means. No values: NaN.
/// @param cluster of each value; empty: each its own @throws std::invalid_argument when the lengths differ
struct MeanInterval {
  double mean = 0.0;
  Interval interval;      ///< [-inf, inf] from one observation
  std::size_t count = 0;  ///< values
};
MeanInterval mean_interval(std::span<const double> values, std::span<const std::size_t> cluster,
                           double confidence);

/// The rows of bootstrap replicate `replicate`: `count` draws of 0..count-1 with replacement.
std::vector<std::size_t> bootstrap_rows(std::size_t count, std::uint64_t seed, std::uint64_t replicate);
/// The k-th smallest and the k-th largest of the replicates, k = floor((1 - confidence) / 2 B), at least 1. NaN
/// among them, or none: NaN.
Interval percentile_interval(std::vector<double> replicates, double confidence);
/// Percentile bootstrap of a statistic of rows 0..count-1. @param statistic is given the drawn row numbers.
Interval bootstrap_interval(std::size_t count, std::size_t replicates, std::uint64_t seed, double confidence,
                            const std::function<double(std::span<const std::size_t>)>& statistic);

/// The k-th smallest with k = ceil(p n), at least 1: the least value that the part p of the values does not
/// exceed. NaN anywhere, or no values: NaN.
double sample_quantile(std::vector<double> values, double p);

}  // namespace unbruised::studies
