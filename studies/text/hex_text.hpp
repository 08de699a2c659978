#pragma once

/// @file
/// Digests and hashes as they are written.

#include <cstdint>
#include <string>

namespace unbruised::studies {

/// Sixteen digits, leading zeros included: "00f3a1...".
std::string hex_text(std::uint64_t value);

}  // namespace unbruised::studies
