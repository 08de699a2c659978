#pragma once

/// @file
/// Every field of the parameters, visited one by one with its name and what it decides. The structured bindings
/// name all members of each struct: a field that is added and not visited does not compile.

#include <string>
#include <type_traits>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// What a field decides.
enum class Decides {
  model,  ///< the matrices, the contact model or their bits: it enters the factor key
  run,    ///< what happens to one scenario; lanes with one factor may differ in it
};

/// Is T, const or not, the parameter struct S?
template <class T, class S>
concept FieldsOf = std::is_same_v<std::remove_const_t<T>, S>;

template <FieldsOf<LatticeParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [shape, size_m, axis, cell_size_m, mass_kg, density_kg_m3, youngs_modulus_Pa, poisson_ratio,
         yield_stress_Pa, tangent_modulus_Pa, relaxation_time_s, loss_ratio, at_frequency_Hz, friction,
         initial_velocity_m_s] = p;
  visit("shape", Decides::model, shape);
  visit("size_m", Decides::model, size_m);
  visit("axis", Decides::model, axis);
  visit("cell_size_m", Decides::model, cell_size_m);
  visit("mass_kg", Decides::model, mass_kg);
  visit("density_kg_m3", Decides::model, density_kg_m3);
  visit("youngs_modulus_Pa", Decides::model, youngs_modulus_Pa);
  visit("poisson_ratio", Decides::model, poisson_ratio);
  visit("yield_stress_Pa", Decides::run, yield_stress_Pa);
  visit("tangent_modulus_Pa", Decides::run, tangent_modulus_Pa);
  visit("relaxation_time_s", Decides::model, relaxation_time_s);
  visit("loss_ratio", Decides::model, loss_ratio);
  visit("at_frequency_Hz", Decides::model, at_frequency_Hz);
  visit("friction", Decides::run, friction);
  visit("initial_velocity_m_s", Decides::run, initial_velocity_m_s);
}

template <FieldsOf<NetworkParticle> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [position_m, mass_kg, fixed, initial_displacement_m, initial_velocity_m_s, contact_stiffness_N_m] = p;
  visit("position_m", Decides::model, position_m);
  visit("mass_kg", Decides::model, mass_kg);
  visit("fixed", Decides::model, fixed);
  visit("initial_displacement_m", Decides::run, initial_displacement_m);
  visit("initial_velocity_m_s", Decides::run, initial_velocity_m_s);
  visit("contact_stiffness_N_m", Decides::model, contact_stiffness_N_m);
}

template <FieldsOf<NetworkSpring> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [between, stiffness_N_m, damping_N_s_m, rest_length_m, yield_force_N, hardening_ratio] = p;
  visit("between", Decides::model, between);
  visit("stiffness_N_m", Decides::model, stiffness_N_m);
  visit("damping_N_s_m", Decides::model, damping_N_s_m);
  visit("rest_length_m", Decides::model, rest_length_m);
  visit("yield_force_N", Decides::model, yield_force_N);
  visit("hardening_ratio", Decides::model, hardening_ratio);
}

template <FieldsOf<NetworkLoad> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [particle, time_s, force_N] = p;
  visit("particle", Decides::run, particle);
  visit("time_s", Decides::run, time_s);
  visit("force_N", Decides::run, force_N);
}

/// Particles, springs and loads are visited through their own fields.
template <FieldsOf<NetworkParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [particles, springs, loads, friction] = p;
  for (auto& particle : particles) visit_fields(particle, visit);
  for (auto& spring : springs) visit_fields(spring, visit);
  for (auto& load : loads) visit_fields(load, visit);
  visit("friction", Decides::run, friction);
}

template <FieldsOf<SimulationParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [time_step_s, theta, duration_s, initial_acceleration, trace_interval_s, pressure_patch_m, max_strain,
         max_rotation_rad] = p;
  visit("time_step_s", Decides::model, time_step_s);
  visit("theta", Decides::model, theta);
  visit("duration_s", Decides::run, duration_s);
  visit("initial_acceleration", Decides::run, initial_acceleration);
  visit("trace_interval_s", Decides::run, trace_interval_s);
  visit("pressure_patch_m", Decides::model, pressure_patch_m);
  visit("max_strain", Decides::run, max_strain);
  visit("max_rotation_rad", Decides::run, max_rotation_rad);
}

/// Product and numerics: gripper, cell, strategy and limits never enter a model, and are not visited.
template <FieldsOf<Scenario> T, class Visit>
void visit_fields(T& scenario, Visit&& visit) {
  auto& [product, gripper, cell, strategy, limits, simulation] = scenario;
  std::visit([&visit](auto& parameters) { visit_fields(parameters, visit); }, product);
  visit_fields(simulation, visit);
}

}  // namespace unbruised
