#pragma once

/// @file
/// An interval of numbers, and its words.

#include <limits>
#include <string>

namespace unbruised {

struct Range {
  double min = -std::numeric_limits<double>::infinity();
  bool min_open = false;
  double max = std::numeric_limits<double>::infinity();
  bool max_open = false;

  /// False for NaN.
  [[nodiscard]] bool contains(double value) const;
  /// "> 0", ">= 0, < 0.5"; empty: any number
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool operator==(const Range&) const = default;
};

inline constexpr Range kAnyNumber{};
inline constexpr Range kPositive{.min = 0.0, .min_open = true};
inline constexpr Range kNotNegative{.min = 0.0};

}  // namespace unbruised
