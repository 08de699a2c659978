#pragma once

/// @file
/// The fields of the strategy: a part of the table of fields.hpp.

#include "core/scenario/field.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

template <FieldsOf<Waypoint> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [place_m, rotation_rad, quaternion, via_m, blend_m, speed_m_s, duration_s, wait_s] = p;
  visit({"place_m", Decides::run, kAnyNumber}, place_m);
  visit({"rotation_rad", Decides::run, kTilt}, rotation_rad);
  visit({"quaternion", Decides::run, kQuaternion}, quaternion);
  visit({"via_m", Decides::run, kAnyNumber}, via_m);
  visit({"blend_m", Decides::run, kNotNegative}, blend_m);
  visit({"speed_m_s", Decides::run, kPositive}, speed_m_s);
  visit({"duration_s", Decides::run, kPositive}, duration_s);
  visit({"wait_s", Decides::run, kNotNegative}, wait_s);
}

/// Waypoints have fields of their own.
template <FieldsOf<StrategyParameters> T, class Visit>
void visit_fields(T& p, Visit&& visit) {
  auto& [approach_speed_m_s, guard, guard_range_m, guard_force_N, guard_speed_m_s, grip_force_N, contact_force_N,
         grip_ramp_s, ramp_from_start, settle_s, pick, pick_offset_m, tracking_lag_s, profile,
         lift_acceleration_m_s2, transfer_acceleration_m_s2, lower_acceleration_m_s2, speed_m_s, jerk_m_s3,
         tilt_rad, tilt_speed_rad_s, tilt_acceleration_rad_s2, tilt_jerk_rad_s3, hold_s, release_height_m,
         place_settle_s, release_speed_m_s, recover_s, stop_time_s, repeat, waypoint] = p;
  visit({"approach_speed_m_s", Decides::run, kPositive}, approach_speed_m_s);
  visit({"guard", Decides::run}, guard);
  visit({"guard_range_m", Decides::run, kPositive}, guard_range_m);
  visit({"guard_force_N", Decides::run, kPositive}, guard_force_N);
  visit({"guard_speed_m_s", Decides::run, kNotNegative}, guard_speed_m_s);
  visit({"grip_force_N", Decides::run, kPositive}, grip_force_N);
  visit({"contact_force_N", Decides::run, kNotNegative}, contact_force_N);
  visit({"grip_ramp_s", Decides::run, kNotNegative}, grip_ramp_s);
  visit({"ramp_from_start", Decides::run}, ramp_from_start);
  visit({"settle_s", Decides::run, kNotNegative}, settle_s);
  visit({"pick", Decides::run}, pick);
  visit({"pick_offset_m", Decides::run, kAnyNumber}, pick_offset_m);
  visit({"tracking_lag_s", Decides::run, kNotNegative}, tracking_lag_s);
  visit({"profile", Decides::run}, profile);
  visit({"lift_acceleration_m_s2", Decides::run, kPositive}, lift_acceleration_m_s2);
  visit({"transfer_acceleration_m_s2", Decides::run, kPositive}, transfer_acceleration_m_s2);
  visit({"lower_acceleration_m_s2", Decides::run, kPositive}, lower_acceleration_m_s2);
  visit({"speed_m_s", Decides::run, kPositive}, speed_m_s);
  visit({"jerk_m_s3", Decides::run, kPositive}, jerk_m_s3);
  visit({"tilt_rad", Decides::run, kTilt}, tilt_rad);
  visit({"tilt_speed_rad_s", Decides::run, kPositive}, tilt_speed_rad_s);
  visit({"tilt_acceleration_rad_s2", Decides::run, kPositive}, tilt_acceleration_rad_s2);
  visit({"tilt_jerk_rad_s3", Decides::run, kPositive}, tilt_jerk_rad_s3);
  visit({"hold_s", Decides::run, kNotNegative}, hold_s);
  visit({"release_height_m", Decides::run, kNotNegative}, release_height_m);
  visit({"place_settle_s", Decides::run, kNotNegative}, place_settle_s);
  visit({"release_speed_m_s", Decides::run, kPositive}, release_speed_m_s);
  visit({"recover_s", Decides::run, kNotNegative}, recover_s);
  visit({"stop_time_s", Decides::run, kNotNegative}, stop_time_s);
  visit({"repeat", Decides::run, kHandlings}, repeat);
}

}  // namespace unbruised
