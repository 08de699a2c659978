#pragma once

/// @file
/// SHA-256 (FIPS 180-4) and CRC-32C (Castagnoli, RFC 3720 appendix B.4).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace unbruised::studies {

/// SHA-256 of `bytes`.
std::array<std::uint8_t, 32> sha256(std::string_view bytes);

/// SHA-256 of `bytes` as 64 lower-case hex digits.
std::string sha256_hex(std::string_view bytes);

/// CRC-32C of `bytes`; `crc32c("123456789") == 0xE3069283`.
std::uint32_t crc32c(std::string_view bytes);

}  // namespace unbruised::studies
