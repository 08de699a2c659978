#pragma once

/// @file
/// Arms for tests: two links in a plane, random ones, and one with six joints and a spherical wrist.

#include <cmath>
#include <random>

#include "core/robot/arm_dynamics.hpp"

namespace unbruised::testing {

inline constexpr double kPi = 3.141592653589793;

/// Two links along x that turn about z, each with its mass in its middle, palm at the end of the second.
struct TwoLinks {
  double l1 = 0.7, l2 = 0.4, m1 = 3.0, m2 = 2.0, I1 = 0.2, I2 = 0.05;

  [[nodiscard]] RobotParameters robot() const {
    RobotParameters out;
    out.joint.resize(2);
    out.joint[1].place_m = {l1, 0.0, 0.0};
    out.joint[0].mass_kg = m1;
    out.joint[1].mass_kg = m2;
    out.joint[0].center_of_mass_m = {0.5 * l1, 0.0, 0.0};
    out.joint[1].center_of_mass_m = {0.5 * l2, 0.0, 0.0};
    out.joint[0].inertia_kg_m2 = {0.0, I1, I1, 0.0, 0.0, 0.0};
    out.joint[1].inertia_kg_m2 = {0.0, I2, I2, 0.0, 0.0, 0.0};
    out.flange_place_m = {l2, 0.0, 0.0};
    out.tool_place_m = {};
    out.tool_rotation_rad = {};
    return out;
  }
};

/// Six joints as of a usual arm of 0.9 m; its flange looks down in the seed posture.
inline RobotParameters six_joints() {
  RobotParameters robot;
  robot.joint.resize(6);
  const std::array<std::array<double, 3>, 6> axes = {
      {{0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  const std::array<std::array<double, 3>, 6> places = {
      {{0, 0, 0.2}, {0.02, 0, 0.2}, {0, 0, 0.45}, {0.1, 0, 0.03}, {0.33, 0, 0}, {0.08, 0, 0}}};
  const std::array<double, 6> mass = {8.0, 10.0, 6.0, 3.0, 1.5, 0.3};
  for (std::size_t i = 0; i < 6; ++i) {
    ArmJointParameters& joint = robot.joint[i];
    joint.axis = axes[i];
    joint.place_m = places[i];
    joint.mass_kg = mass[i];
    joint.lower_rad = -3.0;
    joint.upper_rad = 3.0;
    joint.speed_rad_s = 4.0;
    joint.torque_N_m = i < 3 ? 200.0 : 30.0;
    const double I = 0.01 * mass[i];
    joint.inertia_kg_m2 = {I, I, I, 0.0, 0.0, 0.0};
  }
  robot.joint[1].center_of_mass_m = {0.0, 0.05, 0.2};
  robot.joint[2].center_of_mass_m = {0.05, 0.0, 0.02};
  // The flange's z points out of the arm, along the last joint's x.
  robot.flange_rotation_rad = {0.0, 0.5 * kPi, 0.0};
  robot.tool_place_m = {0.0, 0.0, 0.15};
  robot.tool_rotation_rad = {0.0, kPi, 0.0};
  robot.seed_posture_rad = {0.0, 0.3, 0.6, 0.0, 0.67, 0.0};
  return robot;
}

/// @param random in -1 .. 1
template <class Random>
RobotParameters random_arm(Random&& random, std::size_t joints) {
  const auto vector = [&](double size) {
    return std::array<double, 3>{size * random(), size * random(), size * random()};
  };
  RobotParameters robot;
  robot.joint.resize(joints);
  for (ArmJointParameters& joint : robot.joint) {
    joint.place_m = vector(0.5);
    joint.rotation_rad = vector(1.5);
    joint.axis = vector(2.0);
    joint.mass_kg = 5.0 * std::abs(random());
    joint.center_of_mass_m = vector(0.3);
    const double a = std::abs(random()), b = std::abs(random()), c = std::abs(random());
    joint.inertia_kg_m2 = {b + c, a + c, a + b, 0.1 * a * random(), 0.1 * b * random(), 0.1 * c * random()};
  }
  robot.base_place_m = vector(1.0);
  robot.base_rotation_rad = vector(1.5);
  robot.flange_place_m = vector(0.2);
  robot.flange_rotation_rad = vector(1.5);
  robot.tool_place_m = vector(0.2);
  robot.tool_rotation_rad = vector(1.5);
  return robot;
}

/// Numbers in -1 .. 1.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double operator()() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  Joints joints(std::size_t count, double size) {
    Joints out(count);
    for (double& x : out) x = size * (*this)();
    return out;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace unbruised::testing
