#pragma once

/// @file
/// What the cycle asks of a gripper, whatever its kind. Another kind answers here, and whoever asks stays as he
/// is.

#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// How far each finger can close from its starting place [m]; none: nothing closes.
std::optional<double> finger_stroke_m(const GripperParameters& gripper);

/// Distance of the pad faces when it is open [m]; none: it is not given.
std::optional<double> opening_m(const GripperParameters& gripper);

/// Force of a drive over what its speed lacks of the one that is set [N s/m]; none: no drive regulates a speed.
std::optional<double> drive_gain_N_s_m(const GripperParameters& gripper);

/// Its fingers; of a cell without a gripper those of a jaw, which never touch.
int finger_count(const Scenario& scenario);

/// Does a gripper list its fingers?
bool lists_fingers(const Scenario& scenario);

/// Are there range sensors in its fingers?
bool has_range_sensors(const Scenario& scenario);

}  // namespace unbruised
