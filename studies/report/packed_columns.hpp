#pragma once

/// @file
/// Columns on their way into a page: short ones as JSON arrays, long ones as bytes that the page maps without
/// parsing.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace unbruised::studies {

/// Collects the bytes of long columns. A column is one of
///   [v, ...]                                     up to kPlainRows values; numbers that are not finite are null
///   {"constant": v, "rows": n}
///   {"words": [...], "type": "u8|u16", "at": byte offset, "rows": n}      few values: indices into words
///   {"type": "f64|f32", "at": byte offset, "rows": n}                     NaN where there is no finite number
/// Offsets are multiples of 8, numbers little endian.
class PackedColumns {
 public:
  static constexpr std::size_t kPlainRows = 64;

  enum class Digits {
    all,    ///< 64 bits
    seven,  ///< 32 bits: enough to draw
  };

  nlohmann::json numbers(std::span<const double> values, Digits digits = Digits::all);
  nlohmann::json texts(std::span<const std::string> values);
  /// Bytes as they are: {"type": "u8", "at": byte offset, "rows": n}.
  nlohmann::json raw(std::string_view bytes);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  nlohmann::json indexed(const std::vector<std::uint32_t>& index, nlohmann::json words);
  std::size_t start_column();

  std::string bytes_;
};

}  // namespace unbruised::studies
