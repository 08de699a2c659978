#include "studies/results/checksum.hpp"

#include <cstring>

#include <openssl/evp.h>

#include "core/door/require.hpp"

namespace unbruised::studies {

namespace {

using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

/// Table k: what a byte does to the checksum when k more bytes follow it.
constexpr CrcTables crc32c_tables() {
  constexpr std::uint32_t kReversedPolynomial = 0x82F63B78;
  CrcTables tables{};
  for (std::uint32_t index = 0; index < 256; ++index) {
    std::uint32_t crc = index;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? kReversedPolynomial : 0U);
    tables[0][index] = crc;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t index = 0; index < 256; ++index) {
      const std::uint32_t before = tables[k - 1][index];
      tables[k][index] = (before >> 8) ^ tables[0][before & 0xFF];
    }
  }
  return tables;
}

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* state) const { EVP_MD_CTX_free(state); }

Sha256::Sha256() : state_(EVP_MD_CTX_new()) {
  require(EVP_DigestInit_ex(state_.get(), EVP_sha256(), nullptr) == 1, "Sha256: OpenSSL does not begin");
}

void Sha256::add(std::string_view bytes) {
  require(EVP_DigestUpdate(state_.get(), bytes.data(), bytes.size()) == 1, "Sha256: OpenSSL takes no bytes");
}

std::array<std::uint8_t, 32> Sha256::value() const {
  const Sha256 so_far;
  std::array<std::uint8_t, 32> hash{};
  require(EVP_MD_CTX_copy_ex(so_far.state_.get(), state_.get()) == 1 &&
              EVP_DigestFinal_ex(so_far.state_.get(), hash.data(), nullptr) == 1,
          "Sha256: OpenSSL does not end");
  return hash;
}

std::string Sha256::hex() const {
  static constexpr char kHexDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : value()) {
    text.push_back(kHexDigits[byte >> 4]);
    text.push_back(kHexDigits[byte & 0xF]);
  }
  return text;
}

std::array<std::uint8_t, 32> sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.value();
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hex();
}

// Eight bytes at a time: the tables say what each does when so many follow it.
std::uint32_t crc32c(std::string_view bytes) {
  static constexpr CrcTables kTables = crc32c_tables();
  std::uint32_t crc = 0xFFFFFFFF;
  for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof word);  // little endian, as bytes.hpp asks for
    word ^= crc;
    crc = 0;
    for (std::size_t k = 0; k < 8; ++k) crc ^= kTables[7 - k][(word >> (8 * k)) & 0xFF];
  }
  for (const char byte : bytes) crc = (crc >> 8) ^ kTables[0][(crc ^ static_cast<std::uint8_t>(byte)) & 0xFF];
  return crc ^ 0xFFFFFFFF;
}

}  // namespace unbruised::studies
