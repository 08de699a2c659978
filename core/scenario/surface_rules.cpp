#include <algorithm>
#include <cmath>

#include "core/scenario/contact_set.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

std::string path_of(std::size_t surface, std::string_view leaf) {
  return "cell.surface[" + std::to_string(surface) + "]." + std::string(leaf);
}

void few_surfaces(const Scenario& s, Violations& out) {
  if (s.cell.surface.size() <= kMostCellSurfaces) return;
  out.push_back({"cell.surface", std::to_string(s.cell.surface.size()),
                 "must be " + std::to_string(kMostCellSurfaces) + " tables at most"});
}

void surfaces_of_a_solid(const Scenario& s, Violations& out) {
  if (s.cell.surface.empty() || std::holds_alternative<LatticeParameters>(s.product)) return;
  out.push_back(
      {"cell.surface", "", "needs a product with a shape: of a network of particles only the support is touched"});
}

void normals_point_somewhere(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.cell.surface.size(); ++i) {
    const auto& n = s.cell.surface[i].normal;
    if (n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > 0.0) continue;
    out.push_back({path_of(i, "normal"), "[0.0, 0.0, 0.0]",
                   "must not be zero: it points to the side on which the surface is touched"});
  }
}

void paths_have_times(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.cell.surface.size(); ++i) {
    const CellSurfaceParameters& surface = s.cell.surface[i];
    if (surface.path_time_s.size() != surface.path_m.size() || surface.path_m.size() == 1) {
      out.push_back({path_of(i, "path_m"), std::to_string(surface.path_m.size()) + " places",
                     "must have as many places as path_time_s has times, " +
                         std::to_string(surface.path_time_s.size()) + ", and two at least"});
    }
    if (!std::is_sorted(surface.path_time_s.begin(), surface.path_time_s.end(), std::less_equal<>())) {
      out.push_back({path_of(i, "path_time_s"), "", "must rise from place to place"});
    }
  }
}

/// What the product meets the cell with, where it is asked for.
void set_serves(const Scenario& s, Violations& out) {
  if (s.simulation.contact_set != ContactSet::pads_and_support) return;
  if (!std::holds_alternative<LatticeParameters>(s.product)) return;
  const auto refuse = [&out](const std::string& why) {
    out.push_back({"simulation.contact_set", "pads and support", "does not serve " + why});
  };
  if (!s.cell.surface.empty()) refuse("[[cell.surface]], which is met with any place of the product");
  if (starts_in_the_air(s.product) && s.cell.support) refuse("a product that falls or turns onto its support");
}

}  // namespace

std::vector<Rule> surface_rules() {
  return {
      {{"cell.surface"}, "at most 8", few_surfaces},
      {{"cell.surface", "product.kind"}, "needs a product with a shape", surfaces_of_a_solid},
      {{"cell.surface[].normal"}, "not zero", normals_point_somewhere},
      {{"cell.surface[].path_m", "cell.surface[].path_time_s"},
       "as many places as path_time_s has times, which rise",
       paths_have_times,
       "rises; as many times as path_m has places"},
      {{"simulation.contact_set", "cell.surface", "cell.support", "product.initial_rotation_rad",
        "product.initial_spin_rad_s", "product.initial_height_m"},
       "\"pads and support\" only where the product stays upright and [[cell.surface]] lists nothing",
       set_serves},
  };
}

}  // namespace unbruised
