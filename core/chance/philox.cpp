#include "core/chance/philox.hpp"

#include <cmath>
#include <numbers>

#include <Random123/philox.h>

namespace unbruised {

Bits128 philox(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32U); };
  const r123::Philox4x32::ctr_type counter = {{low(stream), high(stream), low(k), high(k)}};
  const r123::Philox4x32::key_type key = {{low(seed), high(seed)}};
  const r123::Philox4x32::ctr_type block = r123::Philox4x32()(counter, key);
  const auto join = [](std::uint32_t l, std::uint32_t h) { return (static_cast<std::uint64_t>(h) << 32U) | l; };
  return {join(block[0], block[1]), join(block[2], block[3])};
}

double standard_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  const Bits128 bits = philox(seed, stream, k);
  const double radius = std::sqrt(-2.0 * std::log(open_unit(bits.first)));
  return radius * std::cos(2.0 * std::numbers::pi * open_unit(bits.second));
}

}  // namespace unbruised
