#pragma once

/// @file
/// Linear interpolation in tables whose entries stand at equal steps from 0 on.

#include <algorithm>
#include <cstddef>

namespace unbruised {

/// Where x lies: between the entry `at` and the next one, `part` of the way; beyond the last entry the last slope
/// goes on.
struct BetweenEntries {
  std::size_t at;
  double part;
  /// @param x from 0 on @param count of entries, at least 2
  BetweenEntries(double x, double step, std::size_t count)
      : at(std::min(static_cast<std::size_t>(std::max(0.0, x / step)), count - 2)),
        part(x / step - static_cast<double>(at)) {}
  [[nodiscard]] double of(double low, double high) const { return low + part * (high - low); }
  template <class Table>
  [[nodiscard]] double in(const Table& table) const {
    return of(table[at], table[at + 1]);
  }
};

}  // namespace unbruised
