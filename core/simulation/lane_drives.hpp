#pragma once

/// @file
/// What a plan asks of one lane at a time: where the carriers are, and what the drives are told.

#include "core/gripper/gripper_lanes.hpp"
#include "core/gripper/pad_lanes.hpp"
#include "core/motion/motion_plan.hpp"
#include "core/simulation/lane_run.hpp"
#include "core/surface/carrier_motion.hpp"

namespace unbruised {

/// Puts the palm of a lane and the plane under its product where the plan has them at `time_s`.
void set_carriers(int lane, const MotionPlan& plan, double time_s, SupportPlane plane, CarrierMotion& motion);
/// The same for the plane alone.
void set_support(int lane, const MotionPlan& plan, double time_s, SupportPlane plane, CarrierMotion& motion);
/// Puts the surfaces that a lane's cell lists where they are at `time_s`.
void set_listed_surfaces(int lane, const CellParameters& cell, double time_s, CarrierMotion& motion);

/// Tells the drives of a lane what its plan wants of the next step.
/// @param carriers at t + theta dt
void command_drives(int lane, const LaneRun& run, const StepClock& clock, const GripperLanes& gripper,
                    const CarrierMotion& carriers, DriveCommand& command);

/// What accelerates each pad that is a body in the axes of the palm: gravity, less what its middle is accelerated
/// by as the palm moves and turns.
/// @param turns does any palm turn?
std::array<LaneVector, kJawFingers> pad_accelerations(const CarrierMotion& carriers,
                                                      const std::array<Lane, 3>& gravity_m_s2,
                                                      const PadLanes& pads, const GripperLanes& gripper,
                                                      bool turns);

}  // namespace unbruised
