#pragma once

/// @file
/// 64-bit digests: equal exactly when outcome and metrics have equal bits.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

/// XXH3 over the outcome code, outcome_time_s and every metric in table order (little endian), with every
/// NaN written as one pattern and -0 as +0. The cause is a comment on these and does not enter.
std::uint64_t result_digest(const ScenarioResult& result);

/// XXH3 over the digests of a study in scenario order.
std::uint64_t digest_of_digests(std::span<const std::uint64_t> digests);

/// The same of digests that come one by one.
class DigestOfDigests {
 public:
  DigestOfDigests();
  ~DigestOfDigests();
  DigestOfDigests(const DigestOfDigests&) = delete;
  DigestOfDigests& operator=(const DigestOfDigests&) = delete;
  void add(std::uint64_t digest);
  [[nodiscard]] std::uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// XXH3 of bytes, wide enough to take two that agree for the same.
struct WideDigest {
  std::uint64_t low = 0, high = 0;
  friend bool operator==(const WideDigest&, const WideDigest&) = default;
};
WideDigest wide_digest(std::string_view bytes);

/// 16 lower-case hex digits.
std::string digest_text(std::uint64_t digest);

}  // namespace unbruised::studies
