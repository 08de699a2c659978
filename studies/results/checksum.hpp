#pragma once

/// @file
/// SHA-256 (FIPS 180-4, by OpenSSL) and CRC-32C (Castagnoli, RFC 3720 appendix B.4).

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX

namespace unbruised::studies {

/// SHA-256 of `bytes`.
std::array<std::uint8_t, 32> sha256(std::string_view bytes);

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  /// As 64 lower-case hex digits.
  [[nodiscard]] std::string hex() const;
  [[nodiscard]] std::array<std::uint8_t, 32> value() const;

 private:
  struct Free {
    void operator()(evp_md_ctx_st* state) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> state_;
};

/// SHA-256 of `bytes` as 64 lower-case hex digits.
std::string sha256_hex(std::string_view bytes);

/// CRC-32C of `bytes`; `crc32c("123456789") == 0xE3069283`.
std::uint32_t crc32c(std::string_view bytes);

}  // namespace unbruised::studies
