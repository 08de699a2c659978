#include "studies/findings/set_point.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "studies/findings/key_roles.hpp"

namespace unbruised::studies {
namespace {

SafeForces window(double least_N, double greatest_N) {
  return {.exists = true, .least_N = least_N, .greatest_N = greatest_N};
}

ForceSetting any_force() { return {.min_N = 0.0, .max_N = INFINITY, .accuracy = 0.0, .step_N = 0.0}; }

TEST(SetPoint, LeavesTheSameRatioToBothEnds) {
  const SetPoint found = set_point(window(1.0, 4.0), any_force());
  ASSERT_TRUE(found.exists);
  EXPECT_EQ(found.force_N, 2.0);  // 2 / 1 = 4 / 2
  EXPECT_EQ(found.tolerance_N, 1.0);
  EXPECT_EQ(found.sentence, "set 2 N, may be off by 1 N either way");
}

TEST(SetPoint, TakesTheAccuracyOffBothEnds) {
  ForceSetting gripper = any_force();
  gripper.accuracy = 0.1;
  const SetPoint found = set_point(window(0.9, 4.4), gripper);  // settings of 1 to 4 N are safe
  EXPECT_EQ(found.force_N, 2.0);
  EXPECT_EQ(found.tolerance_N, 1.0);
  EXPECT_EQ(found.sentence, "set 2 N, may be off by 1 N either way (beyond the gripper's own accuracy)");
}

TEST(SetPoint, IsANumberThatAPersonTypes) {
  EXPECT_EQ(set_point(window(1.271, 4.723), any_force()).force_N, 2.5);      // sqrt: 2.4501
  EXPECT_EQ(set_point(window(1.271, 4.723), any_force()).tolerance_N, 1.2);  // 2.5 - 1.271, down to two digits
  EXPECT_EQ(set_point(window(0.984, 1.09), any_force()).force_N, 1.04);      // sqrt: 1.0357; 1.05 costs too much
  EXPECT_EQ(set_point(window(8.3, 47.0), any_force()).force_N, 20.0);        // sqrt: 19.75
}

TEST(SetPoint, IsAMultipleOfTheGrippersStep) {
  ForceSetting gripper = any_force();
  gripper.step_N = 0.3;
  const SetPoint found = set_point(window(1.271, 4.723), gripper);
  EXPECT_DOUBLE_EQ(found.force_N, 2.4);  // of 1.5, 3 (costs too much), 2.4: multiples of 5, 2 x 0.3; sqrt 2.45
  gripper.step_N = 2.0;
  EXPECT_FALSE(set_point(window(2.1, 3.9), gripper).exists);
  EXPECT_EQ(set_point(window(2.1, 3.9), gripper).sentence,
            "not for this gripper: no multiple of its step of 2 N lies between 2.1 and 3.9 N");
}

TEST(SetPoint, SaysWhatAGripperCannotHold) {
  ForceSetting gripper = any_force();
  gripper.min_N = 3.0;
  gripper.max_N = 40.0;
  EXPECT_EQ(set_point(window(0.8, 1.9), gripper).sentence,
            "not for this gripper: it cannot hold less than 3 N, and the product is marked from 1.9 N on");
  EXPECT_EQ(set_point(window(50.0, 90.0), gripper).sentence,
            "not for this gripper: it cannot hold more than 40 N, and the product is held from 50 N on only");
  gripper.accuracy = 0.1;
  EXPECT_EQ(
      set_point(window(10.0, 11.0), gripper).sentence,
      "too narrow for this gripper: its force is off by up to 10 % either way, and the window is [10, 11] N");
  EXPECT_TRUE(
      set_point(window(2.0, 3.2), gripper).sentence.starts_with("not for this gripper: it holds 3 to 40 N"));
  EXPECT_EQ(set_point({}, gripper).sentence, "no window");
  EXPECT_EQ(set_point({.exists = true, .least_N = 1.5}, gripper).sentence,
            "damage is not judged, so nothing says how hard the product may be gripped; it is held from 1.5 N on");
}

TEST(SetPoint, StartsAtTheLeastForceWhereTheMiddleLiesBelowIt) {
  ForceSetting gripper = any_force();
  gripper.min_N = 3.0;
  const SetPoint found = set_point(window(1.0, 6.0), gripper);
  EXPECT_EQ(found.force_N, 3.0);
  EXPECT_EQ(found.tolerance_N, 2.0);  // to the end of the window, not to what can be set
}

TEST(SetPoint, LiesInsideWithItsToleranceAndAccuracyForAnyWindow) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  std::uniform_real_distribution<double> width(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double least_N = std::pow(10.0, exponent(random));
    const double greatest_N = least_N * std::pow(10.0, width(random));
    ForceSetting gripper = any_force();
    gripper.accuracy = 0.2 * width(random);
    gripper.step_N = i % 2 == 0 ? 0.0 : 0.05 * least_N * width(random);
    const SetPoint found = set_point(window(least_N, greatest_N), gripper);
    if (!found.exists) continue;
    const double room = 1.0 + 1e-9;  // arithmetic of a few operations
    EXPECT_GE((found.force_N - found.tolerance_N) * (1.0 - gripper.accuracy) * room, least_N) << i;
    EXPECT_LE((found.force_N + found.tolerance_N) * (1.0 + gripper.accuracy), greatest_N * room) << i;
    if (gripper.step_N <= 0.0) continue;
    const double steps = found.force_N / gripper.step_N;
    EXPECT_NEAR(steps, std::round(steps), 1e-9 * steps) << i;
  }
}

TEST(KeyRole, OnlyTheStrategyIsChosen) {
  EXPECT_EQ(key_role("strategy.approach_speed_m_s"), KeyRole::chosen);
  EXPECT_EQ(key_role("product.youngs_modulus_Pa"), KeyRole::given);
  EXPECT_EQ(key_role("product.use"), KeyRole::given);
  EXPECT_EQ(key_role("strategy.stop_time_s"), KeyRole::given);
  EXPECT_EQ(key_role("sensor.noise_seed"), KeyRole::given);
  EXPECT_EQ(key_role("gripper.range.noise_seed"), KeyRole::given);
  EXPECT_EQ(key_role("cell.support_friction"), KeyRole::given);
  EXPECT_EQ(key_role("gripper.use"), KeyRole::apart);
  EXPECT_EQ(key_role("limits.slip_m"), KeyRole::apart);
  EXPECT_EQ(key_role("simulation.time_step_s"), KeyRole::apart);
}

}  // namespace
}  // namespace unbruised::studies
