#include <algorithm>
#include <array>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/profile_curve.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/true_shape.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr std::string_view kHeight = "product.profile_height", kRadius = "product.profile_radius";

const LatticeParameters* lattice_of(const Scenario& s) { return std::get_if<LatticeParameters>(&s.product); }

void profile_is_sound(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::revolution) return;
  if (p->profile_height.empty() && p->profile_radius.empty()) {
    out.push_back({std::string(kHeight), "",
                   "missing; shape = \"revolution\" needs profile_height and profile_radius, or profile_file"});
    return;
  }
  if (const auto fault = profile_fault(p->profile_height, p->profile_radius)) {
    out.push_back({std::string(fault->of_heights ? kHeight : kRadius), fault->value, fault->rule});
  }
}

void revolution_is_round(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::revolution) return;
  const auto axis = static_cast<std::size_t>(p->axis);
  if (p->size_m[(axis + 1) % 3] == p->size_m[(axis + 2) % 3]) return;
  out.push_back({"product.size_m", "", "a solid of revolution has two equal extents across product.axis"});
}

/// Does a layer of cells hold one? The cell nearest to the axis does, or none.
bool has_cells(const LatticeParameters& p, const TrueShape& shape, std::size_t axis, int layer) {
  const std::array<int, 3> count = lattice_cell_count(p);
  std::array<double, 3> place{};
  for (std::size_t d = 0; d < 3; ++d) {
    const int twice = d == axis ? 2 * layer + 1 - count[d] : (count[d] % 2 == 0 ? 1 : 0);
    place[d] = 0.5 * p.size_m[d] * (static_cast<double>(twice) / count[d]);
  }
  return shape.contains(place);
}

void mesh_is_there(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::mesh || p->mesh) return;
  out.push_back({"product.shape", "\"mesh\"", "needs product.mesh_file and product.mesh_unit"});
}

/// Into how many pieces do the cells of a mesh fall that are joined where they share a face?
int pieces_of_cells(const LatticeParameters& p, const TrueShape& shape) {
  const std::array<int, 3> count = lattice_cell_count(p);
  const auto number = [&](int i, int j, int k) {
    return (static_cast<std::size_t>(k) * count[1] + j) * count[0] + i;
  };
  std::vector<char> open(number(0, 0, count[2]), 0);
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        const std::array<int, 3> twice = {2 * i + 1 - count[0], 2 * j + 1 - count[1], 2 * k + 1 - count[2]};
        std::array<double, 3> place{};
        for (std::size_t d = 0; d < 3; ++d) {
          place[d] = 0.5 * p.size_m[d] * (static_cast<double>(twice[d]) / count[d]);
        }
        open[number(i, j, k)] = shape.contains(place) ? 1 : 0;
      }
    }
  }
  int pieces = 0;
  std::vector<std::array<int, 3>> reached;
  for (std::size_t first = 0; first < open.size(); ++first) {
    if (open[first] == 0) continue;
    ++pieces;
    open[first] = 0;
    const auto at = static_cast<int>(first);
    reached.push_back({at % count[0], at / count[0] % count[1], at / count[0] / count[1]});
    while (!reached.empty()) {
      const std::array<int, 3> cell = reached.back();
      reached.pop_back();
      for (std::size_t side = 0; side < 6; ++side) {
        std::array<int, 3> next = cell;
        int& along = next[side / 2];
        along += side % 2 == 0 ? -1 : 1;
        if (along < 0 || along >= count[side / 2]) continue;
        char& is_open = open[number(next[0], next[1], next[2])];
        if (is_open != 0) reached.push_back(next);
        is_open = 0;
      }
    }
  }
  return pieces;
}

void cells_of_mesh_hang_together(const Scenario& s, Violations& out) {
  constexpr double kMostCells = 1e7;  // more than any machine has memory for a factor of
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::mesh || !p->mesh || !(p->cell_size_m > 0.0)) return;
  double cells = 1.0;
  for (const double size : p->size_m) cells *= std::max(2.0, size / p->cell_size_m);
  const TrueShape shape(*p);
  if (!(cells < kMostCells) || shape.solid() == nullptr) return;
  const int pieces = pieces_of_cells(*p, shape);
  if (pieces == 1) return;
  out.push_back({"product.cell_size_m", spelled(p->cell_size_m),
                 pieces == 0 ? "must be smaller: no cell lies in the product"
                             : "must be smaller: the product's cells fall into " + std::to_string(pieces) +
                                   " pieces that share no face"});
}

void cells_hang_together(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::revolution) return;
  const bool divides =
      std::ranges::all_of(p->size_m, [&](double size) { return size > 0.0 && p->cell_size_m > size / 1e6; });
  const TrueShape shape(*p);
  if (!divides || shape.solid() == nullptr) return;
  const auto axis = static_cast<std::size_t>(p->axis);
  const int layers = lattice_cell_count(*p)[axis];
  int first = 0, last = layers - 1;
  while (first < layers && !has_cells(*p, shape, axis, first)) ++first;
  while (last > first && !has_cells(*p, shape, axis, last)) --last;
  for (int layer = first; layer <= last; ++layer) {
    if (has_cells(*p, shape, axis, layer)) continue;
    out.push_back({"product.cell_size_m", spelled(p->cell_size_m),
                   "must be smaller than the product's waist: a layer of cells there holds none"});
    return;
  }
  if (first == layers) {
    out.push_back(
        {"product.cell_size_m", spelled(p->cell_size_m), "must be smaller: no cell lies in the product"});
  }
}

}  // namespace

std::vector<Rule> shape_rules() {
  return {
      {{kHeight, kRadius, "product.shape"},
       "rises from end to end, 4 to 1000 points; required with shape = \"revolution\"",
       profile_is_sound,
       "as many as heights; 0 at both ends, > 0 between them"},
      {{"product.size_m", "product.shape", "product.axis"},
       "a solid of revolution has two equal ones across its axis",
       revolution_is_round},
      {{"product.cell_size_m", "product.size_m", "product.shape", "product.axis", kHeight, kRadius},
       "leaves no layer of a solid of revolution empty",
       cells_hang_together},
      {{"product.shape"}, "\"mesh\" needs mesh_file and mesh_unit", mesh_is_there},
      {{"product.cell_size_m", "product.size_m", "product.shape"},
       "leaves the cells of a mesh in one piece",
       cells_of_mesh_hang_together},
  };
}

}  // namespace unbruised
