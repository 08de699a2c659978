#pragma once

/// @file
/// cube512, the fixed scene of the benchmarks: a soft 5 cm cube of 8 x 8 x 8 particles is gripped with 5 N, lifted
/// 10 cm and held. Changing anything here ends the comparability of benchmarks/history.

#include <numbers>

#include "core/scenario/scenario.hpp"

namespace unbruised::benchmarks {

inline constexpr double kCube512GripForce_N = 5.0;  ///< per finger
inline constexpr double kCube512LiftStart_s = 0.2;
inline constexpr double kCube512LiftDuration_s = 0.5;
inline constexpr double kCube512HoldStart_s = 0.7;
inline constexpr double kCube512Duration_s = 1.0;
inline constexpr double kCube512LiftHeight_m = 0.1;
inline constexpr double kCube512Side_m = 0.05;
inline constexpr double kCube512YoungsModulus_Pa = 1e5;

/// The cube: 7 x 7 x 7 cells, E 100 kPa, nu 1/4, 1000 kg/m3 (0.125 kg), friction 0.6.
inline LatticeParameters cube512_product() {
  LatticeParameters cube;
  cube.shape = Shape::box;
  cube.size_m = {kCube512Side_m, kCube512Side_m, kCube512Side_m};
  cube.cell_size_m = kCube512Side_m / 7.0;
  cube.density_kg_m3 = 1000.0;
  cube.youngs_modulus_Pa = kCube512YoungsModulus_Pa;
  cube.poisson_ratio = 0.25;
  cube.relaxation_time_s = 2e-3;
  cube.friction = 0.6;
  return cube;
}

/// Two independent fingers of 0.1 kg with flat 5 x 5 cm pads, driven by the force alone: the wanted speed is out
/// of reach and the gain large, so the drive always gives its limit.
inline ParallelJawParameters cube512_gripper() {
  ParallelJawParameters gripper;
  gripper.finger_mass_kg = 0.1;
  gripper.pad_size_m = {0.05, 0.05};
  gripper.pad_thickness_m = 3e-3;
  gripper.pad_modulus_Pa = 0.4e6;
  gripper.drive_viscous_N_s_m = 20.0;
  gripper.drive_gain_N_s_m = 1e5;
  gripper.coupling = FingerCoupling::independent;
  return gripper;
}

/// The whole scene: force ramp 0 to 5 N in [0, 50 ms], rest to 0.2 s, minimum-jerk lift to 0.7 s, held to 1.0 s.
/// Expect 1.0 mm of compression (F L / (E A), and 0.03 mm in the pad layers), no slip and no drift.
inline Scenario cube512_scene(double time_step_s, double grip_force_N = kCube512GripForce_N) {
  Scenario scene;
  scene.product = cube512_product();
  scene.gripper = cube512_gripper();

  scene.cell.support_friction = 0.6;
  scene.cell.approach_gap_m = 0.5e-3;
  scene.cell.lift_height_m = kCube512LiftHeight_m;
  scene.cell.transfer_m = {0.0, 0.0};

  StrategyParameters& strategy = scene.strategy;
  strategy.approach_speed_m_s = 0.5;
  strategy.contact_force_N = 0.0;
  strategy.grip_force_N = grip_force_N;
  strategy.grip_ramp_s = 0.05;
  strategy.ramp_from_start = true;
  strategy.settle_s = kCube512LiftStart_s - strategy.grip_ramp_s;
  strategy.profile = ProfileKind::minimum_jerk;
  // Peak acceleration of a minimum-jerk motion: 10 / sqrt 3 x distance / duration^2.
  strategy.lift_acceleration_m_s2 =
      10.0 / std::numbers::sqrt3 * kCube512LiftHeight_m / (kCube512LiftDuration_s * kCube512LiftDuration_s);
  // A little past the end, so that no step of the run sees the palm start to lower (t + theta dt, dt <= 10 ms).
  strategy.hold_s = kCube512Duration_s - kCube512HoldStart_s + 0.02;

  scene.simulation.time_step_s = time_step_s;
  scene.simulation.duration_s = kCube512Duration_s;
  return scene;
}

}  // namespace unbruised::benchmarks
