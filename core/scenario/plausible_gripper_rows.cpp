#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/plausible_parts.hpp"

namespace unbruised::plausible {
namespace {

void stroke_of_opening(const Scenario& s, const MeasureVisit& visit) {
  const auto stroke = finger_stroke_m(s.gripper), opening = opening_m(s.gripper);
  if (!stroke || !opening) return;
  visit({"gripper.stroke_m", *stroke, 2.0 * *stroke / *opening});
}

}  // namespace

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
      plain("gripper.pad_modulus_Pa", "Young's modulus of the pads", "Pa", 1e3, 2.5e11, kStress,
            "foam of 2 to 11 kPa, Ecoflex 0.07 MPa, Dragon Skin 0.15 to 0.6 MPa (Smooth-On), rubber 1 to 10 MPa, "
            "steel 210 GPa"),
      plain("gripper.pad_poisson_ratio", "Poisson's ratio of the pads", "", 0.0, 0.4999, {},
            "silicone and rubber 0.47 to 0.4999, closed foam 0.3, open foam 0"),
      plain("gripper.pad_edge_radius_m", "radius of the pads' edges", "m", 0.0, 0.02, kLength,
            "sharp cuts to rounded tips"),
      plain("gripper.pad_relaxation_time_s", "relaxation time of the pads", "s", 0.0, 0.1, kTime,
            "silicone and rubber: loss factors of 0.05 to 0.5"),
      plain("gripper.pad.radius_m", "radius of a pad's face", "m", 2e-3, 2.0, kLength,
            "finger tips to shallow cradles"),
      plain("gripper.pad.half_angle_rad", "half angle of a groove", "rad", 0.3, 1.5707, kAngle,
            "prisms of 60 to 170 degrees"),
      plain("gripper.pad.cell_size_m", "cell of a pad", "m", 5e-4, 0.02, kLength,
            "two to ten cells through the thickness of a pad"),
      plain("gripper.pad.density_kg_m3", "density of a pad", "kg/m3", 15.0, 3000.0, {},
            "foam 20 to 200, silicone 1070 to 1200, filled rubber up to 2000"),
      plain("gripper.drive_gain_N_s_m", "gain of the drive", "N s/m", 1.0, 1e6, {},
            "grip force over approach speed"),
      plain("gripper.drive_viscous_N_s_m", "friction of the guide", "N s/m", 0.0, 1e3, {}, "lubricated slides"),
      plain("gripper.max_force_N", "largest drive force", "N", 0.2, 5e3, kForce, "data sheets of parallel jaws"),
      plain("gripper.min_force_N", "least drive force", "N", 0.0, 500.0, kForce, "data sheets of parallel jaws"),
      plain("gripper.max_speed_m_s", "largest finger speed", "m/s", 1e-3, 3.0, kSpeed,
            "data sheets of parallel jaws"),
      plain("gripper.force_accuracy", "accuracy of the force", "", 0.0, 0.5, kFraction,
            "electric grippers 5 to 30 % of the set force"),
      plain("gripper.force_rate_Hz", "rate of the force measurement", "Hz", 10.0, 1e5, {},
            "strain gauges 0.1 to 10 kHz"),
      plain("gripper.range.maximum_m", "largest range", "m", 1e-3, 2.0, kLength,
            "proximity sensors in finger tips 10 to 200 mm"),
      plain("gripper.range.offset_m", "offset of a ray", "m", 0.0, 0.3, kLength, "within or beside the pad"),
      plain("gripper.range.depth_m", "depth of a range sensor", "m", 0.0, 0.1, kLength, "within the finger"),
      plain("gripper.range.rate_Hz", "rate of a range sensor", "Hz", 5.0, 1e5, {},
            "time of flight 10 to 100 Hz, triangulation up to 10 kHz"),
      plain("gripper.range.resolution_m", "resolution of a range sensor", "m", 0.0, 5e-3, kLength,
            "time of flight 1 mm, triangulation 1 um"),
      plain("gripper.range.noise_m", "noise of a range sensor", "m", 0.0, 0.01, kLength,
            "time of flight 1 to 3 mm, triangulation 1 to 50 um"),
      plain("gripper.lock_stiffness_N_m", "stiffness of a lock", "N/m", 1e3, 1e9, {},
            "trapped air 1e3 to 1e5, brakes behind gears 1e5 to 1e7 N/m"),
      plain("gripper.payload_kg", "payload of a gripper", "kg", 5e-3, 200.0, kMass,
            "data sheets of parallel jaws"),
      plain("gripper.jaw_moment_N_m", "moment on a jaw", "N m", 0.05, 2e3, {}, "data sheets of parallel jaws"),
      plain("gripper.finger_length_m", "length of a finger", "m", 5e-3, 0.5, kLength,
            "data sheets of parallel jaws"),
      plain("gripper.safety_factor", "safety factor of a maker", "", 1.0, 10.0, {}, "makers name 1.5 to 4"),
      plain("gripper.finger[].angle_rad", "angle of a finger", "rad", -6.2832, 6.2832, kAngle, "a whole turn"),
      plain("gripper.finger[].offset_m", "offset of a finger", "m", 0.0, 0.3, kLength, "openings of grippers"),
      plain("gripper.force_step_N", "step of the force", "N", 0.0, 50.0, kForce, "data sheets of parallel jaws"),
  };
}

}  // namespace unbruised::plausible
