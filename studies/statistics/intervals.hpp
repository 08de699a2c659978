#pragma once

/// @file
/// How sure a number is: confidence intervals of probabilities, means, quantiles and paired differences.

#include <cstddef>
#include <functional>
#include <cstdint>
#include <span>
#include <vector>

namespace unbruised::studies {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Wilson's score interval of a probability. @param successes may be a fraction (after a design effect);
/// 0 <= successes <= trials. @param trials > 0. @param confidence e.g. 0.95
Interval wilson_interval(double successes, double trials, double confidence);
/// Least number of trials, all of them successes, whose Wilson interval lies above `probability`.
std::size_t trials_to_show(double probability, double confidence);

/// Kish's effective size of a clustered sample: n / deff, deff = 1 + (m - 1) icc, icc from the one-way analysis of
/// variance, deff >= 1. All clusters different, or one only: n.
/// @param cluster of each value
double effective_size(std::span<const double> values, std::span<const std::size_t> cluster);

/// A probability estimated from outcomes, with its interval widened by the clusters' design effect.
struct Proportion {
  double estimate = 0.0;
  Interval interval;
  double effective_size = 0.0;
};
Proportion proportion(const std::vector<bool>& successes, std::span<const std::size_t> cluster, double confidence);

/// Mean of differences and Student's interval; clusters (mean of each, weighted alike when equally large) count as one
/// observation each where they are given and there are at least two.
struct MeanInterval {
  double mean = 0.0;
  Interval interval;  ///< [-inf, inf] from one observation
  std::size_t count = 0;
};
MeanInterval mean_interval(std::span<const double> values, std::span<const std::size_t> cluster, double confidence);

/// Percentile bootstrap of a statistic of rows 0..count-1. @param statistic is given the drawn row numbers.
Interval bootstrap_interval(std::size_t count, std::size_t replicates, std::uint64_t seed, double confidence,
                            const std::function<double(std::span<const std::size_t>)>& statistic);

/// The k-th smallest with k = ceil(p n), at least 1: the least value that the part p of the values does not exceed.
/// NaN anywhere: NaN.
double sample_quantile(std::vector<double> values, double p);

}  // namespace unbruised::studies
