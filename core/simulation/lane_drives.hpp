#pragma once

/// @file
/// What a plan asks of one lane at a time: where the carriers are, and what the drives are told.

#include "core/gripper/gripper_lanes.hpp"
#include "core/motion/motion_plan.hpp"
#include "core/surface/carrier_motion.hpp"

namespace unbruised {

/// Puts the palm of a lane where the plan has it at `time_s`, and the support at its height.
void set_carriers(int lane, const MotionPlan& plan, double time_s, double support_height_m, CarrierMotion& motion);

/// Tells the drives of a lane what the plan wants at `time_s`.
/// @param carriers at that time
void command_drives(int lane, const MotionPlan& plan, double time_s, const GripperLanes& gripper,
                    const CarrierMotion& carriers, DriveCommand& command);

}  // namespace unbruised
