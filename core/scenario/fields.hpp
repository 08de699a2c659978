#pragma once

/// @file
/// The one table of the parameters' fields: what each is called, what it decides, and in which range its numbers
/// lie. `number_fields` and `factor_key` are read from it. The structured bindings name all members of each
/// struct: a field that is added and not listed does not compile. Those of the arm and of the strategy stand in
/// robot_fields.hpp and strategy_fields.hpp.

#include <string_view>
#include <variant>

#include "core/scenario/field.hpp"
#include "core/scenario/robot_fields.hpp"
#include "core/scenario/scenario.hpp"
#include "core/scenario/strategy_fields.hpp"

namespace unbruised {

// visit_fields(parameters, visit) calls visit(Field, member) for each field, in the order of the struct.

template <FieldsOf<ProductLayer> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [from_depth_m, size_m, center_m, youngs_modulus_Pa, poisson_ratio, yield_stress_Pa, tangent_modulus_Pa] =
      p;
  visit({"from_depth_m", Decides::model, kPositive}, from_depth_m);
  visit({"size_m", Decides::model, kPositive}, size_m);
  visit({"center_m", Decides::model, kAnyNumber}, center_m);
  visit({"youngs_modulus_Pa", Decides::model, kPositive}, youngs_modulus_Pa);
  visit({"poisson_ratio", Decides::model, kPoissonRatio}, poisson_ratio);
  visit({"yield_stress_Pa", Decides::run, kPositive}, yield_stress_Pa);
  visit({"tangent_modulus_Pa", Decides::run, kPositive}, tangent_modulus_Pa);
}

/// Layers have fields of their own.
template <FieldsOf<LatticeParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [shape, size_m, axis, profile_height, profile_radius, exponents, mesh, cell_size_m, mass_kg, density_kg_m3,
         youngs_modulus_Pa, poisson_ratio, yield_stress_Pa, tangent_modulus_Pa, relaxation_time_s, loss_ratio,
         at_frequency_Hz, prony_modulus, prony_time_s, prony_from, burgers_flow_time_s, burgers_recovery_modulus,
         burgers_recovery_time_s, skin_thickness_m, skin_modulus_Pa, skin_poisson_ratio, friction,
         initial_velocity_m_s, initial_spin_rad_s, initial_rotation_rad, initial_height_m, layer] = p;
  visit({"shape", Decides::model}, shape);
  visit({"size_m", Decides::model, kPositive}, size_m);
  visit({"axis", Decides::model}, axis);
  visit({"profile_height", Decides::model, kAnyNumber}, profile_height);
  visit({"profile_radius", Decides::model, kAnyNumber}, profile_radius);
  visit({"exponents", Decides::model, kExponent}, exponents);
  visit({"mesh", Decides::model}, mesh);
  visit({"cell_size_m", Decides::model, kPositive}, cell_size_m);
  visit({"mass_kg", Decides::model, kPositive}, mass_kg);
  visit({"density_kg_m3", Decides::model, kPositive}, density_kg_m3);
  visit({"youngs_modulus_Pa", Decides::model, kPositive}, youngs_modulus_Pa);
  visit({"poisson_ratio", Decides::model, kPoissonRatio}, poisson_ratio);
  visit({"yield_stress_Pa", Decides::run, kPositive}, yield_stress_Pa);
  visit({"tangent_modulus_Pa", Decides::run, kPositive}, tangent_modulus_Pa);
  visit({"relaxation_time_s", Decides::model, kNotNegative}, relaxation_time_s);
  visit({"loss_ratio", Decides::model, kNotNegative}, loss_ratio);
  visit({"at_frequency_Hz", Decides::model, kPositive}, at_frequency_Hz);
  visit({"prony_modulus", Decides::model, kPronyShare}, prony_modulus);
  visit({"prony_time_s", Decides::model, kPositive}, prony_time_s);
  visit({"prony_from", Decides::model}, prony_from);
  visit({"burgers_flow_time_s", Decides::model, kPositive}, burgers_flow_time_s);
  visit({"burgers_recovery_modulus", Decides::model, kPositive}, burgers_recovery_modulus);
  visit({"burgers_recovery_time_s", Decides::model, kPositive}, burgers_recovery_time_s);
  visit({"skin_thickness_m", Decides::model, kPositive}, skin_thickness_m);
  visit({"skin_modulus_Pa", Decides::model, kPositive}, skin_modulus_Pa);
  visit({"skin_poisson_ratio", Decides::model, kPoissonRatio}, skin_poisson_ratio);
  visit({"friction", Decides::run, kNotNegative}, friction);
  visit({"initial_velocity_m_s", Decides::run, kAnyNumber}, initial_velocity_m_s);
  visit({"initial_spin_rad_s", Decides::run, kAnyNumber}, initial_spin_rad_s);
  visit({"initial_rotation_rad", Decides::run, kTilt}, initial_rotation_rad);
  visit({"initial_height_m", Decides::run, kNotNegative}, initial_height_m);
}

template <FieldsOf<NetworkParticle> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [position_m, mass_kg, fixed, initial_displacement_m, initial_velocity_m_s, contact_stiffness_N_m] = p;
  visit({"position_m", Decides::model, kAnyNumber}, position_m);
  visit({"mass_kg", Decides::model, kNotNegative}, mass_kg);
  visit({"fixed", Decides::model}, fixed);
  visit({"initial_displacement_m", Decides::run, kAnyNumber}, initial_displacement_m);
  visit({"initial_velocity_m_s", Decides::run, kAnyNumber}, initial_velocity_m_s);
  visit({"contact_stiffness_N_m", Decides::model, kNotNegative}, contact_stiffness_N_m);
}

template <FieldsOf<NetworkSpring> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [between, stiffness_N_m, damping_N_s_m, rest_length_m, yield_force_N, hardening_ratio, prony_modulus,
         prony_time_s, prony_from, burgers_flow_N_s_m, burgers_recovery_N_m, burgers_recovery_N_s_m] = p;
  visit({"between", Decides::model, kIndex}, between);
  visit({"stiffness_N_m", Decides::model, kNotNegative}, stiffness_N_m);
  visit({"damping_N_s_m", Decides::model, kNotNegative}, damping_N_s_m);
  visit({"rest_length_m", Decides::model, kPositive}, rest_length_m);
  visit({"yield_force_N", Decides::model, kPositive}, yield_force_N);
  visit({"hardening_ratio", Decides::model, kNotNegative}, hardening_ratio);
  visit({"prony_modulus", Decides::model, kPronyShare}, prony_modulus);
  visit({"prony_time_s", Decides::model, kPositive}, prony_time_s);
  visit({"prony_from", Decides::model}, prony_from);
  visit({"burgers_flow_N_s_m", Decides::model, kPositive}, burgers_flow_N_s_m);
  visit({"burgers_recovery_N_m", Decides::model, kPositive}, burgers_recovery_N_m);
  visit({"burgers_recovery_N_s_m", Decides::model, kPositive}, burgers_recovery_N_s_m);
}

template <FieldsOf<NetworkLoad> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [particle, time_s, force_N] = p;
  visit({"particle", Decides::run, kIndex}, particle);
  visit({"time_s", Decides::run, kAnyNumber}, time_s);
  visit({"force_N", Decides::run, kAnyNumber}, force_N);
}

/// Particles, springs and loads have fields of their own.
template <FieldsOf<NetworkParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [particles, springs, loads, friction] = p;
  visit({"friction", Decides::run, kNotNegative}, friction);
}

template <FieldsOf<NoGripper> T, class Visit>
void visit_fields(T&, Visit&&) {}

/// Pads, range sensors and listed fingers have fields of their own.
template <FieldsOf<ParallelJawParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [finger_mass_kg, stroke_m, pad_size_m, pad_thickness_m, pad_modulus_Pa, pad_poisson_ratio, pad_bulge,
         pad_edge_radius_m, pad_relaxation_time_s, drive_gain_N_s_m, drive_viscous_N_s_m, max_force_N,
         max_speed_m_s, coupling, min_force_N, force_accuracy, force_step_N, opening_m, force_rate_Hz, hold,
         lock_stiffness_N_m, curve_speed_m_s, curve_force_N, payload_kg, jaw_moment_N_m, finger_length_m,
         safety_factor, pad, range, finger] = p;
  visit({"finger_mass_kg", Decides::run, kPositive}, finger_mass_kg);
  visit({"stroke_m", Decides::run, kPositive}, stroke_m);
  visit({"pad_size_m", Decides::run, kPositive}, pad_size_m);
  visit({"pad_thickness_m", Decides::run, kPositive}, pad_thickness_m);
  visit({"pad_modulus_Pa", Decides::run, kPositive}, pad_modulus_Pa);
  visit({"pad_poisson_ratio", Decides::run, kRubberPoissonRatio}, pad_poisson_ratio);
  visit({"pad_bulge", Decides::run}, pad_bulge);
  visit({"pad_edge_radius_m", Decides::run, kNotNegative}, pad_edge_radius_m);
  visit({"pad_relaxation_time_s", Decides::run, kNotNegative}, pad_relaxation_time_s);
  visit({"drive_gain_N_s_m", Decides::run, kPositive}, drive_gain_N_s_m);
  visit({"drive_viscous_N_s_m", Decides::run, kNotNegative}, drive_viscous_N_s_m);
  visit({"max_force_N", Decides::run, kPositive}, max_force_N);
  visit({"max_speed_m_s", Decides::run, kPositive}, max_speed_m_s);
  visit({"coupling", Decides::run}, coupling);
  visit({"min_force_N", Decides::run, kNotNegative}, min_force_N);
  visit({"force_accuracy", Decides::run, kAccuracy}, force_accuracy);
  visit({"force_step_N", Decides::run, kNotNegative}, force_step_N);
  visit({"opening_m", Decides::run, kPositive}, opening_m);
  visit({"force_rate_Hz", Decides::run, kPositive}, force_rate_Hz);
  visit({"hold", Decides::run}, hold);
  visit({"lock_stiffness_N_m", Decides::run, kPositive}, lock_stiffness_N_m);
  visit({"curve_speed_m_s", Decides::run, kNotNegative}, curve_speed_m_s);
  visit({"curve_force_N", Decides::run, kNotNegative}, curve_force_N);
  visit({"payload_kg", Decides::run, kPositive}, payload_kg);
  visit({"jaw_moment_N_m", Decides::run, kPositive}, jaw_moment_N_m);
  visit({"finger_length_m", Decides::run, kPositive}, finger_length_m);
  visit({"safety_factor", Decides::run, kPositive}, safety_factor);
}

template <FieldsOf<PadParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [kind, shape, along, radius_m, half_angle_rad, profile_place_m, profile_height_m, law_depth_m, law_force_N,
         law_coefficients, cell_size_m, density_kg_m3] = p;
  visit({"kind", Decides::run}, kind);  // bodies add what they are made of: factor_key.cpp
  visit({"shape", Decides::run}, shape);
  visit({"along", Decides::run}, along);
  visit({"radius_m", Decides::run, kAnyNumber}, radius_m);
  visit({"half_angle_rad", Decides::run, kPositive}, half_angle_rad);
  visit({"profile_place_m", Decides::run, kAnyNumber}, profile_place_m);
  visit({"profile_height_m", Decides::run, kAnyNumber}, profile_height_m);
  visit({"law_depth_m", Decides::run, kNotNegative}, law_depth_m);
  visit({"law_force_N", Decides::run, kNotNegative}, law_force_N);
  visit({"law_coefficients", Decides::run, kAnyNumber}, law_coefficients);
  visit({"cell_size_m", Decides::run, kPositive}, cell_size_m);
  visit({"density_kg_m3", Decides::run, kPositive}, density_kg_m3);
}

template <FieldsOf<FingerParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [angle_rad, direction, offset_m] = p;
  visit({"angle_rad", Decides::run, kAnyNumber}, angle_rad);
  visit({"direction", Decides::run, kAnyNumber}, direction);
  visit({"offset_m", Decides::run, kAnyNumber}, offset_m);
}

template <FieldsOf<RangeSensorParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [maximum_m, offset_m, depth_m, rate_Hz, resolution_m, noise_m, noise_seed] = p;
  visit({"maximum_m", Decides::run, kPositive}, maximum_m);
  visit({"offset_m", Decides::run, kAnyNumber}, offset_m);
  visit({"depth_m", Decides::run, kAnyNumber}, depth_m);
  visit({"rate_Hz", Decides::run, kPositive}, rate_Hz);
  visit({"resolution_m", Decides::run, kNotNegative}, resolution_m);
  visit({"noise_m", Decides::run, kNotNegative}, noise_m);
  visit({"noise_seed", Decides::run, kIndex}, noise_seed);
}

/// The conveyor and the listed surfaces have fields of their own.
template <FieldsOf<CellParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [gravity_m_s2, support, support_friction, support_modulus_Pa, support_thickness_m, support_poisson_ratio,
         support_relaxation_time_s, approach_gap_m, grip_height_m, grip_offset_m, lift_height_m, transfer_m,
         place_height_m, place_velocity_m_s, target_plane, stop_deceleration_m_s2, conveyor, surface] = p;
  visit({"gravity_m_s2", Decides::run, kAnyNumber}, gravity_m_s2);
  visit({"support", Decides::run}, support);
  visit({"support_friction", Decides::run, kNotNegative}, support_friction);
  visit({"support_modulus_Pa", Decides::run, kPositive}, support_modulus_Pa);
  visit({"support_thickness_m", Decides::run, kPositive}, support_thickness_m);
  visit({"support_poisson_ratio", Decides::run, kRubberPoissonRatio}, support_poisson_ratio);
  visit({"support_relaxation_time_s", Decides::run, kNotNegative}, support_relaxation_time_s);
  visit({"approach_gap_m", Decides::run, kPositive}, approach_gap_m);
  visit({"grip_height_m", Decides::run, kAnyNumber}, grip_height_m);
  visit({"grip_offset_m", Decides::run, kAnyNumber}, grip_offset_m);
  visit({"lift_height_m", Decides::run, kNotNegative}, lift_height_m);
  visit({"transfer_m", Decides::run, kAnyNumber}, transfer_m);
  visit({"place_height_m", Decides::run, kAnyNumber}, place_height_m);
  visit({"place_velocity_m_s", Decides::run, kAnyNumber}, place_velocity_m_s);
  visit({"target_plane", Decides::run}, target_plane);
  visit({"stop_deceleration_m_s2", Decides::run, kPositive}, stop_deceleration_m_s2);
}

template <FieldsOf<ConveyorParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [speed_m_s, initial_speed_m_s, acceleration_m_s2, start_s, direction, length_m] = p;
  visit({"speed_m_s", Decides::run, kNotNegative}, speed_m_s);
  visit({"initial_speed_m_s", Decides::run, kNotNegative}, initial_speed_m_s);
  visit({"acceleration_m_s2", Decides::run, kPositive}, acceleration_m_s2);
  visit({"start_s", Decides::run, kNotNegative}, start_s);
  visit({"direction", Decides::run, kAnyNumber}, direction);
  visit({"length_m", Decides::run, kPositive}, length_m);
}

template <FieldsOf<CellSurfaceParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [center_m, normal, size_m, friction, modulus_Pa, thickness_m, relaxation_time_s, path_time_s, path_m] = p;
  visit({"center_m", Decides::run, kAnyNumber}, center_m);
  visit({"normal", Decides::run, kAnyNumber}, normal);
  visit({"size_m", Decides::run, kPositive}, size_m);
  visit({"friction", Decides::run, kNotNegative}, friction);
  visit({"modulus_Pa", Decides::run, kPositive}, modulus_Pa);
  visit({"thickness_m", Decides::run, kPositive}, thickness_m);
  visit({"relaxation_time_s", Decides::run, kNotNegative}, relaxation_time_s);
  visit({"path_time_s", Decides::run, kNotNegative}, path_time_s);
  visit({"path_m", Decides::run, kAnyNumber}, path_m);
}

template <FieldsOf<SixAxisSensorParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [at, model, element_stiffness_N_m, element_radius_m, element_count, ring_stiffness_N_m, stiffness_N_m,
         stiffness_N_m_rad, stiffness_matrix, damping_ratio, mass_kg, center_of_mass_m, inertia_kg_m2, position_m,
         report_at_m, tare, bandwidth_Hz, rate_Hz, resolution_N, resolution_N_m, range_N, range_N_m, noise_N,
         noise_N_m, noise_seed, motion_prediction] = p;
  visit({"at", Decides::run}, at);
  visit({"model", Decides::run}, model);
  visit({"element_stiffness_N_m", Decides::run, kPositive}, element_stiffness_N_m);
  visit({"element_radius_m", Decides::run, kPositive}, element_radius_m);
  visit({"element_count", Decides::run, kRingElements}, element_count);
  visit({"ring_stiffness_N_m", Decides::run, kNotNegative}, ring_stiffness_N_m);
  visit({"stiffness_N_m", Decides::run, kPositive}, stiffness_N_m);
  visit({"stiffness_N_m_rad", Decides::run, kPositive}, stiffness_N_m_rad);
  visit({"stiffness_matrix", Decides::run, kAnyNumber}, stiffness_matrix);
  visit({"damping_ratio", Decides::run, kAccuracy}, damping_ratio);
  visit({"mass_kg", Decides::run, kPositive}, mass_kg);
  visit({"center_of_mass_m", Decides::run, kAnyNumber}, center_of_mass_m);
  visit({"inertia_kg_m2", Decides::run, kPositive}, inertia_kg_m2);
  visit({"position_m", Decides::run, kAnyNumber}, position_m);
  visit({"report_at_m", Decides::run, kAnyNumber}, report_at_m);
  visit({"tare", Decides::run}, tare);
  visit({"bandwidth_Hz", Decides::run, kPositive}, bandwidth_Hz);
  visit({"rate_Hz", Decides::run, kPositive}, rate_Hz);
  visit({"resolution_N", Decides::run, kNotNegative}, resolution_N);
  visit({"resolution_N_m", Decides::run, kNotNegative}, resolution_N_m);
  visit({"range_N", Decides::run, kPositive}, range_N);
  visit({"range_N_m", Decides::run, kPositive}, range_N_m);
  visit({"noise_N", Decides::run, kNotNegative}, noise_N);
  visit({"noise_N_m", Decides::run, kNotNegative}, noise_N_m);
  visit({"noise_seed", Decides::run, kIndex}, noise_seed);
  visit({"motion_prediction", Decides::run}, motion_prediction);
}

template <FieldsOf<LimitParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [damage, permanent_set_m, plastic_strain, bruised_volume_m3, peak_pressure_Pa, absorbed_energy_J,
         finger_force_N, contact_yield_ratio, slip_m, slip_rad, place_error_m, place_attitude_rad] = p;
  visit({"damage", Decides::run}, damage);
  visit({"permanent_set_m", Decides::run, kNotNegative}, permanent_set_m);
  visit({"plastic_strain", Decides::run, kNotNegative}, plastic_strain);
  visit({"bruised_volume_m3", Decides::run, kNotNegative}, bruised_volume_m3);
  visit({"peak_pressure_Pa", Decides::run, kNotNegative}, peak_pressure_Pa);
  visit({"absorbed_energy_J", Decides::run, kNotNegative}, absorbed_energy_J);
  visit({"finger_force_N", Decides::run, kNotNegative}, finger_force_N);
  visit({"contact_yield_ratio", Decides::run, kNotNegative}, contact_yield_ratio);
  visit({"slip_m", Decides::run, kPositive}, slip_m);
  visit({"slip_rad", Decides::run, kPositive}, slip_rad);
  visit({"place_error_m", Decides::run, kPositive}, place_error_m);
  visit({"place_attitude_rad", Decides::run, kPositive}, place_attitude_rad);
}

template <FieldsOf<SimulationParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [time_step_s, theta, duration_s, initial_acceleration, trace_interval_s, pressure_patch_m, max_strain,
         max_rotation_rad, contact_set, levels, body, mode_count] = p;
  visit({"time_step_s", Decides::model, kPositive}, time_step_s);
  visit({"theta", Decides::model, kTheta}, theta);
  visit({"duration_s", Decides::run, kPositive}, duration_s);
  visit({"initial_acceleration", Decides::run}, initial_acceleration);
  visit({"trace_interval_s", Decides::run, kPositive}, trace_interval_s);
  visit({"pressure_patch_m", Decides::model, kPositive}, pressure_patch_m);
  visit({"max_strain", Decides::run, kPositive}, max_strain);
  visit({"max_rotation_rad", Decides::run, kPositive}, max_rotation_rad);
  visit({"contact_set", Decides::run}, contact_set);  // what it comes to enters the key: contact_set.hpp
  visit({"levels", Decides::run}, levels);
  visit({"body", Decides::run}, body);  // what they come to enters the key: body_modes.hpp
  visit({"mode_count", Decides::run, kModeCount}, mode_count);
}

/// Calls visit(prefix, index, parameters) for each struct of parameters that a scenario has: under which path its
/// fields stand, [] for a place in a list, and the place (-1: no list).
template <FieldsOf<Scenario> T, class Visit>
void visit_parameters(T& scenario, Visit&& visit) {
  auto& [product, gripper, cell, sensor, strategy, limits, simulation, robot] = scenario;
  const auto each = [&visit](std::string_view prefix, auto& list) {
    for (std::size_t i = 0; i < list.size(); ++i) visit(prefix, static_cast<int>(i), list[i]);
  };
  if (auto* lattice = std::get_if<LatticeParameters>(&product)) {
    each("product.layer[].", lattice->layer);
    visit("product.", -1, *lattice);
  }
  if (auto* network = std::get_if<NetworkParameters>(&product)) {
    each("product.particle[].", network->particle);
    each("product.spring[].", network->spring);
    each("product.load[].", network->load);
    visit("product.", -1, *network);
  }
  std::visit([&visit](auto& kind) { visit("gripper.", -1, kind); }, gripper);
  if (auto* jaw = std::get_if<ParallelJawParameters>(&gripper)) {
    visit("gripper.pad.", -1, jaw->pad);
    visit("gripper.range.", -1, jaw->range);
    each("gripper.finger[].", jaw->finger);
  }
  visit("cell.", -1, cell);
  visit("cell.conveyor.", -1, cell.conveyor);
  each("cell.surface[].", cell.surface);
  visit("sensor.", -1, sensor);
  visit("strategy.", -1, strategy);
  each("strategy.waypoint[].", strategy.waypoint);
  visit("limits.", -1, limits);
  visit("simulation.", -1, simulation);
  visit("robot.", -1, robot);
  each("robot.joint[].", robot.joint);
}

}  // namespace unbruised
