#pragma once

/// @file
/// Grips for tests that an arm carries.

#include "tests/core/robot/arms.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised::testing {

/// The usual grip, half a metre before the base of the six-jointed arm.
inline Scenario carried_grip() {
  Scenario scenario = usual_grip();
  scenario.robot = six_joints();
  scenario.robot.base_place_m = {-0.55, 0.1, 0.0};
  scenario.robot.gripper_mass_kg = 0.8;
  return scenario;
}

}  // namespace unbruised::testing
