#include "studies/results/digest.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include <xxhash.h>

#include "studies/results/bytes.hpp"

namespace unbruised::studies {

namespace {

double canonical(double value) {
  if (std::isnan(value)) return std::numeric_limits<double>::quiet_NaN();
  return value == 0.0 ? 0.0 : value;
}

}  // namespace

std::uint64_t result_digest(const ScenarioResult& result) {
  ByteWriter bytes;
  bytes.put(static_cast<std::int8_t>(result.outcome));
  bytes.put(canonical(result.outcome_time_s));
  for (const double value : result.metrics.values()) bytes.put(canonical(value));
  return XXH3_64bits(bytes.text().data(), bytes.text().size());
}

std::uint64_t digest_of_digests(std::span<const std::uint64_t> digests) {
  return XXH3_64bits(digests.data(), digests.size_bytes());
}

std::string digest_text(std::uint64_t digest) {
  static constexpr char kHexDigits[] = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = kHexDigits[(digest >> (60 - 4 * i)) & 0xF];
  return text;
}

}  // namespace unbruised::studies
