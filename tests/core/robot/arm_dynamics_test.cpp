// Torques of arms: the closed form of two links, an independent library on random arms, and the energy of a path.

#include "core/robot/arm_dynamics.hpp"

#include <gtest/gtest.h>
#include <kdl/chain.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "tests/core/robot/arms.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(ArmDynamics, TwoLinksHaveTheTorquesOfTheClosedForm) {
  // Craig, Introduction to Robotics, ch. 6; gravity along -y.
  const TwoLinks p;
  const double a = 0.5, b = 0.9, va = 1.3, vb = -0.7, aa = 2.0, ab = 3.0, g = 9.81;
  const Joints tau = joint_torques(Arm(p.robot()), {{a, b}, {va, vb}, {aa, ab}}, {}, {0.0, -g, 0.0});
  const double c1 = 0.5 * p.l1, c2 = 0.5 * p.l2, h = p.m2 * p.l1 * c2;
  const double m22 = p.I2 + p.m2 * c2 * c2, m12 = m22 + h * std::cos(b);
  const double m11 = p.I1 + p.m1 * c1 * c1 + m22 + p.m2 * p.l1 * p.l1 + 2.0 * h * std::cos(b);
  const double g2 = p.m2 * g * c2 * std::cos(a + b);
  const double g1 = (p.m1 * c1 + p.m2 * p.l1) * g * std::cos(a) + g2;
  EXPECT_NEAR(tau[0], m11 * aa + m12 * ab - h * std::sin(b) * (2.0 * va * vb + vb * vb) + g1, 1e-12);
  EXPECT_NEAR(tau[1], m12 * aa + m22 * ab + h * std::sin(b) * va * va + g2, 1e-12);
}

TEST(ArmDynamics, ALoadAtRestWeighsWithItsLever) {
  const TwoLinks p;
  const Arm arm(p.robot());
  const ArmMotion still{{0.3, 0.2}, {0.0, 0.0}, {0.0, 0.0}};
  const Joints empty = joint_torques(arm, still, {}, {0.0, -9.81, 0.0});
  const Joints loaded = joint_torques(arm, still, {{1.5, {0.1, 0.0, 0.0}}}, {0.0, -9.81, 0.0});
  EXPECT_NEAR(loaded[1] - empty[1], 1.5 * 9.81 * (p.l2 + 0.1) * std::cos(0.5), 1e-12);
}

KDL::Frame frame_of(const std::array<double, 3>& place, const std::array<double, 3>& rotation) {
  const Attitude q = attitude_of(rotation);
  return {KDL::Rotation::Quaternion(q.axis[0], q.axis[1], q.axis[2], q.w),
          KDL::Vector(place[0], place[1], place[2])};
}

/// The same arm for KDL: a fixed segment with the place of each joint, then the joint at its root with its link.
KDL::Chain chain_of(const RobotParameters& robot, const std::vector<PointLoad>& loads) {
  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(), frame_of(robot.base_place_m, robot.base_rotation_rad)));
  for (const ArmJointParameters& joint : robot.joint) {
    chain.addSegment(KDL::Segment(KDL::Joint(), frame_of(joint.place_m, joint.rotation_rad)));
    const auto& [xx, yy, zz, xy, xz, yz] = joint.inertia_kg_m2;
    const auto& c = joint.center_of_mass_m;
    // KDL takes moments about the centre of mass.
    const KDL::RigidBodyInertia own(joint.mass_kg, KDL::Vector(c[0], c[1], c[2]),
                                    KDL::RotationalInertia(xx, yy, zz, xy, xz, yz));
    chain.addSegment(
        KDL::Segment(KDL::Joint(KDL::Vector(0, 0, 0), KDL::Vector(joint.axis[0], joint.axis[1], joint.axis[2]),
                                KDL::Joint::RotAxis),
                     KDL::Frame::Identity(), own));
  }
  KDL::RigidBodyInertia carried = KDL::RigidBodyInertia::Zero();
  for (const PointLoad& load : loads) {
    carried = carried +
              KDL::RigidBodyInertia(load.mass_kg, KDL::Vector(load.place_m[0], load.place_m[1], load.place_m[2]));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(), frame_of(robot.flange_place_m, robot.flange_rotation_rad), carried));
  return chain;
}

TEST(ArmDynamics, AgreeWithAnotherLibraryOnRandomArms) {
  Numbers numbers(4);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t n = 1 + static_cast<std::size_t>(trial) % kMostArmJoints;
    const RobotParameters robot = random_arm(numbers, n);
    const std::vector<PointLoad> loads = {{std::abs(numbers()), {0.1 * numbers(), 0.1 * numbers(), 0.2}},
                                          {0.5, {0.0, 0.1, 0.1 * numbers()}}};
    const ArmMotion motion{numbers.joints(n, 3.0), numbers.joints(n, 2.0), numbers.joints(n, 5.0)};
    const std::array<double, 3> g = {numbers(), numbers(), -9.81};
    const Joints own = joint_torques(Arm(robot), motion, loads, g);

    const KDL::Chain chain = chain_of(robot, loads);
    ASSERT_EQ(chain.getNrOfJoints(), n);
    KDL::JntArray q(static_cast<unsigned>(n)), v(q), a(q), torque(q);
    for (unsigned i = 0; i < n; ++i) {
      q(i) = motion.angle_rad[i];
      v(i) = motion.speed_rad_s[i];
      a(i) = motion.acceleration_rad_s2[i];
    }
    const KDL::Wrenches none(chain.getNrOfSegments(), KDL::Wrench::Zero());
    KDL::ChainIdSolver_RNE solver(chain, KDL::Vector(g[0], g[1], g[2]));
    ASSERT_EQ(solver.CartToJnt(q, v, a, none, torque), 0);
    double size = 1.0;
    for (const double t : own) size = std::max(size, std::abs(t));
    // Both sum some hundred products: relative round-off of 1e-13.
    for (unsigned i = 0; i < n; ++i) EXPECT_NEAR(own[i], torque(i), 1e-9 * size) << "trial " << trial;
  }
}

TEST(ArmDynamics, TheWorkOfTheTorquesIsWhatTheArmGains) {
  // q = A sin(w t), each joint its own; Simpson's rule over the power.
  Numbers numbers(5);
  const Arm arm(random_arm(numbers, 6));
  const std::vector<PointLoad> loads = {{1.2, {0.05, 0.0, 0.1}}};
  const std::array<double, 3> g = {0.0, 0.0, -9.80665};
  const Joints A = numbers.joints(6, 1.5), w = numbers.joints(6, 3.0);
  const auto at = [&](double t) {
    ArmMotion motion;
    for (std::size_t j = 0; j < 6; ++j) {
      motion.angle_rad.push_back(A[j] * std::sin(w[j] * t));
      motion.speed_rad_s.push_back(A[j] * w[j] * std::cos(w[j] * t));
      motion.acceleration_rad_s2.push_back(-A[j] * w[j] * w[j] * std::sin(w[j] * t));
    }
    return motion;
  };
  const auto power = [&](double t) {
    const ArmMotion motion = at(t);
    const Joints tau = joint_torques(arm, motion, loads, g);
    double sum = 0.0;
    for (std::size_t j = 0; j < 6; ++j) sum += tau[j] * motion.speed_rad_s[j];
    return sum;
  };
  const double T = 1.3;
  const int n = 2000;
  double work = power(0.0) + power(T);
  for (int i = 1; i < n; ++i) work += (i % 2 == 1 ? 4.0 : 2.0) * power(T * i / n);
  work *= T / n / 3.0;
  const ArmEnergy before = arm_energy(arm, at(0.0), loads, g), after = arm_energy(arm, at(T), loads, g);
  const double gained = after.kinetic_J + after.potential_J - before.kinetic_J - before.potential_J;
  EXPECT_GT(std::abs(gained), 1.0);
  // Simpson's error falls with h^4: 1e-12 of the fifth derivative; measured below 1e-9.
  EXPECT_NEAR(work, gained, 1e-7 * (std::abs(gained) + before.kinetic_J));
}

}  // namespace
}  // namespace unbruised
