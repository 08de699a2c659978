#include <algorithm>
#include <cmath>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/plausible_parts.hpp"
#include "core/scenario/profile_curve.hpp"

namespace unbruised::plausible {
namespace {

void density_from_mass(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (p.mass_kg) visit({"product.mass_kg", *p.mass_kg, *p.mass_kg / true_volume_m3(p)});
}

void cells_across(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  const double smallest = *std::min_element(p.size_m.begin(), p.size_m.end());
  visit({"product.cell_size_m", p.cell_size_m, std::max(2.0, std::round(smallest / p.cell_size_m))});
}

/// How much more slender the product is than its profile.
void stretched_profile(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (p.shape != Shape::revolution || profile_fault(p.profile_height, p.profile_radius)) return;
  const auto axis = static_cast<std::size_t>(p.axis);
  const double widest = *std::max_element(p.profile_radius.begin(), p.profile_radius.end());
  const double slender = (p.profile_height.back() - p.profile_height.front()) / (2.0 * widest);
  visit({"product.size_m", p.size_m[axis], p.size_m[axis] / p.size_m[(axis + 1) % 3] / slender});
}

void yield_strain(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (p.yield_stress_Pa)
    visit({"product.yield_stress_Pa", *p.yield_stress_Pa, *p.yield_stress_Pa / p.youngs_modulus_Pa});
}

void tangent_share(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (!p.tangent_modulus_Pa) return;
  visit({"product.tangent_modulus_Pa", *p.tangent_modulus_Pa, *p.tangent_modulus_Pa / p.youngs_modulus_Pa});
}

}  // namespace

Rows product_rows() {
  Slips grams = kMass;
  grams.push_back({8.0, "radii taken for full extents", false});
  return {
      plain("product.size_m", "product extent", "m", 3e-3, 0.5, kLength, "from a currant to a melon"),
      {"density",
       "kg/m3",
       100.0,
       3000.0,
       {"product.mass_kg", "product.size_m", "product.shape", "product.profile_height", "product.profile_radius",
        "product.exponents"},
       grams,
       "",
       "bread 200, apple 850 (Mohsenin), kiwi 1022 (Du et al. 2019), silicone 1070 to 1500, glass 2500 kg/m3",
       density_from_mass},
      {"stretch of the profile",
       "",
       0.8,
       1.25,
       {"product.profile_height", "product.profile_radius", "product.size_m", "product.shape", "product.axis"},
       {},
       "the solid is that much more slender than the points of its profile",
       "size_m says how large a solid of revolution is, whatever the unit of its profile",
       stretched_profile},
      plain("product.density_kg_m3", "density", "kg/m3", 100.0, 3000.0, {{1e-3, "g/cm3 taken for kg/m3"}},
            "as the density from mass and size"),
      {"cell count across the product",
       "",
       3.0,
       80.0,
       {"product.cell_size_m", "product.size_m"},
       {},
       "fewer do not show where it is pressed, more take hours",
       "docs/validation.md: contact on refined cells",
       cells_across},
      plain("product.youngs_modulus_Pa", "Young's modulus", "Pa", 500.0, 5e10, kStress,
            "jelly about 1 kPa, tofu 5 to 30 kPa, fruit flesh 0.3 to 5 MPa (Du et al. 2019; Zhu et al. 2024), egg "
            "shell 40 GPa"),
      {"yield strain",
       "",
       1e-3,
       0.6,
       {"product.yield_stress_Pa", "product.youngs_modulus_Pa"},
       kStress,
       "",
       "kiwi flesh 0.08 to 0.17 (Du et al. 2019; Zhu et al. 2024), carrot 0.18 (Xia et al. 2021), apple 0.2 to "
       "0.3",
       yield_strain},
      {"share of the modulus after yield",
       "",
       1e-3,
       0.95,
       {"product.tangent_modulus_Pa", "product.youngs_modulus_Pa"},
       kStress,
       "",
       "kiwi 0.28 to 0.59, carrot 0.75 (the same papers); near 0 is perfectly plastic",
       tangent_share},
      plain("product.relaxation_time_s", "relaxation time", "s", 0.0, 0.1, kTime,
            "loss factors of 0.05 to 0.5 at 5 to 100 Hz give 0.1 to 16 ms"),
      plain("product.loss_ratio", "loss factor", "", 0.0, 1.0, kFraction,
            "fruit flesh 0.05 to 0.5; 1: pure dashpot"),
      plain("product.at_frequency_Hz", "frequency of the loss factor", "Hz", 0.1, 5e3,
            {{1e-3, "kHz taken for Hz"}}, "from slow presses to ringing fruit, some hundred hertz"),
      plain("product.prony_modulus", "share of a modulus that fades", "", 1e-4, 1.0, kFraction,
            "carrot 0.22 and 0.23; all shares of a fruit 0.1 to 0.8 within a minute"),
      plain("product.prony_time_s", "time in which it fades", "s", 1e-4, 1e5, kTime,
            "carrot 1.7 and 26 s; apple, pear and potato 1 to 500 s"),
      plain("product.burgers_flow_time_s", "time of flow", "s", 1e-2, 1e7, kTime,
            "tomato, apple and cheese: minutes to hours; dough and gels: seconds"),
      plain("product.burgers_recovery_modulus", "modulus of what recovers", "", 1e-2, 1e3, kFraction,
            "what creeps and recovers is a hundredth of the answer at once to a hundred times as much"),
      plain("product.burgers_recovery_time_s", "time of recovery", "s", 1e-4, 1e5, kTime,
            "as of the branches of a relaxation"),
      plain("product.friction", "friction coefficient", "", 0.05, 2.0, kFraction,
            "fruit on rubber and steel 0.3 to 0.8 (Puchalski 2001), pear on silicone 1.13; wet skin 0.1"),
      plain("product.initial_velocity_m_s", "speed of the product", "m/s", 0.0, 10.0, kSpeed, "a fall from 5 m"),
      plain("product.initial_spin_rad_s", "spin of the product", "rad/s", 0.0, 60.0, kAngle, "thrown fruit"),
      plain("product.initial_rotation_rad", "attitude of the product", "rad", 0.0, 3.1416, kAngle,
            "half a turn reaches every attitude"),
      plain("product.initial_height_m", "height of the fall", "m", 0.0, 5.0, kLength,
            "packing lines to drop tests"),
  };
}

}  // namespace unbruised::plausible
