#pragma once

/// @file
/// 64-bit digests: equal exactly when outcome and metrics have equal bits.

#include <cstdint>
#include <span>
#include <string>

#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

/// XXH3 over the outcome code, outcome_time_s and every metric in table order (little endian), with every
/// NaN written as one pattern and -0 as +0. The cause is a comment on these and does not enter.
std::uint64_t result_digest(const ScenarioResult& result);

/// XXH3 over the digests of a study in scenario order.
std::uint64_t digest_of_digests(std::span<const std::uint64_t> digests);

/// 16 lower-case hex digits.
std::string digest_text(std::uint64_t digest);

}  // namespace unbruised::studies
