#include "studies/results/digest.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include <xxhash.h>

#include "studies/results/bytes.hpp"
#include "studies/text/hex_text.hpp"

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

WideDigest wide_digest(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {hash.low64, hash.high64};
}

struct DigestOfDigests::State {
  XXH3_state_t* state = XXH3_createState();
};

DigestOfDigests::DigestOfDigests() : state_(std::make_unique<State>()) { XXH3_64bits_reset(state_->state); }

DigestOfDigests::~DigestOfDigests() { XXH3_freeState(state_->state); }

void DigestOfDigests::add(std::uint64_t digest) { XXH3_64bits_update(state_->state, &digest, sizeof digest); }

std::uint64_t DigestOfDigests::value() const { return XXH3_64bits_digest(state_->state); }

std::string digest_text(std::uint64_t digest) { return hex_text(digest); }

}  // namespace unbruised::studies
