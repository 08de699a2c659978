// How the opening of a gripper, the width of the product and the approach gap go together.

#include "core/scenario/opening.hpp"

#include <gtest/gtest.h>

#include "core/scenario/rules.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Opening, LeavesTheSameGapOnEitherSideOfTheProduct) {
  Scenario scenario = usual_grip();
  EXPECT_EQ(approach_gap_m(scenario), kUsualApproachGap_m);
  jaw_of(scenario).opening_m = 0.08;
  EXPECT_DOUBLE_EQ(approach_gap_m(scenario), 0.015);
  lattice_in(scenario).size_m[0] = 0.06;  // another product in the same gripper
  EXPECT_DOUBLE_EQ(approach_gap_m(scenario), 0.01);
  EXPECT_TRUE(validate(scenario).empty());
}

TEST(Opening, MayStandBesideAGapThatAgreesWithIt) {
  Scenario scenario = usual_grip();
  jaw_of(scenario).opening_m = 0.08;
  scenario.cell.approach_gap_m = 0.015;
  EXPECT_TRUE(validate(scenario).empty());
  scenario.cell.approach_gap_m = 0.016;
  ASSERT_EQ(validate(scenario).size(), 1U);
  EXPECT_EQ(
      validate(scenario)[0].rule,
      "contradicts gripper.opening_m = 0.08, which leaves 0.015 m on either side of the product; leave one of "
      "them out");
}

TEST(Opening, IsWiderThanTheProduct) {
  Scenario scenario = usual_grip();
  jaw_of(scenario).opening_m = 0.05;
  const Violations broken = validate(scenario);
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].field, "gripper.opening_m");
  EXPECT_EQ(broken[0].rule, "must be > product.size_m[0] = 0.05: the product is wider than the open gripper");
}

TEST(Opening, IsClosedByAStrokeThatReaches) {
  Scenario scenario = usual_grip();
  jaw_of(scenario).opening_m = 0.14;
  const Violations broken = validate(scenario);
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].field, "gripper.stroke_m");
  EXPECT_EQ(broken[0].rule, "must be > the way to the product, 0.045 m: the fingers never reach it");
}

}  // namespace
}  // namespace unbruised
