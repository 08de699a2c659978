#include "studies/text/hex_text.hpp"

namespace unbruised::studies {

std::string hex_text(std::uint64_t value) {
  static constexpr char kHexDigits[] = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = kHexDigits[(value >> (60 - 4 * i)) & 0xF];
  return text;
}

}  // namespace unbruised::studies
