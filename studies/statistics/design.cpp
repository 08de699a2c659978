#include "studies/statistics/design.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/random/sobol.hpp>

namespace unbruised::studies {
namespace {

/// Streams of a design's seed.
enum Stream : std::uint64_t { kShift = 1, kJitter = 2, kOrder = 3, kPlain = 4 };

/// SplitMix64's finaliser (Steele, Lea and Flood 2014): every bit of the input moves every bit of the output.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

/// 52 bits in the middle of their cells, so that neither 0 nor 1 comes out.
double open_unit(std::uint64_t bits) { return (static_cast<double>(bits >> 12U) + 0.5) * 0x1.0p-52; }

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  return mixed(mixed(mixed(seed) ^ stream) ^ k);
}

/// A digital shift keeps every stratum of the sequence: all points are exclusive-ored with one number per dimension.
UnitDesign sobol_design(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  UnitDesign design{dimensions, {}};
  design.values.reserve(count * dimensions);
  boost::random::sobol_engine<std::uint64_t, 64> engine(dimensions);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      design.values.push_back(open_unit(engine() ^ random_bits(seed, kShift, k)));
    }
  }
  return design;
}

UnitDesign latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  UnitDesign design{dimensions, std::vector<double>(count * dimensions)};
  std::vector<std::size_t> order(count);
  for (std::size_t k = 0; k < dimensions; ++k) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) {
      const double random = unit_random(derived_seed(seed, kOrder), k, i);
      std::swap(order[i - 1], order[static_cast<std::size_t>(random * static_cast<double>(i))]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double inside = unit_random(derived_seed(seed, kJitter), k, i);
      design.values[i * dimensions + k] = (static_cast<double>(order[i]) + inside) / static_cast<double>(count);
    }
  }
  return design;
}

UnitDesign random_design(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  UnitDesign design{dimensions, {}};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      design.values.push_back(unit_random(derived_seed(seed, kPlain), k, i));
    }
  }
  return design;
}

}  // namespace

UnitDesign unit_design(DesignKind kind, std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  switch (kind) {
    case DesignKind::sobol:
      return sobol_design(count, dimensions, seed);
    case DesignKind::latin_hypercube:
      return latin_hypercube(count, dimensions, seed);
    case DesignKind::random:
      return random_design(count, dimensions, seed);
  }
  return {};
}

double unit_random(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  return open_unit(random_bits(seed, stream, k));
}

std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose) { return mixed(mixed(seed) + purpose); }

}  // namespace unbruised::studies
