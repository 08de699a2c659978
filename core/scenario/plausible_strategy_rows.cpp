#include <cmath>

#include "core/scenario/gripper.hpp"
#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/plausible_parts.hpp"

namespace unbruised::plausible {
namespace {

/// Grip force over the least that holds the product against gravity and the lift, m (g + a) over
/// the friction of all fingers.
void force_over_least(const Scenario& s, const MeasureVisit& visit) {
  const LatticeParameters& p = lattice_of(s);
  if (!has_gripper(s) || p.friction == 0.0) return;
  const auto& g = s.cell.gravity_m_s2;
  const double load_N = lattice_mass_kg(p) * (std::hypot(g[0], g[1], g[2]) + s.strategy.lift_acceleration_m_s2);
  visit({"strategy.grip_force_N", s.strategy.grip_force_N,
         finger_count(s) * p.friction * s.strategy.grip_force_N / load_N});
}

}  // namespace

Rows strategy_rows() {
  const std::string_view robots = "robot arms 0.5 to 20, delta robots up to 150 m/s2";
  return {
      plain("strategy.approach_speed_m_s", "approach speed", "m/s", 1e-4, 2.0, kSpeed,
            "data sheets of parallel jaws"),
      plain("strategy.guard_range_m", "range of the guard", "m", 1e-4, 0.3, kLength, "openings of parallel jaws"),
      plain("strategy.guard_speed_m_s", "speed of the guard", "m/s", 0.0, 0.5, kSpeed,
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
      plain("strategy.jerk_m_s3", "jerk of the path", "m/s3", 1.0, 10000.0, kAcceleration,
            "robot arms 10 to 1,000"),
      plain("strategy.tilt_jerk_rad_s3", "jerk of turns", "rad/s3", 10.0, 30000.0, kAngle, "wrists of robots"),
      plain("strategy.tilt_rad", "tilt", "rad", -3.1416, 3.1416, kAngle, "up to half a turn"),
      plain("strategy.tilt_speed_rad_s", "speed of the tilt", "rad/s", 0.05, 20.0, kAngle, "wrists of robots"),
      plain("strategy.tilt_acceleration_rad_s2", "tilt acceleration", "rad/s2", 0.5, 300.0, kAngle,
            "wrists of robots"),
      plain("strategy.waypoint[].place_m", "place of a waypoint", "m", 0.0, 10.0, kLength, "cells of robots"),
      plain("strategy.waypoint[].rotation_rad", "rotation at a waypoint", "rad", 0.0, 3.1416, kAngle,
            "up to half a turn"),
      plain("strategy.waypoint[].via_m", "place on an arc", "m", 0.0, 10.0, kLength, "cells of robots"),
      plain("strategy.waypoint[].blend_m", "blend at a waypoint", "m", 0.0, 1.0, kLength, "zones of robots"),
      plain("strategy.waypoint[].speed_m_s", "speed to a waypoint", "m/s", 0.001, 20.0, kSpeed,
            "robot arms 0.1 to 2, delta robots up to 10 m/s"),
      plain("strategy.waypoint[].duration_s", "time to a waypoint", "s", 0.01, 120.0, kTime,
            "cycles of a few seconds"),
      plain("strategy.waypoint[].wait_s", "rest at a waypoint", "s", 0.0, 120.0, kTime,
            "tests that hold for a minute"),
      plain("strategy.pick_offset_m", "offset of the pick along the belt", "m", 0.0, 1.0, kLength,
            "cells of robots"),
      plain("strategy.tracking_lag_s", "lag of the tracking", "s", 0.0, 0.5, kTime, "cameras and encoders"),
      plain("strategy.stop_time_s", "time of the stop", "s", 0.0, 120.0, kTime, "within the cycle"),
      plain("strategy.release_height_m", "drop at the release", "m", 0.0, 10.0, kLength, "cells of robots"),
  };
}

}  // namespace unbruised::plausible
