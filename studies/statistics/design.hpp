#pragma once

/// @file
/// Designs: where in the open unit cube to sample. A design depends on its kind, size and seed alone, the same on every
/// machine.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unbruised::studies {

enum class DesignKind {
  sobol,            ///< Sobol' sequence with a seeded digital shift (a random-shift scramble)
  latin_hypercube,  ///< one point per stratum of every dimension
  random,           ///< independent
};

/// Points in (0, 1)^dimensions, row-major [point][dimension].
struct UnitDesign {
  std::size_t dimensions = 0;
  std::vector<double> values;

  [[nodiscard]] std::size_t size() const { return dimensions == 0 ? 0 : values.size() / dimensions; }
  [[nodiscard]] double at(std::size_t point, std::size_t dimension) const {
    return values[point * dimensions + dimension];
  }
};

/// @param count > 0. @param dimensions > 0; at most 1,000 for sobol.
UnitDesign unit_design(DesignKind kind, std::size_t count, std::size_t dimensions, std::uint64_t seed);

/// The k-th number in (0, 1) of the stream (seed, stream): counter-based, so no order of use matters.
double unit_random(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);
/// A seed for a named purpose, so that no two purposes share a stream.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose);

}  // namespace unbruised::studies
