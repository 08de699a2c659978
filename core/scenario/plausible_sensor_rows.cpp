#include "core/scenario/plausible_parts.hpp"

namespace unbruised::plausible {

Rows sensor_rows() {
  const Slips stiffness = {{1e-3, "N/mm taken for N/m"}, {1e-6, "N/um taken for N/m"}};
  const Slips torque = {{1e3, "N mm taken for N m"}};
  return {
      plain("sensor.element_stiffness_N_m", "stiffness of a sensor's element", "N/m", 1e4, 1e10, stiffness,
            "six-axis sensors 1e6 to 1e9 N/m"),
      plain("sensor.element_radius_m", "radius of a sensor", "m", 2e-3, 0.2, kLength,
            "six-axis sensors 9 to 330 mm in diameter"),
      plain("sensor.element_count", "elements of a sensor", "", 3.0, 16.0, {}, "three or four beams, hexapods"),
      plain("sensor.ring_stiffness_N_m", "stiffness of a sensor's element", "N/m", 0.0, 1e10, stiffness,
            "as element_stiffness_N_m; 0: released"),
      plain("sensor.stiffness_N_m", "stiffness of a sensor", "N/m", 1e4, 1e10, stiffness,
            "six-axis sensors 1e6 to 1e9 N/m"),
      plain("sensor.stiffness_N_m_rad", "stiffness of a sensor", "N m/rad", 10.0, 1e7, {},
            "six-axis sensors 1e3 to 1e6 N m/rad"),
      plain("sensor.stiffness_matrix", "stiffness of a sensor", "", 0.0, 1e10, {}, "as the datasheet's"),
      plain("sensor.damping_ratio", "damping ratio of a sensor", "", 0.0, 0.3, kFraction,
            "bolted steel 0.005 to 0.05, oil-damped 0.3"),
      plain("sensor.mass_kg", "mass that a sensor carries", "kg", 1e-3, 50.0, kMass, "plates to large grippers"),
      plain("sensor.center_of_mass_m", "lever of what a sensor carries", "m", 0.0, 1.0, kLength, "grippers"),
      plain("sensor.inertia_kg_m2", "inertia of what a sensor carries", "kg m2", 1e-8, 10.0,
            {{1e3, "g m2 taken for kg m2"}, {1e6, "kg mm2 taken for kg m2"}}, "plates to large grippers"),
      plain("sensor.position_m", "place of a sensor", "m", 0.0, 1.0, kLength, "grippers are 0.05 to 0.4 m long"),
      plain("sensor.report_at_m", "point of report", "m", 0.0, 1.0, kLength, "tool centre points"),
      plain("sensor.bandwidth_Hz", "bandwidth of a sensor", "Hz", 1.0, 1e5, {}, "filters of 4 Hz to 8 kHz"),
      plain("sensor.rate_Hz", "rate of a sensor", "Hz", 10.0, 1e5, {}, "fieldbuses 100 Hz to 30 kHz"),
      plain("sensor.resolution_N", "resolution of a sensor", "N", 0.0, 1.0, kForce,
            "1/400 to 1/100 N and coarser"),
      plain("sensor.resolution_N_m", "resolution of a sensor", "N m", 0.0, 0.1, torque, "1/64000 to 1/20 N m"),
      plain("sensor.range_N", "range of a sensor", "N", 1.0, 1e5, kForce, "12 N to 50 kN"),
      plain("sensor.range_N_m", "range of a sensor", "N m", 0.01, 1e4, torque, "0.05 N m to 6 kN m"),
      plain("sensor.noise_N", "noise of a sensor", "N", 0.0, 5.0, kForce, "0.002 to 1 N"),
      plain("sensor.noise_N_m", "noise of a sensor", "N m", 0.0, 0.5, torque, "1e-5 to 0.05 N m"),
  };
}

}  // namespace unbruised::plausible
