// Geometry of arms: closed forms of two links, differences of the palm, postures found again.

#include "core/robot/arm.hpp"

#include <gtest/gtest.h>

#include "core/scenario/vectors.hpp"
#include "tests/core/robot/arms.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Arm, TwoLinksReachWhereTheClosedFormSays) {
  const TwoLinks two;
  const Arm arm(two.robot());
  const double a = 0.4, b = -1.1;
  const Pose palm = arm.palm({a, b});
  EXPECT_NEAR(palm.place_m[0], two.l1 * std::cos(a) + two.l2 * std::cos(a + b), 1e-15);
  EXPECT_NEAR(palm.place_m[1], two.l1 * std::sin(a) + two.l2 * std::sin(a + b), 1e-15);
  EXPECT_NEAR(rotation_to(palm.attitude)[2], a + b, 1e-15);
}

TEST(Arm, TheInverseOfTwoLinksIsTheClosedFormOnTheBranchOfTheSeed) {
  const TwoLinks two;
  const Arm arm(two.robot());
  for (const double side : {-1.0, 1.0}) {
    const double a = 0.3, b = side * 1.2;
    const auto found = posture_for(arm, arm.palm({a, b}), {0.1, side * 0.8}, false);
    ASSERT_TRUE(found);
    // cos b = (x^2 + y^2 - l1^2 - l2^2) / (2 l1 l2), with the sign of the elbow.
    const auto place = arm.palm({a, b}).place_m;
    const double cosine =
        (place[0] * place[0] + place[1] * place[1] - two.l1 * two.l1 - two.l2 * two.l2) / (2.0 * two.l1 * two.l2);
    EXPECT_NEAR((*found)[1], side * std::acos(cosine), 1e-8);
    EXPECT_NEAR((*found)[0], a, 1e-8);
  }
}

TEST(Arm, TheJacobianIsTheDerivativeOfThePalm) {
  Numbers numbers(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Arm arm(random_arm(numbers, 6));
    const Joints q = numbers.joints(6, 2.0);
    const std::vector<Twist> J = arm.jacobian(q);
    const double h = 1e-6;
    for (std::size_t j = 0; j < 6; ++j) {
      Joints more = q, fewer = q;
      more[j] += h;
      fewer[j] -= h;
      const Pose after = arm.palm(more), before = arm.palm(fewer);
      const auto turn = rotation_to(after.attitude * inverse(before.attitude));
      for (std::size_t d = 0; d < 3; ++d) {
        // Central differences: h^2 of the third derivative, and round-off over h.
        EXPECT_NEAR(J[j].linear[d], (after.place_m[d] - before.place_m[d]) / (2.0 * h), 1e-8);
        EXPECT_NEAR(J[j].angular[d], turn[d] / (2.0 * h), 1e-8);
      }
    }
  }
}

TEST(Arm, TheBiasIsTheAccelerationOfThePalmAtSteadyJointSpeeds) {
  Numbers numbers(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Arm arm(random_arm(numbers, 6));
    const Joints q = numbers.joints(6, 2.0), speed = numbers.joints(6, 1.0);
    const double h = 1e-4;
    const auto at = [&](double t) {
      Joints angle = q;
      for (std::size_t j = 0; j < 6; ++j) angle[j] += t * speed[j];
      return arm.palm(angle).place_m;
    };
    const auto before = at(-h), now = at(0.0), after = at(h);
    const Twist bias = arm.bias(q, speed);
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_NEAR(bias.linear[d], (after[d] - 2.0 * now[d] + before[d]) / (h * h), 2e-6);
    }
  }
}

TEST(Arm, PosturesNearbyAreFoundAgain) {
  Numbers numbers(3);
  const Arm arm(six_joints());
  for (int trial = 0; trial < 50; ++trial) {
    Joints q = arm.seed_rad(), from = q;
    for (std::size_t j = 0; j < 6; ++j) {
      q[j] += 0.25 * numbers();
      from[j] = q[j] + 0.1 * numbers();
    }
    const auto found = posture_for(arm, arm.palm(q), from, false);
    ASSERT_TRUE(found);
    for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR((*found)[j], q[j], 1e-7);
  }
}

TEST(Arm, APlaceBeyondItsReachHasNoPosture) {
  const Arm arm(six_joints());
  EXPECT_FALSE(posture_for(arm, pose_of({2.5, 0.0, 0.2}, {}), arm.seed_rad(), false));
}

TEST(Arm, AStretchedElbowIsSingular) {
  const Arm arm(TwoLinks().robot());
  // Of two links both singular values stay above 0: the palm turns with them even when it cannot come nearer.
  EXPECT_GT(manipulability(arm.jacobian({0.0, 0.0})), 0.1);
  const Arm six(six_joints());
  Joints straight = six.seed_rad();
  straight[4] = 0.0;  // joints 3 and 5 turn about one axis
  EXPECT_LT(manipulability(six.jacobian(straight)), 1e-12);
  EXPECT_GT(manipulability(six.jacobian(six.seed_rad())), 0.02);
}

TEST(Arm, HalfOfTheRangeIsCountedFromItsMiddle) {
  RobotParameters robot = TwoLinks().robot();
  robot.joint[0].lower_rad = -1.0;
  robot.joint[0].upper_rad = 3.0;
  const Arm arm(robot);
  EXPECT_DOUBLE_EQ(arm.position_use(0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(arm.position_use(0, 2.0), 0.5);
  EXPECT_DOUBLE_EQ(arm.position_use(0, -1.0), 1.0);
  EXPECT_DOUBLE_EQ(arm.position_use(1, 5.0), 0.0);
}

}  // namespace
}  // namespace unbruised
