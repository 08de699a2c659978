#pragma once

/// @file
/// The parts of `key_table()`, one function for each table of a study's file.

#include <vector>

#include "studies/config/schema.hpp"

namespace unbruised::studies::key_rows {

using Table = std::vector<KeySpec>;

Table study_keys();
Table goal_keys();
Table algorithm_keys();
Table sampling_keys();
Table compare_keys();
Table sensitivity_keys();
Table shape_keys();
Table material_keys();
Table relaxation_keys();
Table skin_keys();
Table network_file_keys();
Table layer_keys();
Table particle_keys();
Table spring_and_load_keys();
Table spring_relaxation_keys();
Table finger_and_pad_keys();
Table drive_keys();
Table holding_keys();
Table data_sheet_keys();
Table pad_keys();
Table finger_list_keys();
Table range_keys();
Table support_keys();
Table path_keys();
Table conveyor_keys();
Table surface_keys();
Table sensor_keys();
Table robot_keys();
Table arm_joint_keys();
Table grip_keys();
Table guard_keys();
Table pick_keys();
Table motion_keys();
Table waypoint_keys();
Table limit_keys();
Table simulation_keys();
Table vary_keys();
Table calibrate_keys();
Table parameter_keys();
Table specimen_keys();
Table variable_keys();
Table random_keys();
Table random_bound_keys();
Table correlation_keys();
Table candidate_keys();

}  // namespace unbruised::studies::key_rows
