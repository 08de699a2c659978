#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr double kMostCells = 1e6;

const LatticeParameters* lattice_of(const Scenario& s) { return std::get_if<LatticeParameters>(&s.product); }

void mass_given_once(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->mass_kg.has_value() != p->density_kg_m3.has_value()) return;
  out.push_back({"product.mass_kg", p->mass_kg ? spelled(*p->mass_kg) : "",
                 p->mass_kg ? "excludes product.density_kg_m3; give one of them"
                            : "missing; give mass_kg or density_kg_m3"});
}

void plasticity_complete(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr) return;
  add_unpaired(out, "product.", "tangent_modulus_Pa", p->tangent_modulus_Pa, "yield_stress_Pa",
               p->yield_stress_Pa);
}

void damping_given_once(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || !p->relaxation_time_s || !p->loss_ratio) return;
  out.push_back({"product.relaxation_time_s", spelled(*p->relaxation_time_s),
                 "excludes product.loss_ratio; give one of them"});
}

void loss_complete(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr) return;
  add_unpaired(out, "product.", "at_frequency_Hz", p->at_frequency_Hz, "loss_ratio", p->loss_ratio);
}

double smallest_extent_m(const LatticeParameters& p) {
  return *std::min_element(p.size_m.begin(), p.size_m.end());
}

bool too_coarse(const LatticeParameters& p) {
  return p.cell_size_m > 0.5 * smallest_extent_m(p) * (1.0 + 1e-12);  // 0.05 / 2 and 0.025 may differ in a bit
}

bool too_many(const LatticeParameters& p) {
  double cells = 1.0;
  for (const double extent : p.size_m) cells *= std::max(2.0, std::round(extent / p.cell_size_m));
  return !(cells <= kMostCells);
}

void cells_fit(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr) return;
  if (too_coarse(*p)) {
    out.push_back(
        {"product.cell_size_m", spelled(p->cell_size_m),
         "must be <= half the smallest extent of product.size_m = " + spelled(0.5 * smallest_extent_m(*p))});
  } else if (too_many(*p)) {
    out.push_back({"product.cell_size_m", spelled(p->cell_size_m), "makes more than 1,000,000 cells"});
  }
}

/// Three digits, rounded down.
double rounded_down(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), std::floor(value / unit) * unit,
                                 std::chars_format::scientific, 2);
  double rounded = value;
  std::from_chars(text.data(), end.ptr, rounded);
  return rounded;
}

/// The coarsest cell below the wanted one that is near enough to a cube; none where none of a hundred is.
std::optional<double> fitting_cell_m(LatticeParameters p) {
  const double extent = smallest_extent_m(p);
  const double count = std::max(2.0, std::round(extent / p.cell_size_m));
  for (double n = count; n < count + 100.0; n += 1.0) {
    p.cell_size_m = rounded_down(extent / n);
    if (!too_many(p) && lattice_is_admissible(lattice_cell_extent_m(p))) return p.cell_size_m;
  }
  return std::nullopt;
}

void cells_near_cubes(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || too_coarse(*p) || too_many(*p)) return;
  const auto cell = lattice_cell_extent_m(*p);
  if (lattice_is_admissible(cell)) return;
  const auto better = fitting_cell_m(*p);
  out.push_back({"product.cell_size_m", spelled(p->cell_size_m),
                 "divides the product into cells of " + for_people(cell[0]) + " x " + for_people(cell[1]) + " x " +
                     for_people(cell[2]) + " m, whose sides differ by more than 22 %" +
                     (better ? "; " + spelled(*better) + " divides it well" : "")});
}

void sphere_is_round(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::sphere) return;
  if (p->size_m[0] == p->size_m[1] && p->size_m[1] == p->size_m[2]) return;
  out.push_back({"product.size_m", "", "a sphere has three equal extents; else write shape = \"ellipsoid\""});
}

/// "must be 0 with a gripper: ...", for each of these numbers that is not.
void must_not_begin(const Scenario& s, std::string_view field, std::span<const double> values, Violations& out) {
  if (!has_gripper(s)) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0.0) continue;
    const std::string place = values.size() > 1 ? "[" + std::to_string(i) + "]" : "";
    out.push_back({std::string(field) + place, spelled(values[i]),
                   "must be 0 with a gripper: a product that is to be gripped stands still at the start"});
  }
}

void spins_freely(const Scenario& s, Violations& out) {
  if (const auto* p = lattice_of(s)) must_not_begin(s, "product.initial_spin_rad_s", p->initial_spin_rad_s, out);
}
void turned_freely(const Scenario& s, Violations& out) {
  if (const auto* p = lattice_of(s))
    must_not_begin(s, "product.initial_rotation_rad", p->initial_rotation_rad, out);
}
void high_freely(const Scenario& s, Violations& out) {
  if (const auto* p = lattice_of(s)) must_not_begin(s, "product.initial_height_m", {&p->initial_height_m, 1}, out);
}

void height_above_support(const Scenario& s, Violations& out) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->initial_height_m == 0.0 || s.cell.support) return;
  out.push_back({"product.initial_height_m", spelled(p->initial_height_m),
                 "needs cell.support = true: it is measured from the support"});
}

}  // namespace

std::vector<Rule> lattice_rules() {
  return {
      {{"product.size_m", "product.shape"}, "a sphere has three equal ones", sphere_is_round},
      {{"product.cell_size_m", "product.size_m"},
       "<= half the smallest extent; at most 1,000,000 cells",
       cells_fit},
      {{"product.cell_size_m", "product.size_m"},
       "cells near cubes: sides differ by 22 % at most",
       cells_near_cubes},
      {{"product.mass_kg", "product.density_kg_m3"},
       "exactly one of mass_kg and density_kg_m3",
       mass_given_once,
       "exactly one of mass_kg and density_kg_m3"},
      {{"product.tangent_modulus_Pa", "product.yield_stress_Pa"},
       "goes with yield_stress_Pa",
       plasticity_complete,
       "goes with tangent_modulus_Pa"},
      bounded("product.tangent_modulus_Pa", "< youngs_modulus_Pa", "product.youngs_modulus_Pa", Strictness::below),
      {{"product.relaxation_time_s", "product.loss_ratio"}, "not together with loss_ratio", damping_given_once},
      {{"product.at_frequency_Hz", "product.loss_ratio"},
       "goes with loss_ratio",
       loss_complete,
       "goes with at_frequency_Hz"},
      {{"product.initial_spin_rad_s", "gripper"}, "0 with a gripper", spins_freely},
      {{"product.initial_rotation_rad", "gripper"}, "0 with a gripper", turned_freely},
      {{"product.initial_height_m", "gripper"}, "0 with a gripper", high_freely},
      {{"product.initial_height_m", "cell.support"}, "needs cell.support = true", height_above_support},
  };
}

}  // namespace unbruised
