#pragma once

/// @file
/// Morris screening and Sobol' indices as designs in the unit cube and as estimates from the answers; no simulator
/// here.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "studies/statistics/design.hpp"
#include "studies/statistics/intervals.hpp"

namespace unbruised::studies {

/// Morris (1991): `trajectories` paths of `dimensions` + 1 points on a grid of `levels` levels, step
/// levels / (2 (levels - 1)). Grid values are moved to the middle of their cell, (k + 0.5) / levels, so that no
/// quantile is taken at 0 or 1; the step is then half the range, and what repeats after half the range is not
/// seen.
/// @param levels even, >= 4
/// @throws std::invalid_argument for other levels
UnitDesign morris_design(std::size_t trajectories, std::size_t dimensions, std::size_t levels, std::uint64_t seed);

/// Elementary effects (f(x + step) - f(x)) / step per unit of the variable's probability (0..1), of one variable.
struct MorrisEffect {
  double mean = 0.0;           ///< mu
  double mean_absolute = 0.0;  ///< mu*, Campolongo et al. 2007
  double standard_deviation = 0.0;
  Interval mean_absolute_interval;  ///< bootstrap over trajectories
};
struct MorrisResult {
  std::vector<MorrisEffect> effects;  ///< one per dimension
  std::size_t used = 0;               ///< trajectories all of whose answers are finite
  bool varies = false;                ///< two answers of these differ
};
/// @param answers one per point of the design; a trajectory with one in it that is no finite number is left out.
/// None left: NaN. One left: its effects, with intervals [0, inf]. @throws std::invalid_argument when the lengths
/// differ
MorrisResult morris_effects(const UnitDesign& design, std::span<const double> answers, double confidence,
                            std::uint64_t seed);

/// Saltelli (2010), in replicates (replicated_design): the base matrices A and B and, per dimension, A with that
/// column from B; blocks of dimensions + 2 points per base sample, in the order A, B, AB_1 ... AB_k.
UnitDesign sobol_index_design(std::size_t base_samples, std::size_t dimensions, DesignKind kind,
                              std::uint64_t seed);

/// Parts of the answers' variance: of variable i alone, and of all in which it takes part.
struct SobolIndex {
  double first = 0.0;  ///< Saltelli 2010: mean of f(B) (f(AB_i) - f(A)) / variance, f less its mean
  double total = 0.0;  ///< Jansen 1999: mean of (f(A) - f(AB_i))^2 / (2 variance)
  Interval first_interval;
  Interval total_interval;
};
struct SobolResult {
  std::vector<SobolIndex> indices;  ///< one per dimension
  double variance = 0.0;            ///< of f(A) and f(B) together
  std::size_t used = 0;             ///< base samples all of whose answers are finite
  bool varies = false;              ///< two answers of these differ
};
/// Indices are 0 where the answers do not vary. Intervals: bootstrap over the base samples of a random design;
/// of a design in replicates Student's with the jackknife over these.
/// @param answers one per point of the design; a base sample with one in it that is no finite number is left out.
/// None left: NaN. One left: intervals [-inf, inf]. @throws std::invalid_argument when the lengths differ
SobolResult sobol_indices(const UnitDesign& design, std::span<const double> answers, std::size_t bootstrap,
                          double confidence, std::uint64_t seed);

}  // namespace unbruised::studies
