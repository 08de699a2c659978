#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/scenario/gripper.hpp"
#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/number_fields.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/plausible.hpp"

namespace unbruised {
namespace {

using Slips = std::vector<UnitSlip>;
using Rows = std::vector<PlausibleRow>;

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr double kStandardGravity_m_s2 = 9.80665;

const Slips kLength = {{1e3, "millimetres taken for metres"}, {1e2, "centimetres taken for metres"}};
const Slips kMass = {{1e3, "grams taken for kilograms"}};
const Slips kStress = {{1e-6, "MPa taken for Pa"}, {1e-3, "kPa taken for Pa"}, {1e-9, "GPa taken for Pa"}};
const Slips kForce = {{1e3, "millinewtons taken for newtons"}, {102.0, "grams of force taken for newtons"}};
const Slips kSpeed = {{1e3, "mm/s taken for m/s"}, {60.0, "m/min taken for m/s"}};
const Slips kAcceleration = {{1e3, "mm/s2 taken for m/s2"}, {1.0 / 9.80665, "multiples of g taken for m/s2"}};
const Slips kTime = {{1e3, "milliseconds taken for seconds"}};
const Slips kFraction = {{1e2, "per cent taken for a fraction"}};
const Slips kAngle = {{57.29577951308232, "degrees taken for radians"}};
const Slips kEnergy = {{1e3, "millijoules taken for joules"}};
const Slips kVolume = {{1e9, "mm3 taken for m3"}, {1e6, "cm3 taken for m3"}};

/// A row about the numbers of one field, by their size.
PlausibleRow plain(std::string_view path, std::string_view quantity, std::string_view unit, double low,
                   double high, Slips slips, std::string_view source) {
  const NumberField* field = find_number_field(path);
  return {quantity,
          unit,
          low,
          high,
          {path},
          std::move(slips),
          "",
          source,
          [=](const Scenario& s, const MeasureVisit& visit) {
            for_each_number(*field, s, [&](const NumberPlace& place, double value) {
              visit({path_of(path, place), value, std::abs(value)});
            });
          }};
}

const LatticeParameters& lattice_of(const Scenario& s) { return std::get<LatticeParameters>(s.product); }

// -- Product. ----------------------------------------------------------------------------------------------

void density_from_mass(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (p.mass_kg) visit({"product.mass_kg", *p.mass_kg, *p.mass_kg / true_volume_m3(p)});
}

void cells_across(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  const double smallest = *std::min_element(p.size_m.begin(), p.size_m.end());
  visit({"product.cell_size_m", p.cell_size_m, std::max(2.0, std::round(smallest / p.cell_size_m))});
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

Rows product_rows() {
  Slips grams = kMass;
  grams.push_back({8.0, "radii taken for full extents", false});
  return {
      plain("product.size_m", "product extent", "m", 3e-3, 0.5, kLength, "from a currant to a melon"),
      {"density",
       "kg/m3",
       100.0,
       3000.0,
       {"product.mass_kg", "product.size_m", "product.shape"},
       grams,
       "",
       "bread 200, apple 850 (Mohsenin), kiwi 1022 (Du et al. 2019), silicone 1070 to 1500, glass 2500 kg/m3",
       density_from_mass},
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
      plain("product.friction", "friction coefficient", "", 0.05, 2.0, kFraction,
            "fruit on rubber and steel 0.3 to 0.8 (Puchalski 2001), pear on silicone 1.13; wet skin 0.1"),
      plain("product.initial_velocity_m_s", "speed of the product", "m/s", 0.0, 10.0, kSpeed, "a fall from 5 m"),
      plain("product.initial_spin_rad_s", "spin of the product", "rad/s", 0.0, 60.0, kAngle, "thrown fruit"),
  };
}

// -- Gripper. ----------------------------------------------------------------------------------------------

void stroke_of_opening(const Scenario& s, const MeasureVisit& visit) {
  const auto stroke = finger_stroke_m(s.gripper), opening = opening_m(s.gripper);
  if (!stroke || !opening) return;
  visit({"gripper.stroke_m", *stroke, 2.0 * *stroke / *opening});
}

Rows gripper_rows() {
  return {
      plain("gripper.finger_mass_kg", "finger mass", "kg", 2e-3, 5.0, kMass,
            "from soft pneumatic fingers to heavy jaws with their slides"),
      plain("gripper.stroke_m", "stroke of a finger", "m", 1e-3, 0.3, kLength, "data sheets of parallel jaws"),
      plain("gripper.opening_m", "opening", "m", 2e-3, 0.6, kLength, "data sheets of parallel jaws"),
      {"stroke over half the opening",
       "",
       0.0,
       1.0,
       {"gripper.stroke_m", "gripper.opening_m"},
       {{2.0, "the stroke of both fingers together taken for that of one"}},
       "the pads would pass each other",
       "geometry",
       stroke_of_opening},
      plain("gripper.pad_size_m", "pad side", "m", 2e-3, 0.3, kLength, "finger tips of 5 mm to plates of 20 cm"),
      plain("gripper.pad_thickness_m", "pad layer", "m", 5e-5, 0.05, kLength,
            "coatings of 0.1 mm to foam of 3 cm"),
      plain("gripper.pad_modulus_Pa", "Young's modulus of the pads", "Pa", 5e3, 2.5e11, kStress,
            "Ecoflex 0.07 MPa, Dragon Skin 0.15 to 0.6 MPa (Smooth-On), rubber 1 to 10 MPa, steel 210 GPa"),
      plain("gripper.pad_poisson_ratio", "Poisson's ratio of the pads", "", 0.0, 0.4999, {},
            "silicone and rubber 0.47 to 0.4999, closed foam 0.3, open foam 0"),
      plain("gripper.pad_edge_radius_m", "radius of the pads' edges", "m", 0.0, 0.02, kLength,
            "sharp cuts to rounded tips"),
      plain("gripper.pad_relaxation_time_s", "relaxation time of the pads", "s", 0.0, 0.1, kTime,
            "silicone and rubber: loss factors of 0.05 to 0.5"),
      plain("gripper.drive_gain_N_s_m", "gain of the drive", "N s/m", 1.0, 1e6, {},
            "grip force over approach speed"),
      plain("gripper.drive_viscous_N_s_m", "friction of the guide", "N s/m", 0.0, 1e3, {}, "lubricated slides"),
      plain("gripper.max_force_N", "largest drive force", "N", 0.2, 5e3, kForce, "data sheets of parallel jaws"),
      plain("gripper.min_force_N", "least drive force", "N", 0.0, 500.0, kForce, "data sheets of parallel jaws"),
      plain("gripper.max_speed_m_s", "largest finger speed", "m/s", 1e-3, 3.0, kSpeed,
            "data sheets of parallel jaws"),
      plain("gripper.force_accuracy", "accuracy of the force", "", 0.0, 0.5, kFraction,
            "electric grippers 5 to 30 % of the set force"),
      plain("gripper.force_step_N", "step of the force", "N", 0.0, 50.0, kForce, "data sheets of parallel jaws"),
  };
}

// -- Cell. -------------------------------------------------------------------------------------------------

void gravity_down(const Scenario& s, const MeasureVisit& visit) {
  visit({"cell.gravity_m_s2[2]", s.cell.gravity_m_s2[2], -s.cell.gravity_m_s2[2]});
}

/// Height of the pads that faces the product; negative: the air between them.
void pad_overlap(const Scenario& s, const MeasureVisit& visit) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) return;
  const double half = 0.5 * (lattice_of(s).size_m[2] + jaw->pad_size_m[1]);
  visit({"cell.grip_height_m", s.cell.grip_height_m, half - std::abs(s.cell.grip_height_m)});
}
void pad_overlap_across(const Scenario& s, const MeasureVisit& visit) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) return;
  const double half = 0.5 * (lattice_of(s).size_m[1] + jaw->pad_size_m[0]);
  visit({"cell.grip_offset_m", s.cell.grip_offset_m, half - std::abs(s.cell.grip_offset_m)});
}

void pad_lean(const Scenario& s, const MeasureVisit& visit) {
  const auto meeting = pad_meeting(s);
  if (!meeting) return;
  const bool across = std::abs(s.cell.grip_offset_m) > std::abs(s.cell.grip_height_m);
  visit({across ? "cell.grip_offset_m" : "cell.grip_height_m",
         across ? s.cell.grip_offset_m : s.cell.grip_height_m, meeting->lean_rad});
}

void approach_gap(const Scenario& s, const MeasureVisit& visit) {
  if (!has_gripper(s)) return;
  const double gap = approach_gap_m(s);
  const auto opening = opening_m(s.gripper);
  if (s.cell.approach_gap_m || !opening) return visit({"cell.approach_gap_m", gap, gap});
  visit({"gripper.opening_m", *opening, gap});
}

Rows cell_rows() {
  return {
      {"gravity downwards",
       "m/s2",
       0.0,
       15.0,
       {"cell.gravity_m_s2"},
       {{-1.0, "the sign forgotten"}, {1e3, "mm/s2 taken for m/s2"}},
       "",
       "0 in free fall, 9.81 on earth",
       gravity_down},
      plain("cell.support_friction", "friction coefficient of the support", "", 0.0, 2.0, kFraction,
            "as the product's; 0: a test without friction"),
      plain("cell.support_modulus_Pa", "Young's modulus of the support", "Pa", 5e3, 2.5e11, kStress,
            "foam 10 kPa, rubber 1 to 10 MPa, steel 210 GPa"),
      plain("cell.support_thickness_m", "layer of the support", "m", 5e-5, 0.1, kLength, "trays and mats"),
      plain("cell.support_relaxation_time_s", "relaxation time of the support", "s", 0.0, 0.1, kTime,
            "as that of the pads"),
      {"way of the pads to the product",
       "m",
       1e-4,
       0.15,
       {"cell.approach_gap_m", "gripper.opening_m", "product.size_m"},
       kLength,
       "",
       "half the opening of a large jaw",
       approach_gap},
      {"height of pad that faces the product",
       "m",
       0.0,
       kNoEnd,
       {"cell.grip_height_m", "product.size_m", "gripper.pad_size_m"},
       {},
       "the pads pass above or below the product",
       "geometry",
       pad_overlap},
      {"width of pad that faces the product",
       "m",
       0.0,
       kNoEnd,
       {"cell.grip_offset_m", "product.size_m", "gripper.pad_size_m"},
       {},
       "the pads pass beside the product",
       "geometry",
       pad_overlap_across},
      {"lean of the product's side where the pads meet it",
       "rad",
       0.0,
       0.3,
       {"cell.grip_height_m", "cell.grip_offset_m", "product.size_m", "gripper.pad_size_m", "product.shape"},
       {},
       "a pad's edge on a slope pushes along the grip axis only here, in truth across the slope too",
       "arc tangent of the least usual friction coefficient of fruit, 0.3",
       pad_lean},
      plain("cell.lift_height_m", "lift", "m", 0.0, 10.0, kLength, "cells of robots and gantries"),
      plain("cell.transfer_m", "way of the transfer", "m", 0.0, 10.0, kLength, "cells of robots and gantries"),
      plain("cell.place_height_m", "height of the target", "m", 0.0, 10.0, kLength,
            "cells of robots and gantries"),
  };
}

// -- Strategy. ---------------------------------------------------------------------------------------------

/// Grip force over the least that holds the product against gravity and the lift, m (g + a) / (2 friction).
void force_over_least(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (!has_gripper(s) || p.friction == 0.0) return;
  const auto& g = s.cell.gravity_m_s2;
  const double load_N = lattice_mass_kg(p) * (std::hypot(g[0], g[1], g[2]) + s.strategy.lift_acceleration_m_s2);
  visit({"strategy.grip_force_N", s.strategy.grip_force_N, 2.0 * p.friction * s.strategy.grip_force_N / load_N});
}

Rows strategy_rows() {
  const std::string_view robots = "robot arms 0.5 to 20, delta robots up to 150 m/s2";
  return {
      plain("strategy.approach_speed_m_s", "approach speed", "m/s", 1e-4, 2.0, kSpeed,
            "data sheets of parallel jaws"),
      plain("strategy.release_speed_m_s", "opening speed", "m/s", 1e-4, 2.0, kSpeed,
            "data sheets of parallel jaws"),
      {"grip force over the least that can hold",
       "",
       0.02,
       500.0,
       {"strategy.grip_force_N", "product.mass_kg", "product.density_kg_m3", "product.size_m", "product.friction",
        "strategy.lift_acceleration_m_s2", "cell.gravity_m_s2"},
       kForce,
       "",
       "a hand grips 1.1 to 1.4 times the least (doi 10.1177/17298814211018055); stiff parts bear more",
       force_over_least},
      plain("strategy.grip_ramp_s", "time of the force ramp", "s", 0.0, 10.0, kTime,
            "grippers close within a second"),
      plain("strategy.settle_s", "rest before the lift", "s", 0.0, 10.0, kTime, "cycles of a few seconds"),
      plain("strategy.place_settle_s", "rest before opening", "s", 0.0, 10.0, kTime, "cycles of a few seconds"),
      plain("strategy.hold_s", "rest after the lift", "s", 0.0, 120.0, kTime, "tests that hold for a minute"),
      plain("strategy.recover_s", "time of recovery", "s", 0.0, 60.0, kTime, "tests that wait for a minute"),
      plain("strategy.lift_acceleration_m_s2", "acceleration of the lift", "m/s2", 0.05, 150.0, kAcceleration,
            robots),
      plain("strategy.transfer_acceleration_m_s2", "acceleration of the transfer", "m/s2", 0.05, 150.0,
            kAcceleration, robots),
      plain("strategy.lower_acceleration_m_s2", "acceleration of the lowering", "m/s2", 0.05, 150.0, kAcceleration,
            robots),
      plain("strategy.speed_m_s", "speed of the path", "m/s", 0.01, 20.0, kSpeed,
            "robot arms 0.1 to 2, delta robots up to 10 m/s"),
      plain("strategy.release_height_m", "drop at the release", "m", 0.0, 10.0, kLength, "cells of robots"),
  };
}

// -- Limits and numerics. ----------------------------------------------------------------------------------

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
       {"limits.bruised_volume_m3", "product.size_m", "product.shape"},
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

}  // namespace

const std::vector<PlausibleRow>& plausible_rows() {
  static const Rows table = [] {
    Rows all;
    for (const Rows& part : {product_rows(), gripper_rows(), cell_rows(), strategy_rows(), limit_rows()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

}  // namespace unbruised
