#include "studies/text/number_text.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

std::string printed(const char* format, double value) {
  std::array<char, 64> text{};
  const int length = std::snprintf(text.data(), text.size(), format, value);
  return {text.data(), static_cast<std::size_t>(length)};
}

}  // namespace

std::string short_number(double value) { return printed("%.4g", value); }

std::string nine_digits(double value) { return printed("%.9g", value); }

std::string three_digits(double value) {
  if (std::abs(value) < 1000.0 || std::abs(value) >= 1e15) return printed("%.3g", value);
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
  const auto rounded = static_cast<unsigned long long>(std::llround(std::abs(value) / unit) * std::llround(unit));
  return joined({value < 0.0 ? "-" : "", with_thousands(rounded)});
}

std::string percent(double part) {
  const bool is_nearly_all = part > 0.99 && part < 1.0;
  return joined({is_nearly_all ? short_number(100.0 * part) : three_digits(100.0 * part), " %"});
}

std::string signed_percent(double change) { return joined({change < 0.0 ? "" : "+", percent(change)}); }

std::string with_thousands(unsigned long long value) {
  std::string text = std::to_string(value);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ',');
  return text;
}

std::string duration_text(double seconds) {
  if (!(seconds >= 0.0) || !std::isfinite(seconds)) return "?";
  if (seconds < 1.0) return printed("%.2g s", seconds);
  if (seconds < 59.5) return printed("%.0f s", seconds);
  const double minutes = seconds / 60.0;
  if (minutes < 59.5) {
    const double whole = std::floor(minutes);
    return joined({printed("%.0f min", whole), printed(" %.0f s", std::floor(seconds - 60.0 * whole))});
  }
  const double hours = std::floor(minutes / 60.0);
  if (hours < 48.0)
    return joined({printed("%.0f h", hours), printed(" %.0f min", std::floor(minutes - 60.0 * hours))});
  return printed("%.1f days", minutes / 1440.0);
}

std::string bytes_text(double bytes) {
  if (bytes < 1e3) return printed("%.0f bytes", bytes);
  if (bytes < 1e6) return printed("%.3g kB", bytes / 1e3);
  if (bytes < 1e9) return printed("%.3g MB", bytes / 1e6);
  return printed("%.3g GB", bytes / 1e9);
}

}  // namespace unbruised::studies
