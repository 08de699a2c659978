#include "core/simulation/lane_drives.hpp"

namespace unbruised {

void set_carriers(int lane, const MotionPlan& plan, double time_s, double support_height_m,
                  CarrierMotion& motion) {
  const PalmState palm = plan.palm(time_s);
  for (std::size_t i = 0; i < 3; ++i) {
    set_motion(motion.palm[i], lane, {palm.position_m[i], palm.velocity_m_s[i], palm.acceleration_m_s2[i]});
  }
  set_motion(motion.cell[normal_axis(kSupport)], lane, {support_height_m, 0.0, 0.0});
}

void command_drives(int lane, const MotionPlan& plan, double time_s, const GripperLanes& gripper,
                    const CarrierMotion& carriers, DriveCommand& command) {
  command.palm_acceleration_x_m_s2.set(lane, carriers.palm[normal_axis(kLeftPad)].acceleration_m_s2[lane]);
  command.force_limit_N.set(lane, plan.force_limit_N(time_s));
  double speed = plan.set_speed_m_s(time_s);
  // Opened is where the fingers started; inwards the stroke ends at a stop.
  if (speed < 0.0 && gripper.furthest_way()[lane] <= 0.0) speed = 0.0;
  command.set_speed_m_s.set(lane, speed);
}

}  // namespace unbruised
