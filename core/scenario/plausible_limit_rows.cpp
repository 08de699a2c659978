#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/plausible_parts.hpp"

namespace unbruised::plausible {
namespace {

void bruised_share(const Scenario& s, const MeasureVisit& visit) {
  if (!s.limits.bruised_volume_m3) return;
  visit({"limits.bruised_volume_m3", *s.limits.bruised_volume_m3,
         *s.limits.bruised_volume_m3 / true_volume_m3(lattice_of(s))});
}

void set_share(const Scenario& s, const MeasureVisit& visit) {
  if (!s.limits.permanent_set_m) return;
  visit(
      {"limits.permanent_set_m", *s.limits.permanent_set_m, *s.limits.permanent_set_m / lattice_of(s).size_m[0]});
}

}  // namespace

Rows limit_rows() {
  return {
      {"permanent set over the width of the product",
       "",
       0.0,
       0.3,
       {"limits.permanent_set_m", "product.size_m"},
       kLength,
       "",
       "marks of 0.05 to 2 mm are seen",
       set_share},
      plain("limits.plastic_strain", "plastic strain", "", 0.0, 1.0, kFraction,
            "no mark on kiwi below 0.05 (Zhu Yue)"),
      {"bruised share of the product",
       "",
       0.0,
       0.5,
       {"limits.bruised_volume_m3", "product.size_m", "product.shape", "product.profile_height",
        "product.profile_radius", "product.exponents"},
       kVolume,
       "",
       "strawberry 46 to 135 mm3 of some 15,000 (Aliasgarian Najafabadi et al.)",
       bruised_share},
      plain("limits.peak_pressure_Pa", "pressure", "Pa", 100.0, 1e9, kStress, "apple bruises from 0.1 MPa"),
      plain("limits.absorbed_energy_J", "absorbed energy", "J", 0.0, 20.0, kEnergy,
            "apple 0.08 J (Shen and Shan), tomato bursts at 0.3 J"),
      plain("limits.finger_force_N", "force limit", "N", 0.02, 1e3, kForce,
            "tofu 2 N, kiwi 1 to 8 N, egg 27 to 45 N, apple 58 N"),
      plain("limits.contact_yield_ratio", "contact yield ratio", "", 0.05, 10.0, kFraction,
            "1: first yield (Johnson, Contact Mechanics)"),
      plain("limits.slip_m", "slip", "m", 1e-6, 0.05, kLength, "from a hundredth of a millimetre to a pad"),
      plain("limits.slip_rad", "angle of slip", "rad", 1e-4, 1.6, kAngle,
            "from what can be seen to a quarter turn"),
      plain("simulation.time_step_s", "time step", "s", 1e-7, 1e-2, kTime, "impacts of fingers last 5 to 50 ms"),
      plain("simulation.duration_s", "length of the run", "s", 0.0, 3600.0, kTime, "an hour"),
      plain("simulation.pressure_patch_m", "pressure patch", "m", 1e-4, 0.1, kLength, "a finger tip is 10 mm"),
      plain("simulation.max_strain", "bound of the strain", "", 1e-3, 2.0, kFraction,
            "the model is linear: beyond 0.3 it is not to be trusted"),
      plain("simulation.max_rotation_rad", "bound of the rotation", "rad", 1e-3, 1.6, kAngle,
            "the model follows small rotations only"),
  };
}

}  // namespace unbruised::plausible
