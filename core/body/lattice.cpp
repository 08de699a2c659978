#include "core/body/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

using Index3 = std::array<int, 3>;

/// `TrueShape` on the grid of its bounding box [-1, 1]^3. Every q of a cell centre or particle is m / n with n
/// cells along the axis and -n <= m <= n, so that questions of inside and outside, sum over the round axes of q^2
/// <= 1, are answered in integers, alike for mirrored places. Other solids are asked at the place itself.
class UnitShape {
 public:
  UnitShape(const LatticeParameters& parameters, const Index3& cell_count)
      : cell_count_(cell_count), size_m_(parameters.size_m), shape_(parameters) {
    for (std::size_t axis = 0; axis < 3; ++axis) round_[axis] = shape_.is_round(axis);
  }

  bool contains(const Index3& m) const {
    return shape_.solid() != nullptr ? shape_.contains(place_m(m)) : deficit(m, round_) >= 0.0;
  }

  /// As `TrueShape::column_m`, over half the extent.
  std::optional<double> column(std::size_t side, const Index3& m) const {
    const std::size_t axis = side / 2;
    if (shape_.solid() != nullptr) {
      const auto column_m = shape_.column_m(side, place_m(m));
      return column_m ? std::optional(*column_m / (0.5 * size_m_[axis])) : std::nullopt;
    }
    std::array<bool, 3> counted = round_;
    counted[axis] = false;
    const double rest = deficit(m, counted);
    if (rest < 0.0) return std::nullopt;
    return round_[axis] ? std::sqrt(rest) : 1.0;
  }

 private:
  std::array<double, 3> place_m(const Index3& m) const {
    std::array<double, 3> place{};
    for (std::size_t d = 0; d < 3; ++d) place[d] = 0.5 * size_m_[d] * (static_cast<double>(m[d]) / cell_count_[d]);
    return place;
  }

  /// 1 - sum over counted axes of (m / n)^2; its sign is exact.
  double deficit(const Index3& m, const std::array<bool, 3>& counted) const {
    long long numerator = 1;
    long long denominator = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      if (!counted[d]) continue;
      const long long n2 = static_cast<long long>(cell_count_[d]) * cell_count_[d];
      const long long m2 = static_cast<long long>(m[d]) * m[d];
      numerator = numerator * n2 - m2 * denominator;
      denominator *= n2;
    }
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }

  Index3 cell_count_;
  std::array<double, 3> size_m_;
  TrueShape shape_;
  std::array<bool, 3> round_{};
};

/// Which cells of the bounding box belong to the body, and how its particles are numbered.
///
/// The body is face-connected without further ado: boxes, ellipsoids and cylinders are symmetric about the three
/// mid-planes and convex, so that a cell stays inside when it moves along one axis towards the middle; of a solid
/// of revolution a rule asks that no layer of cells be empty between others.
class Grid {
 public:
  Grid(const LatticeParameters& parameters, const Index3& cell_count)
      : n_(cell_count), shape_(parameters, cell_count) {
    mark_cells();
    number_nodes();
  }

  const UnitShape& shape() const { return shape_; }
  int node_total() const { return node_total_; }
  bool has_cell(const Index3& c) const { return inside_[cell_index(c)] != 0; }
  /// -1 where no cell of the body has a corner.
  int node(const Index3& p) const { return node_[node_index(p)]; }
  const Index3& cells() const { return n_; }

  /// In ascending z, then y, then x.
  template <class Visit>
  void for_each_cell(Visit visit) const {
    for (int k = 0; k < n_[2]; ++k) {
      for (int j = 0; j < n_[1]; ++j) {
        for (int i = 0; i < n_[0]; ++i) {
          if (has_cell({i, j, k})) visit(Index3{i, j, k});
        }
      }
    }
  }

  /// In ascending z, then y, then x: the order of their numbers.
  template <class Visit>
  void for_each_node(Visit visit) const {
    for (int k = 0; k <= n_[2]; ++k) {
      for (int j = 0; j <= n_[1]; ++j) {
        for (int i = 0; i <= n_[0]; ++i) {
          if (node({i, j, k}) >= 0) visit(Index3{i, j, k});
        }
      }
    }
  }

  /// Twice the place from the middle, in cells: m of q = m / n.
  Index3 from_middle(const Index3& p) const { return {2 * p[0] - n_[0], 2 * p[1] - n_[1], 2 * p[2] - n_[2]}; }

  static Index3 corner(const Index3& cell, int c) {
    return {cell[0] + (c & 1), cell[1] + ((c >> 1) & 1), cell[2] + ((c >> 2) & 1)};
  }

 private:
  std::size_t cell_index(const Index3& c) const {
    return (static_cast<std::size_t>(c[2]) * n_[1] + c[1]) * n_[0] + c[0];
  }
  std::size_t node_index(const Index3& p) const {
    return (static_cast<std::size_t>(p[2]) * (n_[1] + 1) + p[1]) * (n_[0] + 1) + p[0];
  }

  void mark_cells() {
    inside_.reserve(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2]);
    for (int k = 0; k < n_[2]; ++k) {
      for (int j = 0; j < n_[1]; ++j) {
        for (int i = 0; i < n_[0]; ++i) {
          const Index3 m{2 * i + 1 - n_[0], 2 * j + 1 - n_[1], 2 * k + 1 - n_[2]};
          inside_.push_back(shape_.contains(m) ? 1 : 0);
        }
      }
    }
  }

  void number_nodes() {
    node_.assign(static_cast<std::size_t>(n_[0] + 1) * (n_[1] + 1) * (n_[2] + 1), -1);
    for_each_cell([this](const Index3& cell) {
      for (int c = 0; c < 8; ++c) node_[node_index(corner(cell, c))] = 0;
    });
    for (int& number : node_) {
      if (number == 0) number = node_total_++;
    }
  }

  Index3 n_;
  UnitShape shape_;
  std::vector<char> inside_;
  std::vector<int> node_;
  int node_total_ = 0;
};

/// The particle furthest along the outward normal in the column of `node`.
bool is_outermost(const Grid& grid, std::size_t axis, int step, Index3 node) {
  for (node[axis] += step; node[axis] >= 0 && node[axis] <= grid.cells()[axis]; node[axis] += step) {
    if (grid.node(node) >= 0) return false;
  }
  return true;
}

std::vector<SurfacePoint> surface_points(const Grid& grid, const Lattice& lattice,
                                         const LatticeParameters& parameters, std::size_t axis, int step) {
  std::vector<SurfacePoint> points;
  grid.for_each_node([&](const Index3& node) {
    if (!is_outermost(grid, axis, step, node)) return;
    const auto column = grid.shape().column(2 * axis + (step > 0 ? 1 : 0), grid.from_middle(node));
    if (!column) return;
    const double position = lattice.center_m[axis] + step * (0.5 * parameters.size_m[axis] * *column);
    points.push_back({grid.node(node), position});
  });
  return points;
}

void place_particles(const Grid& grid, const LatticeParameters& parameters, Lattice& lattice) {
  const Index3& n = grid.cells();
  lattice.position_m.reserve(static_cast<std::size_t>(grid.node_total()));
  grid.for_each_node([&](const Index3& node) {
    const Index3 m = grid.from_middle(node);
    lattice.position_m.push_back({0.5 * parameters.size_m[0] * (static_cast<double>(m[0]) / n[0]),
                                  0.5 * parameters.size_m[1] * (static_cast<double>(m[1]) / n[1]),
                                  parameters.size_m[2] * (static_cast<double>(node[2]) / n[2])});
  });
}

void join_cells(const Grid& grid, Lattice& lattice) {
  grid.for_each_cell([&](const Index3& cell) {
    std::array<int, 8> corners{};
    for (int c = 0; c < 8; ++c) corners[c] = grid.node(Grid::corner(cell, c));
    lattice.cell.push_back(corners);
  });
}

/// Rounding each particle's mass once keeps the exact sum within one unit in the last place of the total.
void spread_mass(double total_kg, Lattice& lattice) {
  std::vector<int> eighths(lattice.position_m.size(), 0);
  for (const auto& cell : lattice.cell) {
    for (const int node : cell) ++eighths[node];
  }
  const double all_eighths = 8.0 * static_cast<double>(lattice.cell.size());
  lattice.mass_kg.reserve(eighths.size());
  for (const int count : eighths) lattice.mass_kg.push_back(total_kg * count / all_eighths);
}

bool is_positive(double value) { return value > 0.0 && std::isfinite(value); }

void require_sensible(const LatticeParameters& parameters) {
  for (const double size : parameters.size_m) {
    if (!is_positive(size)) throw std::invalid_argument("build_lattice: size_m must be positive");
  }
  if (!is_positive(parameters.cell_size_m)) {
    throw std::invalid_argument("build_lattice: cell_size_m must be positive");
  }
  double nodes = 1.0;
  for (const double size : parameters.size_m)
    nodes *= std::max(2.0, std::round(size / parameters.cell_size_m)) + 1.0;
  // 3 freedoms per particle are counted in int, and (n_x n_y n_z)^2 must fit 64 bits in UnitShape.
  if (!(nodes < std::numeric_limits<int>::max() / 3.0))
    throw std::invalid_argument("build_lattice: too many cells");
}

}  // namespace

Lattice build_lattice(const LatticeParameters& parameters) {
  require_sensible(parameters);
  const double mass = lattice_mass_kg(parameters);
  if (!is_positive(mass)) throw std::invalid_argument("build_lattice: mass must be positive");

  Lattice lattice;
  lattice.cell_count = lattice_cell_count(parameters);
  lattice.cell_extent_m = lattice_cell_extent_m(parameters);
  lattice.true_volume_m3 = true_volume_m3(parameters);
  lattice.center_m = {0.0, 0.0, 0.5 * parameters.size_m[2]};
  const Grid grid(parameters, lattice.cell_count);
  place_particles(grid, parameters, lattice);
  join_cells(grid, lattice);
  spread_mass(mass, lattice);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lattice.side[2 * axis] = surface_points(grid, lattice, parameters, axis, -1);
    lattice.side[2 * axis + 1] = surface_points(grid, lattice, parameters, axis, +1);
  }
  return lattice;
}

}  // namespace unbruised
