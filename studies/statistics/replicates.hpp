#pragma once

/// @file
/// Designs in independent replicates, and what their spread says. The points of a Sobol' or Latin hypercube design
/// are not independent, so their scatter does not tell how sure an estimate is (it claims 2.5 to 3.8 times too
/// much). A few designs of the same kind, each randomised on its own, are independent of each other: the estimate
/// is of all points, and Student's t over the replicates gives its interval, which L'Ecuyer, Nakayama, Owen and
/// Tuffin (2023) found to cover most reliably for randomised quasi-Monte Carlo.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "studies/statistics/design.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {

/// Replicates that a design of so many independent units (points, or groups that points share) is drawn in: 8,
/// whose interval is 1.16 times as wide as with a known spread; 6 or 7 for 12 to 15 units, so that each replicate
/// has two; below 12 each unit is drawn on its own. 1 for random designs, whose points are independent.
std::size_t replicate_count(DesignKind kind, std::size_t units);

/// What a design is made of.
struct ReplicatedDesign {
  DesignKind kind = DesignKind::sobol;
  std::size_t count = 0;       ///< points in all, > 0
  std::size_t dimensions = 0;  ///< > 0
  std::size_t replicates = 1;  ///< > 0, <= count
};
/// Designs of one kind, each of a seed of its own, point by point in turn: point i is point i / replicates of
/// replicate i % replicates, so that what grows at its end still does. One replicate: unit_design.
/// @throws std::invalid_argument as unit_design
UnitDesign replicated_design(const ReplicatedDesign& wanted, std::uint64_t seed);

/// How the values of a sample depend on each other.
struct SampleStructure {
  std::span<const std::size_t> cluster;    ///< of each value: what it shares with others; empty: nothing
  std::span<const std::size_t> replicate;  ///< of each value; empty: the design has none
};

/// proportion() of a sample in replicates: Wilson's interval at the size at which the variance of the mean is what
/// the replicates show, times z^2 / t^2 for what so few numbers do not know. With R replicates of n_r points, K_r
/// of them successes and p the part of all, the variance of the number of successes is R / (R - 1) sum (K_r - n_r
/// p)^2, taken as 1 at least: numbers that happen to agree are known to one outcome. Twelve outcomes that differ
/// from the others are too few to tell a variance; below that the size is at least that of independent draws, and
/// all alike it is that size. Without replicates: proportion().
/// @throws std::invalid_argument when the lengths differ
Proportion sampled_proportion(const std::vector<bool>& successes, const SampleStructure& sample, double confidence,
                              std::span<const double> measure = {});

/// mean_interval() over the replicates, or over the clusters where there are none.
MeanInterval sampled_mean(std::span<const double> values, const SampleStructure& sample, double confidence);

/// Woodruff's interval (1952) of a quantile: the values x of which a part |P(x) - p| <= z sqrt(p (1 - p) / size)
/// does not exceed x, with the size of sampled_proportion() at the sample's quantile; infinite where the sample is
/// too small to tell. NaN anywhere, or no values: NaN.
Interval quantile_interval(std::vector<double> values, double p, const SampleStructure& sample, double confidence);

}  // namespace unbruised::studies
