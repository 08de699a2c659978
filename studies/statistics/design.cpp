#include "studies/statistics/design.hpp"

#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <boost/random/sobol.hpp>

#include "core/chance/philox.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kSobolDimensionsMost = 1000;
constexpr std::size_t kSobolPointsMost = std::size_t{1} << 32U;
constexpr std::size_t kLatinPointsMost = (std::size_t{1} << 20U) - 1;
constexpr unsigned kSobolBits = 32;

/// Uses of a design's seed.
enum Purpose : std::uint64_t { kScramble = 1, kOrder = 2, kJitter = 3, kIndependent = 4 };

/// Owen's nested uniform scramble in base 2: bit b is flipped by a coin that belongs to (dimension, bits above b).
/// Two points share coins as long as they share bits, so that elementary intervals go to elementary intervals;
/// below the bits of the sequence all is random.
std::uint64_t owen_scrambled(std::uint32_t point, std::uint64_t seed, std::uint64_t dimension) {
  std::uint64_t scrambled = 0;
  for (unsigned b = 0; b < kSobolBits; ++b) {
    const std::uint64_t node = (std::uint64_t{1} << b) | (static_cast<std::uint64_t>(point) >> (kSobolBits - b));
    const std::uint64_t bit = (point >> (kSobolBits - 1 - b)) & 1U;
    scrambled = (scrambled << 1U) | (bit ^ (philox(seed, dimension, node).first & 1U));
  }
  const std::uint64_t leaf = (std::uint64_t{1} << kSobolBits) | point;
  return (scrambled << 32U) | (philox(seed, dimension, leaf).first >> 32U);
}

UnitDesign sobol_design(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  UnitDesign design{dimensions, {}};
  design.values.reserve(count * dimensions);
  boost::random::sobol_engine<std::uint32_t, kSobolBits> engine(dimensions);
  const std::uint64_t scramble = derived_seed(seed, kScramble);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      // The engine begins at the second point; without the first, the origin, no net is whole (Owen 2020).
      const std::uint32_t point = i == 0 ? 0 : engine();
      design.values.push_back(open_unit(owen_scrambled(point, scramble, k)));
    }
  }
  return design;
}

UnitDesign latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  UnitDesign design{dimensions, std::vector<double>(count * dimensions)};
  for (std::size_t k = 0; k < dimensions; ++k) {
    const std::vector<std::size_t> stratum = random_order(count, derived_seed(seed, kOrder), k);
    for (std::size_t i = 0; i < count; ++i) {
      // 32 bits inside the stratum: with its number below 2^20 the sum is exact.
      const std::uint64_t bits = philox(derived_seed(seed, kJitter), k, i).first >> 32U;
      const double inside = (static_cast<double>(bits) + 0.5) * 0x1.0p-32;
      design.values[i * dimensions + k] = (static_cast<double>(stratum[i]) + inside) / static_cast<double>(count);
    }
  }
  return design;
}

UnitDesign independent_design(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  UnitDesign design{dimensions, {}};
  design.values.reserve(count * dimensions);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < dimensions; ++k) {
      design.values.push_back(unit_random(derived_seed(seed, kIndependent), k, i));
    }
  }
  return design;
}

void require(bool holds, const char* rule) {
  if (!holds) throw std::invalid_argument(std::string("unit_design: ") + rule);
}

}  // namespace

UnitDesign unit_design(DesignKind kind, std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  require(count > 0, "count must be > 0");
  require(dimensions > 0, "dimensions must be > 0");
  switch (kind) {
    case DesignKind::sobol:
      require(dimensions <= kSobolDimensionsMost, "a Sobol' design has at most 1,000 dimensions");
      require(count <= kSobolPointsMost, "a Sobol' design has at most 2^32 points");
      return sobol_design(count, dimensions, seed);
    case DesignKind::latin_hypercube:
      require(count <= kLatinPointsMost, "a Latin hypercube has less than 2^20 points");
      return latin_hypercube(count, dimensions, seed);
    case DesignKind::random:
      return independent_design(count, dimensions, seed);
  }
  return {};
}

double unit_random(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  return open_unit(philox(seed, stream, k).first);
}

std::size_t random_index(std::uint64_t seed, std::uint64_t stream, std::uint64_t k, std::size_t count) {
  // u <= 1 - 2^-53, so u * count rounds to less than count.
  return static_cast<std::size_t>(unit_random(seed, stream, k) * static_cast<double>(count));
}

std::vector<std::size_t> random_order(std::size_t count, std::uint64_t seed, std::uint64_t stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random_index(seed, stream, i, i)]);
  return order;
}

std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t purpose) {
  // The half of the block that unit_random leaves.
  return philox(seed, purpose, 0).second;
}

}  // namespace unbruised::studies
