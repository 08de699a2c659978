#include "core/scenario/plausible_parts.hpp"

namespace unbruised::plausible {

Rows robot_rows() {
  const std::string_view sheets = "data sheets of robot arms of 0.5 to 1,000 kg payload";
  const Slips torque = {{1e3, "N mm taken for N m"}, {1e2, "N cm taken for N m"}};
  return {
      plain("robot.base_place_m", "place of an arm's base", "m", 0.0, 10.0, kLength, "cells of robots"),
      plain("robot.tool_place_m", "length of a tool", "m", 0.0, 2.0, kLength, "grippers and their mounts"),
      plain("robot.flange_place_m", "place of a flange", "m", 0.0, 2.0, kLength, sheets),
      plain("robot.joint[].place_m", "place of an arm's joint", "m", 0.0, 4.0, kLength, sheets),
      plain("robot.joint[].center_of_mass_m", "centre of an arm's link", "m", 0.0, 3.0, kLength, sheets),
      plain("robot.joint[].mass_kg", "mass of an arm's link", "kg", 0.0, 3000.0, kMass, sheets),
      plain("robot.joint[].lower_rad", "least angle of a joint", "rad", 0.0, 13.0, kAngle, "two turns at most"),
      plain("robot.joint[].upper_rad", "largest angle of a joint", "rad", 0.0, 13.0, kAngle, "two turns at most"),
      plain("robot.joint[].speed_rad_s", "speed of a joint", "rad/s", 0.05, 30.0, kAngle, sheets),
      plain("robot.joint[].torque_N_m", "torque of a joint", "N m", 0.05, 30000.0, torque, sheets),
      plain("robot.acceleration_rad_s2", "acceleration of a joint", "rad/s2", 0.2, 500.0, kAngle, sheets),
      plain("robot.deceleration_rad_s2", "deceleration of a joint", "rad/s2", 0.2, 2000.0, kAngle, sheets),
      plain("robot.jerk_rad_s3", "jerk of a joint", "rad/s3", 2.0, 1e5, kAngle, "robot controllers"),
      plain("robot.stiffness_N_m_rad", "stiffness of a joint", "N m/rad", 200.0, 2e7, torque,
            "measured joints of arms of 3 to 500 kg payload"),
      plain("robot.bandwidth_Hz", "bandwidth of a joint", "Hz", 0.5, 300.0, {}, "controllers of joints"),
      plain("robot.seed_posture_rad", "angle of a posture", "rad", 0.0, 13.0, kAngle, "two turns at most"),
      plain("robot.gripper_mass_kg", "mass of a gripper", "kg", 0.0, 200.0, kMass, "data sheets of grippers"),
      plain("robot.gripper_center_of_mass_m", "centre of a gripper", "m", 0.0, 1.0, kLength,
            "data sheets of grippers"),
      plain("robot.max_payload_kg", "payload", "kg", 0.05, 3000.0, kMass, sheets),
  };
}

}  // namespace unbruised::plausible
