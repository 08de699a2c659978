#include "core/scenario/words.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace unbruised {
namespace {

/// "1e+06" and "1e-04" as people write them: "1e6", "1e-4".
void tidy_exponent(std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return;
  if (text[e + 1] == '+') text.erase(e + 1, 1);
  const std::size_t digits = text[e + 1] == '-' ? e + 2 : e + 1;
  while (text[digits] == '0' && digits + 1 < text.size()) text.erase(digits, 1);
}

/// @param precision of the format
std::string fixed_or_general(double number, std::chars_format format, int precision) {
  std::array<char, 48> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, format, precision).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::string spelled(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  std::string text(buffer.data(), end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  tidy_exponent(text);
  return text;
}

std::string spelled_plain(double number) {
  std::string text = spelled(number);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string in_per_cent(double part) { return for_people(100.0 * part) + " %"; }

std::string for_people(double number) {
  constexpr int kDigits = 4;
  constexpr double kLongest = 1e10;
  const double size = std::abs(number);
  if (!std::isfinite(number) || (size < 1e4 || size >= kLongest)) {
    std::string text = fixed_or_general(number, std::chars_format::general, kDigits);
    tidy_exponent(text);
    return text;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(size)) - (kDigits - 1));
  std::string text = fixed_or_general(std::round(number / unit) * unit, std::chars_format::fixed, 0);
  const std::size_t first = text.front() == '-' ? 1 : 0;
  for (std::size_t at = text.size(); at > first + 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

}  // namespace unbruised
