#include "studies/report/packed_columns.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

#include <nlohmann/json.hpp>

namespace unbruised::studies {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "the page reads little-endian columns");

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kIndexMost = 65536;

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// The bits of a value, one pattern for all that is not finite.
std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(std::isfinite(value) ? value : kNoNumber);
}

}  // namespace

json PackedColumns::numbers(std::span<const double> values, Digits digits) {
  if (values.size() <= kPlainRows) {
    json plain = json::array();
    for (const double value : values) plain.push_back(number(value));
    return plain;
  }
  // Many rows with few values: grid points, counts, metrics that do not exist.
  const std::size_t most = std::min(kIndexMost, values.size() / 8);
  std::unordered_map<std::uint64_t, std::uint32_t> index_of;
  std::vector<std::uint32_t> index;
  json words = json::array();
  for (const double value : values) {
    const auto [found, is_new] = index_of.try_emplace(bits_of(value), static_cast<std::uint32_t>(index_of.size()));
    if (index_of.size() > most) break;
    if (is_new) words.push_back(number(value));
    index.push_back(found->second);
  }
  if (index.size() == values.size()) return indexed(index, std::move(words));

  const std::size_t at = start_column();
  for (const double value : values) {
    const double kept = std::isfinite(value) ? value : kNoNumber;
    if (digits == Digits::all) {
      put(bytes_, kept);
    } else {
      put(bytes_, static_cast<float>(kept));
    }
  }
  return {{"type", digits == Digits::all ? "f64" : "f32"}, {"at", at}, {"rows", values.size()}};
}

json PackedColumns::texts(std::span<const std::string> values) {
  if (values.size() <= kPlainRows) return json(std::vector<std::string>(values.begin(), values.end()));
  std::unordered_map<std::string, std::uint32_t> index_of;
  std::vector<std::uint32_t> index;
  json words = json::array();
  for (const std::string& value : values) {
    const auto [found, is_new] = index_of.try_emplace(value, static_cast<std::uint32_t>(index_of.size()));
    if (is_new) words.push_back(value);
    index.push_back(found->second);
  }
  if (index_of.size() > kIndexMost) return json(std::vector<std::string>(values.begin(), values.end()));
  return indexed(index, std::move(words));
}

json PackedColumns::raw(std::string_view bytes) {
  const std::size_t at = start_column();
  bytes_ += bytes;
  return {{"type", "u8"}, {"at", at}, {"rows", bytes.size()}};
}

json PackedColumns::indexed(const std::vector<std::uint32_t>& index, json words) {
  if (words.size() == 1) return {{"constant", words[0]}, {"rows", index.size()}};
  const bool small = words.size() <= 256;
  const std::size_t at = start_column();
  for (const std::uint32_t each : index) {
    if (small) {
      put(bytes_, static_cast<std::uint8_t>(each));
    } else {
      put(bytes_, static_cast<std::uint16_t>(each));
    }
  }
  return {{"words", std::move(words)}, {"type", small ? "u8" : "u16"}, {"at", at}, {"rows", index.size()}};
}

std::size_t PackedColumns::start_column() {
  bytes_.resize((bytes_.size() + 7) / 8 * 8, '\0');
  return bytes_.size();
}

}  // namespace unbruised::studies
