#pragma once

/// @file
/// Distributions of product properties, sampled by their quantile function alone, so that one number in (0, 1)
/// gives one value and the same numbers give common random products.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unbruised::studies {

enum class DistributionKind { uniform, normal, lognormal, triangular, data };

/// One distribution; which fields it needs depends on its kind.
struct Distribution {
  DistributionKind kind = DistributionKind::uniform;
  /// normal, lognormal: of the variable itself, not of its logarithm. lognormal: mean > 0
  double mean = 0.0;
  /// >= 0; normal, lognormal: of the variable itself
  double standard_deviation = 0.0;
  /// uniform, triangular: from < to, from <= mode <= to
  double from = 0.0;
  double to = 1.0;
  double mode = 0.5;
  /// at_least < at_most; cut off beyond, and scaled up to one again
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  /// data: the values themselves, ascending, all equally likely; not truncated
  std::vector<double> values = {};
};

/// The broken rule ("standard_deviation must be >= 0"); nothing when the distribution is sound. Sound ones keep
/// more than 1e-12 of their probability between at_least and at_most.
std::optional<std::string> broken_rule(const Distribution& distribution);

/// The value below which the part `u` of the truncated distribution lies; 0 < u < 1. Monotone in u. Finite, and
/// never beyond at_least and at_most. With F the distribution before it is truncated: F^-1(F(at_least) + u
/// (F(at_most) - F(at_least))), taken from 1 - F in the upper part, so that far tails keep their digits. Of n
/// values of data the one at floor(u n).
double quantile(const Distribution& distribution, double u);
/// Which of `rows` equally likely rows a number 0 < u < 1 draws. @param rows > 0
std::size_t row_of_number(double u, std::size_t rows);
/// The part of the truncated distribution at or below `value`.
double cumulative(const Distribution& distribution, double value);

/// "normal(mean 0.095, sd 0.01), 0.08 to 0.12"; "uniform(1 to 2)"; "triangular(1 to 3, mode 2), at least 1.5";
/// "data(40 values, 1.23 to 7.86)"
std::string distribution_text(const Distribution& distribution);

/// Mean and standard deviation (n - 1) of measured values. One value: standard deviation 0. None: NaN.
struct MeanAndSpread {
  double mean = 0.0;
  double standard_deviation = 0.0;
};
MeanAndSpread mean_and_spread(std::span<const double> values);

}  // namespace unbruised::studies
