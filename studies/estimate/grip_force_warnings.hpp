#pragma once

/// @file
/// What a gripper's data sheet says against the grip forces of a study.

#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Forces that the gripper cannot hold (gripper.min_force_N) or set (force_step_N), and an accuracy
/// (force_accuracy) that the study does not look at. Windows have their set-point for that: nothing is said of
/// them.
std::vector<std::string> grip_force_warnings(const Study& study);

}  // namespace unbruised::studies
