#include "core/scenario/gripper.hpp"

#include <gtest/gtest.h>

namespace unbruised {
namespace {

TEST(Gripper, OfAScenarioIsNoneUntilOneIsPutIn) {
  Scenario scenario;
  EXPECT_FALSE(has_gripper(scenario));
  EXPECT_EQ(parallel_jaw(scenario), nullptr);
  EXPECT_THROW(jaw_of(scenario), std::bad_variant_access);
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).stroke_m = 0.03;
  EXPECT_TRUE(has_gripper(scenario));
  ASSERT_NE(parallel_jaw(scenario), nullptr);
  EXPECT_EQ(&jaw_of(scenario), parallel_jaw(scenario));
  EXPECT_EQ(jaw_of(scenario).stroke_m, 0.03);
}

TEST(Gripper, AnswersWhateverItsKind) {
  ParallelJawParameters jaw;
  jaw.stroke_m = 0.02;
  jaw.drive_gain_N_s_m = 250.0;
  EXPECT_EQ(finger_stroke_m(jaw), 0.02);
  EXPECT_EQ(drive_gain_N_s_m(jaw), 250.0);
  EXPECT_FALSE(opening_m(jaw).has_value());
  jaw.opening_m = 0.08;
  EXPECT_EQ(opening_m(jaw), 0.08);
  for (const auto& answer : {finger_stroke_m(NoGripper{}), opening_m(NoGripper{}), drive_gain_N_s_m(NoGripper{})})
    EXPECT_FALSE(answer.has_value());
}

}  // namespace
}  // namespace unbruised
