#include "core/body/layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/body/shape_mesh.hpp"
#include "core/scenario/relaxation.hpp"
#include "core/scenario/true_shape.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;
using Index = std::array<int, 3>;

/// Depths that differ by less are one, so that mirrored cells are of one material.
constexpr double kRounding = 1e-9;

/// Where cells lie in the grid of the bounding box.
class CellGrid {
 public:
  explicit CellGrid(const Lattice& lattice) : extent_m_(lattice.cell_extent_m) {
    for (std::size_t d = 0; d < 3; ++d) {
      low_m_[d] = lattice.center_m[d] - 0.5 * lattice.cell_count[d] * extent_m_[d];
    }
    for (std::size_t cell = 0; cell < lattice.cell.size(); ++cell) {
      const Place& corner = lattice.position_m[static_cast<std::size_t>(lattice.cell[cell][0])];
      Index at{};
      for (std::size_t d = 0; d < 3; ++d) {
        at[d] = static_cast<int>(std::lround((corner[d] - low_m_[d]) / extent_m_[d]));
      }
      cell_of_.emplace(at, cell);
    }
  }

  [[nodiscard]] Place middle_m(const Index& at) const {
    Place middle{};
    for (std::size_t d = 0; d < 3; ++d) middle[d] = low_m_[d] + (at[d] + 0.5) * extent_m_[d];
    return middle;
  }

  struct Found {
    std::size_t cell;
    Index at;
  };
  /// The cell of the body at a place, or the first one below it. None: there is none within three cells.
  [[nodiscard]] std::optional<Found> below(const Place& place_m, const Place& outward) const {
    const double step_m = 0.25 * std::min({extent_m_[0], extent_m_[1], extent_m_[2]});
    for (int k = 0; k <= 12; ++k) {
      Index at{};
      for (std::size_t d = 0; d < 3; ++d) {
        const double along_m = place_m[d] - (k + kRounding) * step_m * outward[d] - low_m_[d];
        at[d] = static_cast<int>(std::floor(along_m / extent_m_[d]));
      }
      if (const auto found = cell_of_.find(at); found != cell_of_.end()) return Found{found->second, at};
    }
    return std::nullopt;
  }

 private:
  Place extent_m_, low_m_{};
  std::map<Index, std::size_t> cell_of_;
};

/// Strain at a place within a cell, which goes from -1 to 1 along each axis: Voigt rows xx, yy, zz, yz, xz, xy
/// with engineering shears.
std::array<double, 6 * 24> strain_at(const Place& local, const Place& extent_m) {
  std::array<double, 6 * 24> B{};
  for (int c = 0; c < 8; ++c) {
    Place gradient{};
    for (std::size_t d = 0; d < 3; ++d) {
      gradient[d] = ((c >> d) & 1) != 0 ? 0.25 / extent_m[d] : -0.25 / extent_m[d];
      for (std::size_t other = 0; other < 3; ++other) {
        if (other != d) gradient[d] *= ((c >> other) & 1) != 0 ? 1.0 + local[other] : 1.0 - local[other];
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t q = (axis + 1) % 3, r = (axis + 2) % 3, column = 3 * static_cast<std::size_t>(c);
      B[24 * axis + column + axis] = gradient[axis];
      B[24 * (3 + axis) + column + q] = gradient[r];
      B[24 * (3 + axis) + column + r] = gradient[q];
    }
  }
  return B;
}

/// Rows of the strains along two directions of a plane, and between them.
std::array<double, 3 * 6> strain_in_plane(const Place& normal) {
  const std::size_t thin = static_cast<std::size_t>(
      std::ranges::min_element(normal, {}, [](double n) { return std::abs(n); }) - normal.begin());
  Place first{};
  first[thin] = 1.0;
  first = cross(normal, first);
  const double size = length(first);
  for (double& component : first) component /= size;
  const Place second = cross(normal, first);
  std::array<double, 3 * 6> rows{};
  const auto fill = [&](std::size_t row, const Place& a, const Place& b, double factor) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t q = (axis + 1) % 3, r = (axis + 2) % 3;
      rows[6 * row + axis] = factor * a[axis] * b[axis];
      rows[6 * row + 3 + axis] = 0.5 * factor * (a[q] * b[r] + a[r] * b[q]);
    }
  };
  fill(0, first, first, 1.0);
  fill(1, second, second, 1.0);
  fill(2, first, second, 2.0);
  return rows;
}

/// Adds a piece of membrane. @param stiffness_N_m modulus of plane stress x thickness x area, E t A / (1 - nu^2)
void add_piece(const Place& local, const Place& normal, double stiffness_N_m, double poisson_ratio,
               const Place& extent_m, std::array<double, 24 * 24>& K) {
  const auto B = strain_at(local, extent_m);
  const auto rows = strain_in_plane(normal);
  std::array<double, 3 * 24> R{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t f = 0; f < 24; ++f) R[24 * i + f] += rows[6 * i + j] * B[24 * j + f];
    }
  }
  for (std::size_t f = 0; f < 24; ++f) {
    for (std::size_t g = f; g < 24; ++g) {
      const double along = R[f] * R[g] + R[24 + f] * R[24 + g];
      const double across = R[f] * R[24 + g] + R[24 + f] * R[g];
      const double shear = R[48 + f] * R[48 + g];
      K[24 * f + g] += stiffness_N_m * (along + poisson_ratio * across + 0.5 * (1.0 - poisson_ratio) * shear);
    }
  }
}

/// Whether a place, seen from the middle of the bounding box and that deep, lies in a layer.
bool holds(const ProductLayer& layer, const Place& place_m, double depth_m) {
  if (layer.from_depth_m) return depth_m >= *layer.from_depth_m;
  if (!layer.size_m) return false;
  const Place center_m = layer.center_m.value_or(Place{});
  Place in_radii{};
  for (std::size_t d = 0; d < 3; ++d) in_radii[d] = (place_m[d] - center_m[d]) / (0.5 * (*layer.size_m)[d]);
  return dot(in_radii, in_radii) <= 1.0 + kRounding;
}

}  // namespace

std::vector<int> cell_materials(const LatticeParameters& product, const Lattice& lattice) {
  if (product.layer.empty()) return {};
  const TrueShape shape(product);
  std::vector<int> material;
  material.reserve(lattice.cell.size());
  for (const auto& corners : lattice.cell) {
    Place middle{};
    for (std::size_t d = 0; d < 3; ++d) {
      middle[d] = 0.5 * (lattice.position_m[static_cast<std::size_t>(corners[0])][d] +
                         lattice.position_m[static_cast<std::size_t>(corners[7])][d]) -
                  lattice.center_m[d];
    }
    const double depth_m = -shape.nearest(middle).distance_m * (1.0 + kRounding);
    int of = 0;
    for (std::size_t i = 0; i < product.layer.size(); ++i) {
      if (holds(product.layer[i], middle, depth_m)) of = static_cast<int>(i) + 1;
    }
    material.push_back(of);
  }
  return material;
}

std::vector<std::size_t> cells_of_materials(const LatticeParameters& product) {
  const Lattice lattice = build_lattice(product);
  std::vector<std::size_t> count(product.layer.size() + 1, 0);
  for (const int material : cell_materials(product, lattice)) ++count[static_cast<std::size_t>(material)];
  if (product.layer.empty()) count.front() = lattice.cell.size();
  return count;
}

std::vector<CellStiffness> material_cells(const LatticeParameters& product,
                                          const std::array<double, 3>& cell_extent_m) {
  std::vector<CellStiffness> cells{
      cell_stiffness(instantaneous_modulus_Pa(product), product.poisson_ratio, cell_extent_m)};
  for (const ProductLayer& layer : product.layer) {
    cells.push_back(cell_stiffness(instantaneous_modulus_Pa(product, layer.youngs_modulus_Pa),
                                   layer.poisson_ratio.value_or(product.poisson_ratio), cell_extent_m));
  }
  return cells;
}

std::vector<CellAddition> cell_skins(const LatticeParameters& product, const Lattice& lattice) {
  if (!product.skin_thickness_m || !product.skin_modulus_Pa) return {};
  const std::optional<ShapeMesh> mesh = shape_mesh(product);
  if (!mesh) return {};
  const double nu = product.skin_poisson_ratio.value_or(product.poisson_ratio);
  const double per_area_N_m =
      instantaneous_modulus_Pa(product, *product.skin_modulus_Pa) * *product.skin_thickness_m / (1.0 - nu * nu);
  const CellGrid grid(lattice);
  std::map<std::size_t, std::array<double, 24 * 24>> skin;
  for (const auto& triangle : mesh->triangle) {
    std::array<Place, 3> corner{};
    for (std::size_t c = 0; c < 3; ++c) corner[c] = mesh->place_m[static_cast<std::size_t>(triangle[c])];
    Place normal = cross(between(corner[0], corner[1]), between(corner[0], corner[2]));
    const double twice_area_m2 = length(normal);
    if (!(twice_area_m2 > 0.0)) continue;  // at the pole of a solid of revolution
    for (double& component : normal) component /= twice_area_m2;
    // Three places in the triangle integrate squares of what is linear in it.
    for (std::size_t c = 0; c < 3; ++c) {
      Place place{};
      for (std::size_t d = 0; d < 3; ++d) {
        place[d] =
            lattice.center_m[d] + (corner[c][d] * 4.0 + corner[(c + 1) % 3][d] + corner[(c + 2) % 3][d]) / 6.0;
      }
      const auto found = grid.below(place, normal);
      if (!found) continue;
      const Place middle = grid.middle_m(found->at);
      Place local{};
      for (std::size_t d = 0; d < 3; ++d) {
        local[d] = std::clamp(2.0 * (place[d] - middle[d]) / lattice.cell_extent_m[d], -1.0, 1.0);
      }
      add_piece(local, normal, per_area_N_m * twice_area_m2 / 6.0, nu, lattice.cell_extent_m, skin[found->cell]);
    }
  }
  std::vector<CellAddition> cells;
  for (auto& [cell, K] : skin) {
    for (std::size_t f = 0; f < 24; ++f) {
      for (std::size_t g = 0; g < f; ++g) K[24 * f + g] = K[24 * g + f];
    }
    cells.push_back({cell, K});
  }
  return cells;
}

}  // namespace unbruised
