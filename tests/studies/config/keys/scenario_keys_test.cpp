// Every key of a scenario reaches the field it names, read directly and from the resolved text.

#include <algorithm>

#include "studies/config/schema.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::small_network;
using testing::study_of;

/// Lines of a study that differ from `gripped_block` or `small_network`, and what must have arrived.
struct Arrival {
  std::string key;
  std::string value;
  bool (*arrived)(const Scenario&);
  std::vector<std::string> with = {};  ///< further --set that the key needs
};

const LatticeParameters& lattice(const Scenario& s) { return std::get<LatticeParameters>(s.product); }
const NetworkParameters& network(const Scenario& s) { return std::get<NetworkParameters>(s.product); }

using S = const Scenario&;
using A3 = std::array<double, 3>;
using A2 = std::array<double, 2>;

std::vector<Arrival> product_arrivals() {
  const std::vector<std::string> plastic = {"product.yield_stress_Pa=11.5", "product.tangent_modulus_Pa=7.5"};
  const std::vector<std::string> lossy = {"product.loss_ratio=0.25", "product.at_frequency_Hz=12.5"};
  const std::vector<std::string> burgers = {"product.burgers_flow_time_s=37.5",
                                            "product.burgers_recovery_modulus=3.75",
                                            "product.burgers_recovery_time_s=0.375"};
  return {
      {"product.shape", "\"cylinder\"", [](S s) { return lattice(s).shape == Shape::cylinder; }},
      {"product.size_m", "[0.5, 0.25, 0.75]",
       [](S s) {
         return lattice(s).size_m == A3{0.5, 0.25, 0.75};
       }},
      {"product.axis", "\"y\"", [](S s) { return lattice(s).axis == Axis::y; }, {"product.shape=cylinder"}},
      {"product.profile_height",
       "[0.0, 0.5, 1.5, 2.0]",
       [](S s) {
         return lattice(s).profile_height == std::vector<double>{0.0, 0.5, 1.5, 2.0};
       },
       {"product.shape=revolution", "product.size_m=[0.05, 0.05, 0.07]",
        "product.profile_radius=[0.0, 1.0, 1.0, 0.0]"}},
      {"product.profile_radius",
       "[0.0, 1.0, 0.75, 0.0]",
       [](S s) {
         return lattice(s).profile_radius == std::vector<double>{0.0, 1.0, 0.75, 0.0};
       },
       {"product.shape=revolution", "product.size_m=[0.05, 0.05, 0.07]",
        "product.profile_height=[0.0, 0.5, 1.5, 2.0]"}},
      {"product.exponents",
       "[2.5, 3.5]",
       [](S s) {
         return lattice(s).exponents == A2{2.5, 3.5};
       },
       {"product.shape=superellipsoid"}},
      {"product.cell_size_m", "0.0125", [](S s) { return lattice(s).cell_size_m == 0.0125; }},
      {"product.mass_kg", "0.375", [](S s) { return lattice(s).mass_kg == 0.375 && !lattice(s).density_kg_m3; }},
      {"product.density_kg_m3", "875.0",
       [](S s) { return lattice(s).density_kg_m3 == 875.0 && !lattice(s).mass_kg; }},
      {"product.youngs_modulus_Pa", "12345.0", [](S s) { return lattice(s).youngs_modulus_Pa == 12345.0; }},
      {"product.poisson_ratio", "0.375", [](S s) { return lattice(s).poisson_ratio == 0.375; }},
      {"product.yield_stress_Pa", "11.5", [](S s) { return lattice(s).yield_stress_Pa == 11.5; }, plastic},
      {"product.tangent_modulus_Pa", "7.5", [](S s) { return lattice(s).tangent_modulus_Pa == 7.5; }, plastic},
      {"product.skin_thickness_m",
       "0.00125",
       [](S s) { return lattice(s).skin_thickness_m == 0.00125; },
       {"product.skin_modulus_Pa=1e6"}},
      {"product.skin_modulus_Pa",
       "3.75e6",
       [](S s) { return lattice(s).skin_modulus_Pa == 3.75e6; },
       {"product.skin_thickness_m=1e-4"}},
      {"product.skin_poisson_ratio",
       "0.375",
       [](S s) { return lattice(s).skin_poisson_ratio == 0.375; },
       {"product.skin_thickness_m=1e-4", "product.skin_modulus_Pa=1e6"}},
      {"product.relaxation_time_s", "0.125", [](S s) { return lattice(s).relaxation_time_s == 0.125; }},
      {"product.loss_ratio", "0.25", [](S s) { return lattice(s).loss_ratio == 0.25; }, lossy},
      {"product.at_frequency_Hz", "12.5", [](S s) { return lattice(s).at_frequency_Hz == 12.5; }, lossy},
      {"product.prony_modulus",
       "[0.25, 0.125]",
       [](S s) {
         return lattice(s).prony_modulus == std::vector<double>{0.25, 0.125};
       },
       {"product.prony_time_s=[1.0, 2.0]"}},
      {"product.prony_time_s",
       "[1.5, 25.0]",
       [](S s) {
         return lattice(s).prony_time_s == std::vector<double>{1.5, 25.0};
       },
       {"product.prony_modulus=[0.25, 0.125]"}},
      {"product.prony_from",
       "\"long term\"",
       [](S s) { return lattice(s).prony_from == PronyFrom::long_term; },
       {"product.prony_modulus=[0.25]", "product.prony_time_s=[1.5]"}},
      {"product.burgers_flow_time_s", "37.5", [](S s) { return lattice(s).burgers_flow_time_s == 37.5; }, burgers},
      {"product.burgers_recovery_modulus", "3.75", [](S s) { return lattice(s).burgers_recovery_modulus == 3.75; },
       burgers},
      {"product.burgers_recovery_time_s", "0.375", [](S s) { return lattice(s).burgers_recovery_time_s == 0.375; },
       burgers},
      {"product.friction", "0.875", [](S s) { return lattice(s).friction == 0.875; }},
      {"product.initial_velocity_m_s", "[1.0, 2.0, 3.0]",
       [](S s) {
         return lattice(s).initial_velocity_m_s == A3{1.0, 2.0, 3.0};
       }},
  };
}

const std::vector<std::string> kByForce = {"strategy.guard=\"force\"", "strategy.guard_force_N=0.01",
                                           "strategy.guard_speed_m_s=0.001"};

std::vector<Arrival> gripper_arrivals() {
  const std::vector<std::string> ranges = {"gripper.range.maximum_m=0.05"};
  const std::vector<std::string> locked = {"gripper.hold=\"position\""};
  return {
      {"gripper.finger_mass_kg", "0.375", [](S s) { return jaw_of(s).finger_mass_kg == 0.375; }},
      {"gripper.stroke_m", "0.375", [](S s) { return jaw_of(s).stroke_m == 0.375; }},
      {"gripper.pad_size_m", "[0.5, 0.25]",
       [](S s) {
         return jaw_of(s).pad_size_m == A2{0.5, 0.25};
       }},
      {"gripper.pad_thickness_m", "0.375", [](S s) { return jaw_of(s).pad_thickness_m == 0.375; }},
      {"gripper.pad_modulus_Pa", "375.0", [](S s) { return jaw_of(s).pad_modulus_Pa == 375.0; }},
      {"gripper.pad_poisson_ratio", "0.375", [](S s) { return jaw_of(s).pad_poisson_ratio == 0.375; }},
      {"gripper.pad_bulge", "\"held\"", [](S s) { return jaw_of(s).pad_bulge == PadBulge::held; }},
      {"gripper.pad_edge_radius_m", "0.0012", [](S s) { return jaw_of(s).pad_edge_radius_m == 0.0012; }},
      {"gripper.pad.shape",
       "\"sphere\"",
       [](S s) { return jaw_of(s).pad.shape == PadShape::sphere; },
       {"gripper.pad.radius_m=0.1"}},
      {"gripper.pad.along", "\"y\"", [](S s) { return jaw_of(s).pad.along == PadAlong::y; }},
      {"gripper.pad.radius_m",
       "-0.375",
       [](S s) { return jaw_of(s).pad.radius_m == -0.375; },
       {"gripper.pad.shape=\"cylinder\""}},
      {"gripper.pad.half_angle_rad",
       "1.25",
       [](S s) { return jaw_of(s).pad.half_angle_rad == 1.25; },
       {"gripper.pad.shape=\"v_groove\""}},
      {"gripper.pad.profile_place_m",
       "[-0.5, 0.25]",
       [](S s) {
         return jaw_of(s).pad.profile_place_m == std::vector<double>{-0.5, 0.25};
       },
       {"gripper.pad.shape=\"profile\"", "gripper.pad.profile_height_m=[0.0, 0.0]"}},
      {"gripper.pad.profile_height_m",
       "[0.0, 0.0009765625]",
       [](S s) {
         return jaw_of(s).pad.profile_height_m == std::vector<double>{0.0, 0.0009765625};
       },
       {"gripper.pad.shape=\"profile\"", "gripper.pad.profile_place_m=[-0.5, 0.25]"}},
      {"gripper.pad.law_depth_m",
       "[0.0, 0.25]",
       [](S s) {
         return jaw_of(s).pad.law_depth_m == std::vector<double>{0.0, 0.25};
       },
       {"gripper.pad.law_force_N=[0.0, 5.0]", "gripper.pad_poisson_ratio=0.0"}},
      {"gripper.pad.law_force_N",
       "[0.0, 5.5]",
       [](S s) {
         return jaw_of(s).pad.law_force_N == std::vector<double>{0.0, 5.5};
       },
       {"gripper.pad.law_depth_m=[0.0, 0.25]", "gripper.pad_poisson_ratio=0.0"}},
      {"gripper.pad.law_coefficients",
       "[375.0, 2.5]",
       [](S s) {
         return jaw_of(s).pad.law_coefficients == std::vector<double>{375.0, 2.5};
       },
       {"gripper.pad_poisson_ratio=0.0"}},
      {"gripper.pad_relaxation_time_s", "0.375", [](S s) { return jaw_of(s).pad_relaxation_time_s == 0.375; }},
      {"gripper.pad.kind",
       "\"lattice\"",
       [](S s) { return jaw_of(s).pad.kind == PadKind::lattice; },
       {"gripper.pad.cell_size_m=0.0015"}},
      {"gripper.pad.cell_size_m",
       "0.0015",
       [](S s) { return jaw_of(s).pad.cell_size_m == 0.0015; },
       {"gripper.pad.kind=\"lattice\""}},
      {"gripper.pad.density_kg_m3", "375.0", [](S s) { return jaw_of(s).pad.density_kg_m3 == 375.0; }},
      {"gripper.drive_gain_N_s_m", "375.0", [](S s) { return jaw_of(s).drive_gain_N_s_m == 375.0; }},
      {"gripper.drive_viscous_N_s_m", "0.375", [](S s) { return jaw_of(s).drive_viscous_N_s_m == 0.375; }},
      {"gripper.min_force_N", "0.25", [](S s) { return jaw_of(s).min_force_N == 0.25; }},
      {"gripper.force_accuracy", "0.125", [](S s) { return jaw_of(s).force_accuracy == 0.125; }},
      {"gripper.hold", "\"position\"", [](S s) { return jaw_of(s).hold == HoldMode::position; }},
      {"gripper.lock_stiffness_N_m", "12345.0", [](S s) { return jaw_of(s).lock_stiffness_N_m == 12345.0; },
       locked},
      {"gripper.curve_speed_m_s",
       "[0.0, 0.25, 0.5]",
       [](S s) {
         return jaw_of(s).curve_speed_m_s == std::vector<double>{0.0, 0.25, 0.5};
       },
       {"gripper.curve_force_N=[200.0, 100.0, 0.0]"}},
      {"gripper.curve_force_N",
       "[200.0, 150.0]",
       [](S s) {
         return jaw_of(s).curve_force_N == std::vector<double>{200.0, 150.0};
       },
       {"gripper.curve_speed_m_s=[0.0, 1.5]"}},
      {"gripper.payload_kg", "0.375", [](S s) { return jaw_of(s).payload_kg == 0.375; }},
      {"gripper.jaw_moment_N_m", "0.375", [](S s) { return jaw_of(s).jaw_moment_N_m == 0.375; }},
      {"gripper.finger_length_m", "0.375", [](S s) { return jaw_of(s).finger_length_m == 0.375; }},
      {"gripper.safety_factor", "2.5", [](S s) { return jaw_of(s).safety_factor == 2.5; }},
      {"gripper.force_step_N", "0.125", [](S s) { return jaw_of(s).force_step_N == 0.125; }},
      {"gripper.opening_m", "0.375", [](S s) { return jaw_of(s).opening_m == 0.375; }, {"gripper.stroke_m=0.5"}},
      {"gripper.range.maximum_m", "0.375", [](S s) { return jaw_of(s).range.maximum_m == 0.375; }},
      {"gripper.range.offset_m", "[0.002, -0.003]",
       [](S s) {
         return jaw_of(s).range.offset_m == A2{0.002, -0.003};
       },
       ranges},
      {"gripper.range.depth_m", "0.375", [](S s) { return jaw_of(s).range.depth_m == 0.375; }, ranges},
      {"gripper.range.rate_Hz", "37.5", [](S s) { return jaw_of(s).range.rate_Hz == 37.5; }, ranges},
      {"gripper.range.resolution_m", "0.375", [](S s) { return jaw_of(s).range.resolution_m == 0.375; }, ranges},
      {"gripper.range.noise_m",
       "0.375",
       [](S s) { return jaw_of(s).range.noise_m == 0.375; },
       {"gripper.range.maximum_m=0.05", "gripper.range.rate_Hz=50.0"}},
      {"gripper.range.noise_seed", "37", [](S s) { return jaw_of(s).range.noise_seed == 37; }, ranges},
      {"gripper.force_rate_Hz", "37.5", [](S s) { return jaw_of(s).force_rate_Hz == 37.5; }, kByForce},
      {"gripper.max_force_N", "375.0", [](S s) { return jaw_of(s).max_force_N == 375.0; }},
      {"gripper.max_speed_m_s", "3.75", [](S s) { return jaw_of(s).max_speed_m_s == 3.75; }},
      {"gripper.coupling", "\"independent\"",
       [](S s) { return jaw_of(s).coupling == FingerCoupling::independent; }},
  };
}

std::vector<Arrival> cell_arrivals() {
  return {
      {"cell.grip_offset_m", "0.0078125", [](S s) { return s.cell.grip_offset_m == 0.0078125; }},
      {"cell.gravity_m_s2", "[1.0, 2.0, 3.0]",
       [](S s) {
         return s.cell.gravity_m_s2 == A3{1.0, 2.0, 3.0};
       }},
      {"cell.support", "false", [](S s) { return !s.cell.support; }},
      {"cell.support_friction", "0.375", [](S s) { return s.cell.support_friction == 0.375; }},
      {"cell.support_modulus_Pa", "375.0", [](S s) { return s.cell.support_modulus_Pa == 375.0; }},
      {"cell.support_thickness_m", "0.375", [](S s) { return s.cell.support_thickness_m == 0.375; }},
      {"cell.support_poisson_ratio", "0.375", [](S s) { return s.cell.support_poisson_ratio == 0.375; }},
      {"cell.support_relaxation_time_s", "0.375", [](S s) { return s.cell.support_relaxation_time_s == 0.375; }},
      {"cell.approach_gap_m", "0.0375", [](S s) { return s.cell.approach_gap_m == 0.0375; }},
      {"cell.grip_height_m", "-0.0375", [](S s) { return s.cell.grip_height_m == -0.0375; }},
      {"cell.lift_height_m", "0.375", [](S s) { return s.cell.lift_height_m == 0.375; }},
      {"cell.transfer_m", "[0.5, 0.25]",
       [](S s) {
         return s.cell.transfer_m == A2{0.5, 0.25};
       }},
      {"cell.place_height_m", "-0.375", [](S s) { return s.cell.place_height_m == -0.375; }},
      {"cell.place_velocity_m_s", "[0.125, 0.25]",
       [](S s) {
         return s.cell.place_velocity_m_s == A2{0.125, 0.25};
       }},
      {"cell.stop_deceleration_m_s2",
       "3.75",
       [](S s) { return s.cell.stop_deceleration_m_s2 == 3.75; },
       {"strategy.stop_time_s=0.5"}},
      {"cell.conveyor.speed_m_s", "0.375", [](S s) { return s.cell.conveyor.speed_m_s == 0.375; }},
      {"cell.conveyor.initial_speed_m_s",
       "0.375",
       [](S s) { return s.cell.conveyor.initial_speed_m_s == 0.375; },
       {"cell.conveyor.acceleration_m_s2=1.0"}},
      {"cell.conveyor.acceleration_m_s2", "0.375", [](S s) { return s.cell.conveyor.acceleration_m_s2 == 0.375; }},
      {"cell.conveyor.start_s", "0.375", [](S s) { return s.cell.conveyor.start_s == 0.375; }},
      {"cell.conveyor.direction", "[0.5, 0.25]",
       [](S s) {
         return s.cell.conveyor.direction == A2{0.5, 0.25};
       }},
      {"cell.conveyor.length_m", "0.375", [](S s) { return s.cell.conveyor.length_m == 0.375; }},
  };
}

std::vector<Arrival> strategy_arrivals() {
  return {
      {"strategy.approach_speed_m_s", "0.375", [](S s) { return s.strategy.approach_speed_m_s == 0.375; }},
      {"strategy.grip_force_N", "3.75", [](S s) { return s.strategy.grip_force_N == 3.75; }},
      {"strategy.contact_force_N", "0.875", [](S s) { return s.strategy.contact_force_N == 0.875; }},
      {"strategy.grip_ramp_s", "0.875", [](S s) { return s.strategy.grip_ramp_s == 0.875; }},
      {"strategy.ramp_from_start", "true", [](S s) { return s.strategy.ramp_from_start; }},
      {"strategy.settle_s", "0.875", [](S s) { return s.strategy.settle_s == 0.875; }},
      {"strategy.guard", "\"force\"", [](S s) { return s.strategy.guard == GuardKind::force; }, kByForce},
      {"strategy.guard_range_m",
       "0.003125",
       [](S s) { return s.strategy.guard_range_m == 0.003125; },
       {"gripper.range.maximum_m=0.05", "strategy.guard=\"range\"", "strategy.guard_speed_m_s=0.001"}},
      {"strategy.guard_force_N", "0.0125", [](S s) { return s.strategy.guard_force_N == 0.0125; }, kByForce},
      {"strategy.guard_speed_m_s", "0.0025", [](S s) { return s.strategy.guard_speed_m_s == 0.0025; }, kByForce},
      {"strategy.pick",
       "\"tracking\"",
       [](S s) { return s.strategy.pick == PickKind::tracking; },
       {"cell.conveyor.speed_m_s=0.25"}},
      {"strategy.pick_offset_m", "-0.375", [](S s) { return s.strategy.pick_offset_m == -0.375; }},
      {"strategy.tracking_lag_s",
       "0.375",
       [](S s) { return s.strategy.tracking_lag_s == 0.375; },
       {"strategy.pick=\"tracking\"", "cell.conveyor.speed_m_s=0.25"}},
      {"strategy.profile", "\"trapezoid\"", [](S s) { return s.strategy.profile == ProfileKind::trapezoid; }},
      {"strategy.profile",
       "\"s_curve\"",
       [](S s) { return s.strategy.profile == ProfileKind::s_curve; },
       {"strategy.jerk_m_s3=40.0"}},
      {"strategy.jerk_m_s3", "8.75", [](S s) { return s.strategy.jerk_m_s3 == 8.75; }},
      {"strategy.tilt_jerk_rad_s3", "8.75", [](S s) { return s.strategy.tilt_jerk_rad_s3 == 8.75; }},
      {"strategy.lift_acceleration_m_s2", "8.75", [](S s) { return s.strategy.lift_acceleration_m_s2 == 8.75; }},
      {"strategy.transfer_acceleration_m_s2", "8.75",
       [](S s) { return s.strategy.transfer_acceleration_m_s2 == 8.75; }},
      {"strategy.lower_acceleration_m_s2", "8.75", [](S s) { return s.strategy.lower_acceleration_m_s2 == 8.75; }},
      {"strategy.speed_m_s", "8.75", [](S s) { return s.strategy.speed_m_s == 8.75; }},
      {"strategy.tilt_rad", "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.strategy.tilt_rad == A3{0.125, -0.25, 0.5};
       }},
      {"strategy.tilt_speed_rad_s", "3.75", [](S s) { return s.strategy.tilt_speed_rad_s == 3.75; }},
      {"strategy.tilt_acceleration_rad_s2", "3.75",
       [](S s) { return s.strategy.tilt_acceleration_rad_s2 == 3.75; }},
      {"strategy.hold_s", "8.75", [](S s) { return s.strategy.hold_s == 8.75; }},
      {"strategy.release_height_m",
       "0.875",
       [](S s) { return s.strategy.release_height_m == 0.875; },
       {"cell.lift_height_m=1.0"}},
      {"strategy.place_settle_s", "0.875", [](S s) { return s.strategy.place_settle_s == 0.875; }},
      {"strategy.release_speed_m_s", "0.375", [](S s) { return s.strategy.release_speed_m_s == 0.375; }},
      {"strategy.recover_s", "0.875", [](S s) { return s.strategy.recover_s == 0.875; }},
      {"strategy.stop_time_s", "0.875", [](S s) { return s.strategy.stop_time_s == 0.875; }},
      {"strategy.repeat", "3", [](S s) { return s.strategy.repeat == 3; }},
  };
}

/// Of a study with two fingers that are listed.
std::vector<Arrival> finger_arrivals() {
  return {
      {"gripper.finger[1].angle_rad", "3.15", [](S s) { return jaw_of(s).finger[1].angle_rad == 3.15; }},
      {"gripper.finger[0].direction", "[-2.0, 0.0, 0.0]",
       [](S s) {
         return jaw_of(s).finger[0].direction == A3{-2.0, 0.0, 0.0};
       }},
      {"gripper.finger[0].offset_m", "[0.0, 0.002, -0.003]",
       [](S s) {
         return jaw_of(s).finger[0].offset_m == A3{0.0, 0.002, -0.003};
       }},
  };
}

/// Of a study with an arm of one joint.
std::vector<Arrival> robot_arrivals() {
  return {
      {"robot.base_place_m", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.base_place_m == A3{0.25, 0.5, 0.75};
       }},
      {"robot.base_rotation_rad", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.base_rotation_rad == A3{0.25, 0.5, 0.75};
       }},
      {"robot.flange_place_m", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.flange_place_m == A3{0.25, 0.5, 0.75};
       }},
      {"robot.flange_rotation_rad", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.flange_rotation_rad == A3{0.25, 0.5, 0.75};
       }},
      {"robot.tool_place_m", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.tool_place_m == A3{0.25, 0.5, 0.75};
       }},
      {"robot.tool_rotation_rad", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.tool_rotation_rad == A3{0.25, 0.5, 0.75};
       }},
      {"robot.seed_posture_rad", "[0.375]",
       [](S s) { return s.robot.seed_posture_rad == std::vector<double>{0.375}; }},
      {"robot.acceleration_rad_s2", "[37.5]",
       [](S s) { return s.robot.acceleration_rad_s2 == std::vector<double>{37.5}; }},
      {"robot.stiffness_N_m_rad", "[3750.0]",
       [](S s) { return s.robot.stiffness_N_m_rad == std::vector<double>{3750.0}; }},
      {"robot.damping_ratio",
       "0.375",
       [](S s) { return s.robot.damping_ratio == 0.375; },
       {"robot.stiffness_N_m_rad=[5e3]"}},
      {"robot.deceleration_rad_s2", "[37.5]",
       [](S s) { return s.robot.deceleration_rad_s2 == std::vector<double>{37.5}; }},
      {"robot.jerk_rad_s3", "[37.5]", [](S s) { return s.robot.jerk_rad_s3 == std::vector<double>{37.5}; }},
      {"robot.bandwidth_Hz", "[37.5]", [](S s) { return s.robot.bandwidth_Hz == std::vector<double>{37.5}; }},
      {"robot.gripper_mass_kg", "0.375", [](S s) { return s.robot.gripper_mass_kg == 0.375; }},
      {"robot.gripper_center_of_mass_m", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.gripper_center_of_mass_m == A3{0.25, 0.5, 0.75};
       }},
      {"robot.max_payload_kg", "3.75", [](S s) { return s.robot.max_payload_kg == 3.75; }},
      {"robot.timing", "\"fit\"", [](S s) { return s.robot.timing == RobotTiming::fit; }},
      {"robot.use_most", "0.375", [](S s) { return s.robot.use_most == 0.375; }},
      {"robot.joint[0].place_m", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.joint[0].place_m == A3{0.25, 0.5, 0.75};
       }},
      {"robot.joint[0].rotation_rad", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.joint[0].rotation_rad == A3{0.25, 0.5, 0.75};
       }},
      {"robot.joint[0].axis", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.joint[0].axis == A3{0.25, 0.5, 0.75};
       }},
      {"robot.joint[0].lower_rad", "-0.375", [](S s) { return s.robot.joint[0].lower_rad == -0.375; }},
      {"robot.joint[0].upper_rad", "0.375", [](S s) { return s.robot.joint[0].upper_rad == 0.375; }},
      {"robot.joint[0].speed_rad_s", "0.375", [](S s) { return s.robot.joint[0].speed_rad_s == 0.375; }},
      {"robot.joint[0].torque_N_m", "0.375", [](S s) { return s.robot.joint[0].torque_N_m == 0.375; }},
      {"robot.joint[0].mass_kg", "0.375", [](S s) { return s.robot.joint[0].mass_kg == 0.375; }},
      {"robot.joint[0].center_of_mass_m", "[0.25, 0.5, 0.75]",
       [](S s) {
         return s.robot.joint[0].center_of_mass_m == A3{0.25, 0.5, 0.75};
       }},
      {"robot.joint[0].inertia_kg_m2", "[0.25, 0.375, 0.5, 0.0, 0.0, 0.125]",
       [](S s) {
         return s.robot.joint[0].inertia_kg_m2 == std::array<double, 6>{0.25, 0.375, 0.5, 0.0, 0.0, 0.125};
       }},
  };
}

/// Of a study with a product of one layer.
std::vector<Arrival> layer_arrivals() {
  const std::vector<std::string> plastic = {"product.layer[0].yield_stress_Pa=11.5",
                                            "product.layer[0].tangent_modulus_Pa=7.5"};
  return {
      {"product.layer[0].from_depth_m", "0.0125",
       [](S s) { return lattice(s).layer.at(0).from_depth_m == 0.0125; }},
      {"product.layer[0].size_m",
       "[0.001, 0.002, 0.003]",
       [](S s) {
         return lattice(s).layer.at(0).size_m == std::array<double, 3>{0.001, 0.002, 0.003};
       },
       {"product.layer[0].from_depth_m=none"}},
      {"product.layer[0].center_m",
       "[0.001, 0.002, 0.003]",
       [](S s) {
         return lattice(s).layer.at(0).center_m == std::array<double, 3>{0.001, 0.002, 0.003};
       },
       {"product.layer[0].from_depth_m=none", "product.layer[0].size_m=[0.001, 0.001, 0.001]"}},
      {"product.layer[0].youngs_modulus_Pa", "12345.0",
       [](S s) { return lattice(s).layer.at(0).youngs_modulus_Pa == 12345.0; }},
      {"product.layer[0].poisson_ratio", "0.375",
       [](S s) { return lattice(s).layer.at(0).poisson_ratio == 0.375; }},
      {"product.layer[0].yield_stress_Pa", "11.5",
       [](S s) { return lattice(s).layer.at(0).yield_stress_Pa == 11.5; }, plastic},
      {"product.layer[0].tangent_modulus_Pa", "7.5",
       [](S s) { return lattice(s).layer.at(0).tangent_modulus_Pa == 7.5; }, plastic},
  };
}

/// Of a study with one surface beside the product.
std::vector<Arrival> surface_arrivals() {
  return {
      {"cell.surface[0].center_m", "[0.25, -0.5, 0.125]",
       [](S s) {
         return s.cell.surface[0].center_m == A3{0.25, -0.5, 0.125};
       }},
      {"cell.surface[0].normal", "[0.0, -1.0, 1.0]",
       [](S s) {
         return s.cell.surface[0].normal == A3{0.0, -1.0, 1.0};
       }},
      {"cell.surface[0].size_m", "[0.25, 0.5]",
       [](S s) {
         return s.cell.surface[0].size_m == std::array<double, 2>{0.25, 0.5};
       }},
      {"cell.surface[0].friction", "0.875", [](S s) { return s.cell.surface[0].friction == 0.875; }},
      {"cell.surface[0].modulus_Pa", "3.75e6", [](S s) { return s.cell.surface[0].modulus_Pa == 3.75e6; }},
      {"cell.surface[0].thickness_m", "0.0625", [](S s) { return s.cell.surface[0].thickness_m == 0.0625; }},
      {"cell.surface[0].relaxation_time_s", "0.0625",
       [](S s) { return s.cell.surface[0].relaxation_time_s == 0.0625; }},
      {"cell.surface[0].path_time_s",
       "[0.5, 0.875]",
       [](S s) {
         return s.cell.surface[0].path_time_s == std::vector<double>{0.5, 0.875};
       },
       {"cell.surface[0].path_m=[[0.0, 0.0, 0.0], [0.1, 0.0, 0.0]]"}},
      {"cell.surface[0].path_m",
       "[[0.0, 0.0, 0.0], [0.0, 0.5, 0.0]]",
       [](S s) {
         return s.cell.surface[0].path_m == std::vector<A3>{A3{}, A3{0.0, 0.5, 0.0}};
       },
       {"cell.surface[0].path_time_s=[0.5, 0.875]"}},
      {"cell.target_plane", "false", [](S s) { return !s.cell.target_plane; }},
      {"simulation.contact_set", "\"six sides\"",
       [](S s) { return s.simulation.contact_set == ContactSet::six_sides; }},
      {"simulation.levels", "\"off\"", [](S s) { return s.simulation.levels == LevelUse::off; }},
      {"simulation.body", "\"modes\"", [](S s) { return s.simulation.body == ProductBody::modes; }},
      {"simulation.mode_count", "48", [](S s) { return s.simulation.mode_count == 48; }},
  };
}

/// Of a study with one waypoint.
std::vector<Arrival> waypoint_arrivals() {
  return {
      {"strategy.waypoint[0].place_m", "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.strategy.waypoint[0].place_m == A3{0.125, -0.25, 0.5};
       }},
      {"strategy.waypoint[0].rotation_rad", "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.strategy.waypoint[0].rotation_rad == A3{0.125, -0.25, 0.5};
       }},
      {"strategy.waypoint[0].quaternion", "[0.0, 0.6, 0.8, 0.0]",
       [](S s) {
         return s.strategy.waypoint[0].quaternion == std::array<double, 4>{0.0, 0.6, 0.8, 0.0};
       }},
      {"strategy.waypoint[0].via_m",
       "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.strategy.waypoint[0].via_m == A3{0.125, -0.25, 0.5};
       },
       {"strategy.waypoint[0].place_m=[0.0, 0.25, 0.5]"}},
      {"strategy.waypoint[0].blend_m",
       "0.875",
       [](S s) { return s.strategy.waypoint[0].blend_m == 0.875; },
       {"strategy.waypoint[0].wait_s=0.0"}},
      {"strategy.waypoint[0].speed_m_s", "0.875", [](S s) { return s.strategy.waypoint[0].speed_m_s == 0.875; }},
      {"strategy.waypoint[0].duration_s", "0.875", [](S s) { return s.strategy.waypoint[0].duration_s == 0.875; }},
      {"strategy.waypoint[0].wait_s", "0.875", [](S s) { return s.strategy.waypoint[0].wait_s == 0.875; }},
  };
}

/// Of a study with a sensor at the wrist.
std::vector<Arrival> sensor_arrivals() {
  return {
      {"sensor.at", "\"support\"", [](S s) { return s.sensor.at == SensorMount::support; }},
      {"sensor.model",
       "\"ring\"",
       [](S s) { return s.sensor.model == SensorModel::ring; },
       {"sensor.ring_stiffness_N_m=[1e6, 1e6, 1e6]"}},
      {"sensor.element_stiffness_N_m", "3.75e6", [](S s) { return s.sensor.element_stiffness_N_m == 3.75e6; }},
      {"sensor.element_radius_m", "0.0625", [](S s) { return s.sensor.element_radius_m == 0.0625; }},
      {"sensor.element_count", "6", [](S s) { return s.sensor.element_count == 6; }},
      {"sensor.ring_stiffness_N_m",
       "[1e6, 2e6, 3e6]",
       [](S s) {
         return s.sensor.ring_stiffness_N_m == A3{1e6, 2e6, 3e6};
       },
       {"sensor.model=\"ring\""}},
      {"sensor.stiffness_N_m",
       "[1e6, 2e6, 3e6]",
       [](S s) {
         return s.sensor.stiffness_N_m == A3{1e6, 2e6, 3e6};
       },
       {"sensor.model=\"datasheet\"", "sensor.stiffness_N_m_rad=[1e3, 1e3, 1e3]"}},
      {"sensor.stiffness_N_m_rad",
       "[1e3, 2e3, 3e3]",
       [](S s) {
         return s.sensor.stiffness_N_m_rad == A3{1e3, 2e3, 3e3};
       },
       {"sensor.model=\"datasheet\"", "sensor.stiffness_N_m=[1e6, 1e6, 1e6]"}},
      {"sensor.stiffness_matrix",
       "[1e6, 0, 0, 0, 0, 0, 0, 1e6, 0, 0, 0, 0, 0, 0, 1e6, 0, 0, 0, 0, 0, 0, 1e3, 0, 0, 0, 0, 0, 0, 1e3, 0, 0, "
       "0, "
       "0, 0, 0, 2e3]",
       [](S s) { return s.sensor.stiffness_matrix && (*s.sensor.stiffness_matrix)[35] == 2e3; },
       {"sensor.model=\"matrix\""}},
      {"sensor.damping_ratio", "0.0625", [](S s) { return s.sensor.damping_ratio == 0.0625; }},
      {"sensor.mass_kg", "3.75", [](S s) { return s.sensor.mass_kg == 3.75; }},
      {"sensor.center_of_mass_m", "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.sensor.center_of_mass_m == A3{0.125, -0.25, 0.5};
       }},
      {"sensor.inertia_kg_m2", "[0.125, 0.25, 0.25]",
       [](S s) {
         return s.sensor.inertia_kg_m2 == A3{0.125, 0.25, 0.25};
       }},
      {"sensor.position_m", "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.sensor.position_m == A3{0.125, -0.25, 0.5};
       }},
      {"sensor.report_at_m", "[0.125, -0.25, 0.5]",
       [](S s) {
         return s.sensor.report_at_m == A3{0.125, -0.25, 0.5};
       }},
      {"sensor.tare", "\"start\"", [](S s) { return s.sensor.tare == SensorTare::start; }},
      {"sensor.bandwidth_Hz", "37.5", [](S s) { return s.sensor.bandwidth_Hz == 37.5; }},
      {"sensor.rate_Hz", "37.5", [](S s) { return s.sensor.rate_Hz == 37.5; }},
      {"sensor.resolution_N", "0.0625", [](S s) { return s.sensor.resolution_N == 0.0625; }},
      {"sensor.resolution_N_m", "0.0625", [](S s) { return s.sensor.resolution_N_m == 0.0625; }},
      {"sensor.range_N", "37.5", [](S s) { return s.sensor.range_N == 37.5; }},
      {"sensor.range_N_m", "37.5", [](S s) { return s.sensor.range_N_m == 37.5; }},
      {"sensor.noise_N", "0.0625", [](S s) { return s.sensor.noise_N == 0.0625; }, {"sensor.rate_Hz=100.0"}},
      {"sensor.noise_N_m", "0.0625", [](S s) { return s.sensor.noise_N_m == 0.0625; }, {"sensor.rate_Hz=100.0"}},
      {"sensor.noise_seed", "7", [](S s) { return s.sensor.noise_seed == 7; }},
      {"sensor.motion_prediction", "false", [](S s) { return !s.sensor.motion_prediction; }},
  };
}

std::vector<Arrival> limit_and_simulation_arrivals() {
  return {
      {"limits.permanent_set_m", "0.875", [](S s) { return s.limits.permanent_set_m == 0.875; }},
      {"limits.plastic_strain", "0.875", [](S s) { return s.limits.plastic_strain == 0.875; }},
      {"limits.bruised_volume_m3", "0.875", [](S s) { return s.limits.bruised_volume_m3 == 0.875; }},
      {"limits.peak_pressure_Pa", "0.875", [](S s) { return s.limits.peak_pressure_Pa == 0.875; }},
      {"limits.absorbed_energy_J", "0.875", [](S s) { return s.limits.absorbed_energy_J == 0.875; }},
      {"limits.finger_force_N", "0.875", [](S s) { return s.limits.finger_force_N == 0.875; }},
      {"limits.contact_yield_ratio", "0.875", [](S s) { return s.limits.contact_yield_ratio == 0.875; }},
      {"limits.slip_m", "0.875", [](S s) { return s.limits.slip_m == 0.875; }},
      {"limits.slip_rad", "0.875", [](S s) { return s.limits.slip_rad == 0.875; }},
      {"limits.place_error_m", "0.875", [](S s) { return s.limits.place_error_m == 0.875; }},
      {"limits.place_attitude_rad", "0.875", [](S s) { return s.limits.place_attitude_rad == 0.875; }},
      {"limits.damage", "\"not considered\"",
       [](S s) { return s.limits.damage == DamageJudging::not_considered; }},
      {"simulation.time_step_s", "0.125", [](S s) { return s.simulation.time_step_s == 0.125; }},
      {"simulation.theta", "1.5", [](S s) { return s.simulation.theta == 1.5; }},
      {"simulation.trace_interval_s", "0.875", [](S s) { return s.simulation.trace_interval_s == 0.875; }},
      {"simulation.pressure_patch_m", "0.875", [](S s) { return s.simulation.pressure_patch_m == 0.875; }},
      {"simulation.max_strain", "0.875", [](S s) { return s.simulation.max_strain == 0.875; }},
      {"simulation.max_rotation_rad", "0.875", [](S s) { return s.simulation.max_rotation_rad == 0.875; }},
  };
}

std::vector<Arrival> network_arrivals() {
  const std::vector<std::string> burgers = {"product.spring[0].burgers_flow_N_s_m=37.5",
                                            "product.spring[0].burgers_recovery_N_m=3.75",
                                            "product.spring[0].burgers_recovery_N_s_m=0.375"};
  return {
      {"product.particle[1].position_m", "[1.0, 2.0, 3.0]",
       [](S s) {
         return network(s).particle[1].position_m == A3{1.0, 2.0, 3.0};
       }},
      {"product.particle[1].mass_kg", "0.375", [](S s) { return network(s).particle[1].mass_kg == 0.375; }},
      {"product.particle[1].fixed", "[\"z\", \"x\"]",
       [](S s) {
         return network(s).particle[1].fixed == std::array<bool, 3>{true, false, true};
       }},
      {"product.particle[1].initial_displacement_m", "[1.0, 2.0, 3.0]",
       [](S s) {
         return network(s).particle[1].initial_displacement_m == A3{1.0, 2.0, 3.0};
       }},
      {"product.particle[1].initial_velocity_m_s", "[1.0, 2.0, 3.0]",
       [](S s) {
         return network(s).particle[1].initial_velocity_m_s == A3{1.0, 2.0, 3.0};
       }},
      {"product.particle[1].contact_stiffness_N_m",
       "375.0",
       [](S s) { return network(s).particle[1].contact_stiffness_N_m == 375.0; },
       {"cell.support=true"}},
      {"product.spring[0].between", "[1, 0]",
       [](S s) {
         return network(s).spring[0].between == std::array<int, 2>{1, 0};
       }},
      {"product.spring[0].stiffness_N_m", "375.0",
       [](S s) { return network(s).spring[0].stiffness_N_m == 375.0; }},
      {"product.spring[0].damping_N_s_m", "3.75", [](S s) { return network(s).spring[0].damping_N_s_m == 3.75; }},
      {"product.spring[0].rest_length_m", "3.75", [](S s) { return network(s).spring[0].rest_length_m == 3.75; }},
      {"product.spring[0].yield_force_N", "3.75", [](S s) { return network(s).spring[0].yield_force_N == 3.75; }},
      {"product.spring[0].hardening_ratio", "3.75",
       [](S s) { return network(s).spring[0].hardening_ratio == 3.75; }},
      {"product.spring[0].prony_modulus",
       "[0.25, 0.125]",
       [](S s) {
         return network(s).spring[0].prony_modulus == std::vector<double>{0.25, 0.125};
       },
       {"product.spring[0].prony_time_s=[1.0, 2.0]"}},
      {"product.spring[0].prony_time_s",
       "[1.5, 25.0]",
       [](S s) {
         return network(s).spring[0].prony_time_s == std::vector<double>{1.5, 25.0};
       },
       {"product.spring[0].prony_modulus=[0.25, 0.125]"}},
      {"product.spring[0].prony_from",
       "\"long term\"",
       [](S s) { return network(s).spring[0].prony_from == PronyFrom::long_term; },
       {"product.spring[0].prony_modulus=[0.25]", "product.spring[0].prony_time_s=[1.5]"}},
      {"product.spring[0].burgers_flow_N_s_m", "37.5",
       [](S s) { return network(s).spring[0].burgers_flow_N_s_m == 37.5; }, burgers},
      {"product.spring[0].burgers_recovery_N_m", "3.75",
       [](S s) { return network(s).spring[0].burgers_recovery_N_m == 3.75; }, burgers},
      {"product.spring[0].burgers_recovery_N_s_m", "0.375",
       [](S s) { return network(s).spring[0].burgers_recovery_N_s_m == 0.375; }, burgers},
      {"product.load[0].particle", "0", [](S s) { return network(s).load[0].particle == 0; }},
      {"product.load[0].time_s", "[0.5, 3.0]",
       [](S s) {
         return network(s).load[0].time_s == std::vector<double>{0.5, 3.0};
       }},
      {"product.load[0].force_N", "[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]",
       [](S s) {
         return network(s).load[0].force_N == std::vector<A3>{A3{1.0, 2.0, 3.0}, A3{4.0, 5.0, 6.0}};
       }},
      {"product.friction", "0.875", [](S s) { return network(s).friction == 0.875; }},
      {"simulation.duration_s", "3.75", [](S s) { return s.simulation.duration_s == 3.75; }},
      {"simulation.initial_acceleration", "\"zero\"",
       [](S s) { return s.simulation.initial_acceleration == InitialAcceleration::zero; }},
  };
}

/// Of a product that nothing can touch.
std::vector<Arrival> flight_arrivals() {
  return {
      {"product.initial_spin_rad_s", "[1.0, 2.0, 3.0]",
       [](S s) {
         return lattice(s).initial_spin_rad_s == A3{1.0, 2.0, 3.0};
       }},
      {"product.initial_rotation_rad", "[0.125, -0.25, 0.5]",
       [](S s) {
         return lattice(s).initial_rotation_rad == A3{0.125, -0.25, 0.5};
       }},
      {"product.initial_height_m",
       "0.125",
       [](S s) { return lattice(s).initial_height_m == 0.125; },
       {"cell.support=true"}},
  };
}

std::vector<Arrival> lattice_arrivals() {
  std::vector<Arrival> all;
  for (const auto& part : {product_arrivals(), gripper_arrivals(), cell_arrivals(), strategy_arrivals(),
                           limit_and_simulation_arrivals()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// The key read directly, and once more from the resolved text.
void expect_arrivals(const std::vector<Arrival>& arrivals, const std::string& text) {
  const Scenario before = study_of(text).scenario(0);
  for (const Arrival& arrival : arrivals) {
    EXPECT_FALSE(arrival.arrived(before)) << arrival.key << ": the test needs a value that is not there already";
    std::vector<std::string> sets = arrival.with;
    sets.push_back(arrival.key + "=" + arrival.value);
    const Study study = study_of(text, sets);
    EXPECT_TRUE(arrival.arrived(study.scenario(0))) << arrival.key;
    const Study again = study_of(study.resolved_toml());
    EXPECT_TRUE(arrival.arrived(again.scenario(0))) << arrival.key << " from\n" << study.resolved_toml();
    EXPECT_EQ(again.resolved_toml(), study.resolved_toml());
  }
}

TEST(ScenarioKeys, EveryLatticeKeyReachesTheFieldItNames) {
  expect_arrivals(lattice_arrivals(), gripped_block("simulate"));
}

TEST(ScenarioKeys, EveryKeyOfAFreeFlightReachesTheFieldItNames) {
  expect_arrivals(
      flight_arrivals(),
      "[study]\nname = \"test\"\nkind = \"simulate\"\n"
      "[product]\nshape = \"box\"\nsize_m = [0.05, 0.06, 0.07]\nmass_kg = 0.1\nyoungs_modulus_Pa = 1e6\n"
      "[cell]\nsupport = false\n[simulation]\nduration_s = 1.0\n");
}

TEST(ScenarioKeys, EveryKeyOfAWaypointReachesTheFieldItNames) {
  expect_arrivals(
      waypoint_arrivals(),
      gripped_block("simulate") + "[[strategy.waypoint]]\nwait_s = 0.25\n[[strategy.waypoint]]\nwait_s = 0.5\n");
}

TEST(ScenarioKeys, EveryKeyOfAnArmReachesTheFieldItNames) {
  expect_arrivals(robot_arrivals(), gripped_block("simulate") + "[[robot.joint]]\nmass_kg = 2.0\n");
}

TEST(ScenarioKeys, EveryKeyOfALayerReachesTheFieldItNames) {
  expect_arrivals(layer_arrivals(),
                  gripped_block("simulate") + "[[product.layer]]\nfrom_depth_m = 0.01\nyoungs_modulus_Pa = 2e5\n");
}

TEST(ScenarioKeys, EveryKeyOfASurfaceReachesTheFieldItNames) {
  expect_arrivals(surface_arrivals(),
                  gripped_block("simulate") + "[[cell.surface]]\ncenter_m = [0.0, 0.0, -0.5]\nfriction = 0.25\n");
}

TEST(ScenarioKeys, EveryKeyOfAListedFingerReachesTheFieldItNames) {
  expect_arrivals(finger_arrivals(), gripped_block("simulate") +
                                         "[[gripper.finger]]\ndirection = [-1.0, 0.0, 0.0]\n"
                                         "[[gripper.finger]]\nangle_rad = 3.14\n");
}

TEST(ScenarioKeys, EveryKeyOfASensorReachesTheFieldItNames) {
  expect_arrivals(sensor_arrivals(),
                  gripped_block("simulate") + "[sensor]\nat = \"wrist\"\nposition_m = [0.0, 0.0, 0.1]\n");
}

TEST(ScenarioKeys, EveryNetworkKeyReachesTheFieldItNames) { expect_arrivals(network_arrivals(), small_network()); }

TEST(ScenarioKeys, EveryKeyOfAScenarioIsCoveredByTheTestsAbove) {
  std::vector<std::string> covered;
  for (const auto& list :
       {lattice_arrivals(), surface_arrivals(), sensor_arrivals(), waypoint_arrivals(), flight_arrivals(),
        finger_arrivals(), robot_arrivals(), layer_arrivals(), network_arrivals()}) {
    for (const Arrival& arrival : list) covered.push_back(pattern_of(arrival.key));
  }
  for (const KeySpec& spec : key_table()) {
    if (spec.field == nullptr || spec.choices.size() == 1) continue;  // a single word has nothing to change to
    EXPECT_NE(std::find(covered.begin(), covered.end(), spec.path), covered.end()) << spec.path;
  }
}

TEST(ScenarioKeys, GripperKindIsAParallelJawUntilThereIsAnother) {
  const std::string text = gripped_block("simulate");
  const Study plain = study_of(text);
  const Study named = study_of(text, {"gripper.kind=parallel_jaw"});
  for (const Study& study : {plain, named, study_of(named.resolved_toml())}) {
    EXPECT_TRUE(std::holds_alternative<ParallelJawParameters>(study.scenario(0).gripper));
  }
  EXPECT_EQ(named.resolved_toml(), plain.resolved_toml());
  const std::vector<std::string> errors = testing::errors_of(text, {"gripper.kind=suction_cup"});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors.front().find("parallel_jaw"), std::string::npos) << errors.front();
}

}  // namespace
}  // namespace unbruised::studies
