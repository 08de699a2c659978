#pragma once

/// @file
/// Designs: where in the open unit cube to sample. A design depends on its kind, size and seed alone, the same on
/// every machine: integers alone decide it, no function of a mathematical library.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unbruised::studies {

enum class DesignKind {
  sobol,            ///< Sobol' sequence, Owen-scrambled: seeded and unbiased, every net of the sequence kept
  latin_hypercube,  ///< one point per stratum of every dimension
  random,           ///< independent
};

/// Points in (0, 1)^dimensions, row-major [point][dimension].
struct UnitDesign {
  std::size_t dimensions = 0;
  std::vector<double> values;
  /// Independent designs of which it is made, in turn: point (or base sample) i is of design i % replicates.
  std::size_t replicates = 1;

  [[nodiscard]] std::size_t size() const { return dimensions == 0 ? 0 : values.size() / dimensions; }
  [[nodiscard]] double at(std::size_t point, std::size_t dimension) const {
    return values[point * dimensions + dimension];
  }
};

/// The design. Sobol' and random designs grow at their end: the first n points are the design of n points. A
/// Sobol' design should have a power of two of points: then every dimension has one point per stratum.
/// @param count > 0; below 2^20 for latin_hypercube (rounding could leave a stratum beyond), at most 2^32 for
/// sobol.
/// @param dimensions > 0; at most 1,000 for sobol.
/// @throws std::invalid_argument where one of these does not hold
UnitDesign unit_design(DesignKind kind, std::size_t count, std::size_t dimensions, std::uint64_t seed);

/// The k-th number in (0, 1) of the stream (seed, stream): counter-based, so no order of use matters. Philox
/// 4x32-10 (Salmon et al. 2011) with the seed as key and (stream, k) as counter; 52 of its bits, in the middle of
/// their cell.
double unit_random(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);
/// The k-th number in 0 ... count - 1 of the stream. @param count > 0, below 2^52
std::size_t random_index(std::uint64_t seed, std::uint64_t stream, std::uint64_t k, std::size_t count);
/// The numbers 0 ... count - 1 in the random order of the stream (Fisher and Yates).
std::vector<std::size_t> random_order(std::size_t count, std::uint64_t seed, std::uint64_t stream);
/// A seed for a named purpose, so that no two purposes share a stream.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose);

}  // namespace unbruised::studies
