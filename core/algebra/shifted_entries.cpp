#include "core/algebra/shifted_entries.hpp"

#include <cstddef>

#include "core/door/require.hpp"

namespace unbruised {

std::vector<MatrixEntry> shifted_entries(const BlockMatrix& K, std::span<const double> mass_kg, double mass_factor,
                                         std::span<const int> freedom) {
  const auto particles = static_cast<std::size_t>(K.particle_count);
  require(mass_kg.size() == particles && freedom.size() == 3 * particles,
          "shifted_entries: masses or freedoms of other particles than the matrix");
  std::vector<MatrixEntry> entries;
  entries.reserve(K.value.size() / 2 + 3 * mass_kg.size());
  for (int i = 0; i < K.particle_count; ++i) {
    for (int p = K.row_start[i]; p < K.row_start[i + 1]; ++p) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const int row = freedom[3 * static_cast<std::size_t>(i) + r];
          const int column = freedom[3 * static_cast<std::size_t>(K.column[p]) + c];
          if (row < 0 || column < 0 || row < column) continue;
          double value = K.value[9 * static_cast<std::size_t>(p) + 3 * r + c];
          if (row == column) value += mass_factor * mass_kg[i];
          entries.push_back({row, column, value});
        }
      }
    }
  }
  return entries;
}

}  // namespace unbruised
