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

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// As 64 lower-case hex digits.
  [[nodiscard]] std::string hex() const;
  [[nodiscard]] std::array<std::uint8_t, 32> value() const;

 private:
  std::array<std::uint32_t, 8> hash_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::string rest_;  ///< less than a block
  std::uint64_t bytes_ = 0;
};

/// SHA-256 of `bytes` as 64 lower-case hex digits.
std::string sha256_hex(std::string_view bytes);

/// CRC-32C of `bytes`; `crc32c("123456789") == 0xE3069283`.
std::uint32_t crc32c(std::string_view bytes);

}  // namespace unbruised::studies
