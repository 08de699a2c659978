// Where pads meet a product that curves away from them.

#include "core/scenario/pad_meeting.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario grip_of(Shape shape, double size_m, double height_m, double pad_m) {
  Scenario scenario = usual_grip();
  lattice_in(scenario).shape = shape;
  lattice_in(scenario).size_m = {size_m, size_m, size_m};
  jaw_of(scenario).pad_size_m = {pad_m, pad_m};
  scenario.cell.grip_height_m = height_m;
  return scenario;
}

TEST(PadMeeting, IsAtThePoleWhileThePadCoversIt) {
  const auto meeting = pad_meeting(grip_of(Shape::ellipsoid, 0.05, 0.0049, 0.01));
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->depth_share, 0.0);
  EXPECT_NEAR(meeting->lean_rad, 0.0, 1e-7) << "arc cosine of one to the last bit";
}

TEST(PadMeeting, OfASphereIsAtTheNearerEdge) {
  // The pad's lower edge stands 15 mm above the middle of a ball of radius 25 mm.
  for (const double sign : {1.0, -1.0}) {
    const auto meeting = pad_meeting(grip_of(Shape::ellipsoid, 0.05, sign * 0.02, 0.01));
    ASSERT_TRUE(meeting);
    EXPECT_NEAR(meeting->depth_share, 0.5 * (1.0 - 0.8), 1e-12);
    EXPECT_NEAR(meeting->lean_rad, std::asin(0.6), 1e-9);
  }
}

TEST(PadMeeting, OfAFlatSideIsNeverDeepNorLeaning) {
  const auto meeting = pad_meeting(grip_of(Shape::box, 0.05, 0.029, 0.01));
  ASSERT_TRUE(meeting);
  EXPECT_EQ(meeting->depth_share, 0.0);
  EXPECT_EQ(meeting->lean_rad, 0.0);
}

TEST(PadMeeting, DoesNotExistBesideTheProduct) {
  EXPECT_FALSE(pad_meeting(grip_of(Shape::box, 0.05, 0.031, 0.01)));
  EXPECT_FALSE(pad_meeting(grip_of(Shape::ellipsoid, 0.05, -0.031, 0.01)));
}

}  // namespace
}  // namespace unbruised
