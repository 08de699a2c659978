#include <algorithm>
#include <cmath>

#include "core/scenario/attitude.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/true_shape.hpp"
#include "core/scenario/vectors.hpp"
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
    if (dot(n, n) > 0.0) continue;
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

/// Where a solid stands at the start.
struct Standing {
  TrueShape shape;
  Attitude back;  ///< from x, y, z to its own axes
  std::array<double, 3> center_m{};

  explicit Standing(const LatticeParameters& product)
      : shape(product), back(inverse(attitude_of(product.initial_rotation_rad))) {
    center_m[2] = product.initial_height_m + reach_m({0.0, 0.0, -1.0});
  }
  [[nodiscard]] double reach_m(const std::array<double, 3>& direction) const {
    return shape.reach_m(turned(back, direction));
  }
  [[nodiscard]] double reach_to_both_m(const std::array<double, 3>& d) const {
    return std::max(reach_m(d), reach_m({-d[0], -d[1], -d[2]}));
  }
};

/// Does the product stand partly before and partly behind a surface?
bool stands_in(const CellSurfaceParameters& surface, const Standing& product) {
  constexpr double kRounding_m = 1e-9;
  const auto axes = surface_axes(surface);
  std::array<double, 3> way{};
  for (std::size_t d = 0; d < 3; ++d) way[d] = product.center_m[d] - surface.center_m[d];
  for (std::size_t t = 0; t < 2 && surface.size_m; ++t) {
    if (std::abs(dot(axes[t], way)) >= 0.5 * (*surface.size_m)[t] + product.reach_to_both_m(axes[t])) return false;
  }
  const double before_m = dot(axes[2], way);
  const std::array<double, 3> behind = {-axes[2][0], -axes[2][1], -axes[2][2]};
  return before_m < product.reach_m(behind) - kRounding_m && -before_m < product.reach_m(axes[2]) - kRounding_m;
}

void surfaces_clear_of_product(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr) return;
  const Standing product(*p);
  for (std::size_t i = 0; i < s.cell.surface.size(); ++i) {
    const auto& n = s.cell.surface[i].normal;
    if (dot(n, n) == 0.0 || !stands_in(s.cell.surface[i], product)) continue;
    out.push_back({path_of(i, "center_m"), "",
                   "puts the surface into the product, which stands on both sides of it at the start"});
  }
}

/// What the product meets the cell with, where it is asked for.
void set_serves(const Scenario& s, Violations& out) {
  if (lists_fingers(s) && s.simulation.contact_set == ContactSet::six_sides) {
    out.push_back({"simulation.contact_set", "six sides",
                   "does not serve [[gripper.finger]], which meet the product with any place of it"});
  }
  if (s.simulation.contact_set != ContactSet::pads_and_support) return;
  if (!std::holds_alternative<LatticeParameters>(s.product)) return;
  const auto refuse = [&out](const std::string& why) {
    out.push_back({"simulation.contact_set", "pads and support", "does not serve " + why});
  };
  if (!s.cell.surface.empty()) refuse("[[cell.surface]], which is met with any place of the product");
  if (starts_in_the_air(s.product) && s.cell.support) refuse("a product that falls or turns onto its support");
  if (has_gripper(s) && lands_otherwise(s)) refuse("a product that is put down on another side");
  if (lists_fingers(s)) refuse("[[gripper.finger]], which meet the product with any place of it");
}

void target_is_there(const Scenario& s, Violations& out) {
  if (!has_gripper(s) || s.cell.target_plane || !s.cell.surface.empty()) return;
  out.push_back(
      {"cell.target_plane", "false", "needs [[cell.surface]]: else there is nothing to put the product on"});
}

}  // namespace

std::vector<Rule> surface_rules() {
  return {
      {{"cell.surface"}, "at most 8", few_surfaces},
      {{"cell.surface", "product.kind"}, "needs a product with a shape", surfaces_of_a_solid},
      {{"cell.surface[].normal"}, "not zero", normals_point_somewhere},
      {{"cell.surface[].center_m", "cell.surface[].normal", "cell.surface[].size_m", "product.shape",
        "product.axis", "product.profile_height", "product.profile_radius", "product.exponents", "product.size_m",
        "product.initial_rotation_rad", "product.initial_height_m"},
       "clear of the product at the start",
       surfaces_clear_of_product},
      {{"cell.surface[].path_m", "cell.surface[].path_time_s"},
       "as many places as path_time_s has times, which rise",
       paths_have_times,
       "rises; as many times as path_m has places"},
      {{"simulation.contact_set", "cell.surface", "cell.support", "gripper", "product.initial_rotation_rad",
        "product.initial_spin_rad_s", "product.initial_height_m", "strategy.waypoint[].rotation_rad",
        "strategy.waypoint[].quaternion", "gripper.finger"},
       "\"pads and support\" only where the product stays upright and [[cell.surface]] lists nothing",
       set_serves},
      {{"cell.target_plane", "cell.surface", "gripper"}, "false needs [[cell.surface]]", target_is_there},
  };
}

}  // namespace unbruised
