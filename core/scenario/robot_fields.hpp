#pragma once

/// @file
/// The fields of the arm: a part of the table of fields.hpp.

#include "core/scenario/field.hpp"
#include "core/scenario/robot.hpp"

namespace unbruised {

template <FieldsOf<ArmJointParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [place_m, rotation_rad, axis, lower_rad, upper_rad, speed_rad_s, torque_N_m, mass_kg, center_of_mass_m,
         inertia_kg_m2] = p;
  visit({"place_m", Decides::run, kAnyNumber}, place_m);
  visit({"rotation_rad", Decides::run, kTilt}, rotation_rad);
  visit({"axis", Decides::run, kAnyNumber}, axis);
  visit({"lower_rad", Decides::run, kAnyNumber}, lower_rad);
  visit({"upper_rad", Decides::run, kAnyNumber}, upper_rad);
  visit({"speed_rad_s", Decides::run, kPositive}, speed_rad_s);
  visit({"torque_N_m", Decides::run, kPositive}, torque_N_m);
  visit({"mass_kg", Decides::run, kNotNegative}, mass_kg);
  visit({"center_of_mass_m", Decides::run, kAnyNumber}, center_of_mass_m);
  visit({"inertia_kg_m2", Decides::run, kAnyNumber}, inertia_kg_m2);
}

/// Joints have fields of their own.
template <FieldsOf<RobotParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [base_place_m, base_rotation_rad, flange_place_m, flange_rotation_rad, tool_place_m, tool_rotation_rad,
         seed_posture_rad, acceleration_rad_s2, deceleration_rad_s2, jerk_rad_s3, stiffness_N_m_rad, damping_ratio,
         bandwidth_Hz, gripper_mass_kg, gripper_center_of_mass_m, max_payload_kg, timing, use_most, joint] = p;
  visit({"base_place_m", Decides::run, kAnyNumber}, base_place_m);
  visit({"base_rotation_rad", Decides::run, kTilt}, base_rotation_rad);
  visit({"flange_place_m", Decides::run, kAnyNumber}, flange_place_m);
  visit({"flange_rotation_rad", Decides::run, kTilt}, flange_rotation_rad);
  visit({"tool_place_m", Decides::run, kAnyNumber}, tool_place_m);
  visit({"tool_rotation_rad", Decides::run, kTilt}, tool_rotation_rad);
  visit({"seed_posture_rad", Decides::run, kAnyNumber}, seed_posture_rad);
  visit({"acceleration_rad_s2", Decides::run, kPositive}, acceleration_rad_s2);
  visit({"deceleration_rad_s2", Decides::run, kPositive}, deceleration_rad_s2);
  visit({"jerk_rad_s3", Decides::run, kPositive}, jerk_rad_s3);
  visit({"stiffness_N_m_rad", Decides::run, kPositive}, stiffness_N_m_rad);
  visit({"damping_ratio", Decides::run, kDampingRatio}, damping_ratio);
  visit({"bandwidth_Hz", Decides::run, kPositive}, bandwidth_Hz);
  visit({"gripper_mass_kg", Decides::run, kNotNegative}, gripper_mass_kg);
  visit({"gripper_center_of_mass_m", Decides::run, kAnyNumber}, gripper_center_of_mass_m);
  visit({"max_payload_kg", Decides::run, kPositive}, max_payload_kg);
  visit({"timing", Decides::run}, timing);
  visit({"use_most", Decides::run, kUse}, use_most);
}

}  // namespace unbruised
