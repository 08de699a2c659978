#include "core/scenario/lattice_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/scenario/true_shape.hpp"

namespace unbruised {

std::array<int, 3> lattice_cell_count(const LatticeParameters& parameters) {
  std::array<int, 3> count{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double cells = std::round(parameters.size_m[d] / parameters.cell_size_m);
    if (!(cells < std::numeric_limits<int>::max())) throw std::invalid_argument("lattice: too many cells");
    count[d] = std::max(2, static_cast<int>(cells));
  }
  return count;
}

std::array<double, 3> lattice_cell_extent_m(const LatticeParameters& parameters) {
  const std::array<int, 3> count = lattice_cell_count(parameters);
  return {parameters.size_m[0] / count[0], parameters.size_m[1] / count[1], parameters.size_m[2] / count[2]};
}

double true_volume_m3(const LatticeParameters& parameters) { return TrueShape(parameters).volume_m3(); }

double lattice_mass_kg(const LatticeParameters& parameters) {
  if (parameters.mass_kg.has_value() == parameters.density_kg_m3.has_value()) {
    throw std::invalid_argument("lattice_mass_kg: exactly one of mass_kg and density_kg_m3 must be given");
  }
  return parameters.mass_kg ? *parameters.mass_kg : *parameters.density_kg_m3 * true_volume_m3(parameters);
}

double edge_spring_share(const std::array<double, 3>& cell_extent_m, std::size_t axis) {
  const double to_q = cell_extent_m[axis] / cell_extent_m[(axis + 1) % 3];
  const double to_r = cell_extent_m[axis] / cell_extent_m[(axis + 2) % 3];
  return 3.0 - to_q * to_q - to_r * to_r;
}

bool lattice_is_admissible(const std::array<double, 3>& cell_extent_m) {
  for (std::size_t p = 0; p < 3; ++p) {
    if (!(cell_extent_m[p] > 0.0) || !std::isfinite(cell_extent_m[p])) return false;
  }
  for (std::size_t p = 0; p < 3; ++p) {
    if (!(edge_spring_share(cell_extent_m, p) > 0.0)) return false;
  }
  return true;
}

}  // namespace unbruised
