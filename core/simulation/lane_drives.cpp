#include "core/simulation/lane_drives.hpp"

#include "core/lanes/lane_rotation.hpp"
#include "core/motion/surface_path.hpp"

namespace unbruised {

namespace {

void set_carrier(int lane, const PalmState& state, std::array<AxisMotion, 3>& carrier) {
  for (std::size_t i = 0; i < 3; ++i) {
    set_motion(carrier[i], lane, {state.position_m[i], state.velocity_m_s[i], state.acceleration_m_s2[i]});
  }
}

}  // namespace

void set_carriers(int lane, const MotionPlan& plan, double time_s, SupportPlane plane, CarrierMotion& motion) {
  const PalmState palm = plan.palm(time_s);
  set_carrier(lane, palm, motion.palm);
  for (std::size_t i = 0; i < 3; ++i) {
    motion.palm_rotation_rad[i].set(lane, palm.rotation_rad[i]);
    motion.palm_spin_rad_s[i].set(lane, palm.spin_rad_s[i]);
    motion.palm_spin_acceleration_rad_s2[i].set(lane, palm.spin_acceleration_rad_s2[i]);
  }
  set_support(lane, plan, time_s, plane, motion);
}

void set_support(int lane, const MotionPlan& plan, double time_s, SupportPlane plane, CarrierMotion& motion) {
  set_carrier(lane, plan.support(plane, time_s), motion.cell);
}

void set_listed_surfaces(int lane, const CellParameters& cell, double time_s, CarrierMotion& motion) {
  for (std::size_t s = 0; s < cell.surface.size(); ++s) {
    const SurfaceMotion state = surface_motion(cell.surface[s], time_s);
    for (std::size_t i = 0; i < 3; ++i) {
      set_motion(motion.listed[s][i], lane, {state.place_m[i], state.velocity_m_s[i], state.acceleration_m_s2[i]});
    }
  }
}

void command_drives(int lane, const MotionPlan& plan, double time_s, const GripperLanes& gripper,
                    const CarrierMotion& carriers, DriveCommand& command) {
  command.palm_acceleration_x_m_s2.set(lane, carriers.palm[normal_axis(kLeftPad)].acceleration_m_s2[lane]);
  const std::array<double, 3> spin = turned(inverse(attitude_of(of_lane(carriers.palm_rotation_rad, lane))),
                                            of_lane(carriers.palm_spin_rad_s, lane));
  command.centrifugal_1_s2.set(lane, spin[1] * spin[1] + spin[2] * spin[2]);
  command.force_limit_N.set(lane, plan.force_limit_N(time_s));
  command.told.set(lane, plan.told(time_s));
  command.locked.set(lane, plan.locked(time_s));
  double speed = plan.set_speed_m_s(time_s);
  // Opened is where the fingers started; inwards the stroke ends at a stop.
  if (speed < 0.0 && gripper.furthest_way()[lane] <= 0.0) speed = 0.0;
  command.set_speed_m_s.set(lane, speed);
}

std::array<LaneVector, kFingerCount> pad_accelerations(const CarrierMotion& carriers,
                                                       const std::array<Lane, 3>& gravity_m_s2,
                                                       const PadLanes& pads, const GripperLanes& gripper,
                                                       bool turns) {
  LaneVector outer;
  for (std::size_t i = 0; i < 3; ++i) outer[i] = gravity_m_s2[i] - carriers.palm[i].acceleration_m_s2;
  std::array<LaneVector, kFingerCount> of_pad;
  of_pad.fill(outer);
  if (!turns) return of_pad;
  const LaneMatrix back = transposed(rotation_by(carriers.palm_rotation_rad).matrix());
  const LaneVector spin = back * carriers.palm_spin_rad_s;
  const LaneVector faster = back * carriers.palm_spin_acceleration_rad_s2;
  for (int pad = 0; pad < kFingerCount; ++pad) {
    const LaneVector at = pads.middle_m(pad, gripper);
    of_pad[static_cast<std::size_t>(pad)] = back * outer - cross(faster, at) - cross(spin, cross(spin, at));
  }
  return of_pad;
}

}  // namespace unbruised
