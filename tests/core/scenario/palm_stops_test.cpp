// Where a palm rests between lift and transfer, and where that leaves the product.

#include "core/scenario/palm_stops.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/scenario/product_frame.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;
constexpr double kQuarter_rad = std::numbers::pi / 2.0;
/// Sums of places of centimetres.
constexpr double kRounding_m = 1e-16;

void expect_equal(const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 4e-15) << i;
}

TEST(PalmStops, HaveWhatTheyDoNotSayFromTheOneBefore) {
  Scenario scenario = unbruised::testing::usual_grip();
  scenario.strategy.waypoint = {{.rotation_rad = Vector{0.1, 0.0, 0.0}, .wait_s = 0.5},
                                {.place_m = Vector{0.1, 0.2, 0.3}},
                                {.quaternion = std::array<double, 4>{0.0, 0.0, 1.0, 0.0}}};
  const std::vector<PalmStop> stops = palm_stops(scenario);
  ASSERT_EQ(stops.size(), 3U);
  EXPECT_EQ(stops[0].place_m, (Vector{0.0, 0.0, scenario.cell.lift_height_m}));
  EXPECT_EQ(stops[0].wait_s, 0.5);
  EXPECT_EQ(stops[1].place_m, (Vector{0.1, 0.2, 0.3}));
  EXPECT_EQ(stops[1].wait_s, 0.0) << "each rests for a time of its own";
  expect_equal(rotation_to(stops[1].attitude), {0.1, 0.0, 0.0});
  EXPECT_EQ(stops[2].place_m, stops[1].place_m);
  expect_equal(rotation_to(stops[2].attitude), {0.0, std::numbers::pi, 0.0});
}

TEST(PalmStops, BeginWhereTheLiftEnds) {
  Scenario scenario = unbruised::testing::usual_grip();
  scenario.strategy.pick_offset_m = 0.2;
  scenario.cell.conveyor.direction = {3.0, 4.0};
  const PalmStop lifted = lifted_stop(scenario);
  EXPECT_NEAR(lifted.place_m[0], 0.12, kRounding_m);
  EXPECT_NEAR(lifted.place_m[1], 0.16, kRounding_m);
  EXPECT_EQ(lifted.place_m[2], scenario.cell.lift_height_m);
}

TEST(PalmStops, ATiltIsTakenBackAndWaypointsAreNot) {
  Scenario scenario = unbruised::testing::usual_grip();
  EXPECT_TRUE(palm_stops(scenario).empty());
  EXPECT_FALSE(turns_product(scenario));
  scenario.strategy.tilt_rad = {0.0, 0.0, 0.5};
  ASSERT_EQ(palm_stops(scenario).size(), 1U);
  EXPECT_TRUE(turns_product(scenario));
  expect_equal(rotation_to(placing_stop(scenario).attitude), {});
  scenario.strategy.tilt_rad = {};
  scenario.strategy.waypoint = {{.rotation_rad = Vector{0.0, 0.0, 0.5}}};
  expect_equal(rotation_to(placing_stop(scenario).attitude), {0.0, 0.0, 0.5});
  EXPECT_NEAR(largest_turn_rad(scenario), 0.5, 1e-15);
}

TEST(PalmStops, OfPlacesAloneLeaveTheProductUpright) {
  Scenario scenario = unbruised::testing::usual_grip();
  scenario.strategy.waypoint = {{.place_m = Vector{0.1, 0.0, 0.2}}};
  EXPECT_EQ(product_frame(scenario), ProductFrame::upright);
  scenario.strategy.waypoint.push_back({.quaternion = std::array<double, 4>{1.0, 0.0, 0.0, 0.0}});
  EXPECT_EQ(product_frame(scenario), ProductFrame::upright);
  const std::vector<Waypoint> places = scenario.strategy.waypoint;
  scenario.strategy.waypoint = {{.rotation_rad = Vector{0.1, 0.0, 0.0}}, places[0], places[1]};
  EXPECT_EQ(product_frame(scenario), ProductFrame::floating) << "it is turned on the way";
}

TEST(PalmStops, AboutTheVerticalItLandsOnTheSideItLayOn) {
  Scenario scenario = unbruised::testing::usual_grip();
  EXPECT_FALSE(lands_otherwise(scenario));
  for (const auto& [rotation_rad, otherwise] :
       {std::pair{Vector{0.0, 0.0, 2.0}, false}, std::pair{Vector{0.02, 0.0, 0.0}, true},
        std::pair{Vector{2.0 * kQuarter_rad, 0.0, 0.0}, true}}) {
    scenario.strategy.waypoint = {{.rotation_rad = rotation_rad}};
    EXPECT_EQ(lands_otherwise(scenario), otherwise) << rotation_rad[0];
  }
  scenario.strategy.waypoint.push_back({.rotation_rad = Vector{}});
  EXPECT_FALSE(lands_otherwise(scenario)) << "it is turned back";
}

TEST(PalmStops, TheLowestPlaceOfABoxOnItsEdge) {
  Scenario scenario = unbruised::testing::usual_grip();
  unbruised::testing::lattice_in(scenario).size_m = {0.06, 0.04, 0.08};
  EXPECT_EQ(lowest_place_m(scenario, {}), 0.0);
  // Turned by a quarter about the grip axis it is 0.04 high; about its centre it then reaches down 0.02, not 0.04.
  EXPECT_NEAR(lowest_place_m(scenario, attitude_of({kQuarter_rad, 0.0, 0.0})), 0.02, kRounding_m);
  // On an edge along y: half the diagonal of x and z below the centre.
  const double a = 0.3, down_m = 0.03 * std::sin(a) + 0.04 * std::cos(a);
  EXPECT_NEAR(lowest_place_m(scenario, attitude_of({0.0, a, 0.0})), 0.04 - down_m, kRounding_m);
}

TEST(PalmStops, ThePalmTurnsAboutThePadsAndTheCentreSwings) {
  Scenario scenario = unbruised::testing::usual_grip();
  unbruised::testing::lattice_in(scenario).size_m = {0.06, 0.04, 0.08};
  scenario.cell.grip_offset_m = 0.01;
  scenario.cell.grip_height_m = 0.015;
  // From the pads the centre is at (0, -0.01, -0.015); a quarter about x takes y to z and z to -y.
  const Attitude quarter = attitude_of({kQuarter_rad, 0.0, 0.0});
  const Vector shift_m = centre_shift_m(scenario, quarter);
  EXPECT_NEAR(shift_m[0], 0.0, kRounding_m);
  EXPECT_NEAR(shift_m[1], 0.015 + 0.01, kRounding_m);
  EXPECT_NEAR(shift_m[2], -0.01 + 0.015, kRounding_m);
  EXPECT_NEAR(lowest_place_m(scenario, quarter), 0.04 + 0.005 - 0.02, kRounding_m);
}

TEST(PalmStops, AnEllipsoidStandsOnItsEndWhenTurnedUpright) {
  Scenario scenario = unbruised::testing::usual_grip();
  LatticeParameters& kiwi = unbruised::testing::lattice_in(scenario);
  kiwi.shape = Shape::ellipsoid;
  kiwi.size_m = {0.05, 0.065, 0.05};
  EXPECT_NEAR(lowest_place_m(scenario, attitude_of({kQuarter_rad, 0.0, 0.0})), 0.025 - 0.0325, kRounding_m);
  // Between: h = sqrt(sum (n e)^2).
  const double a = 0.7, reach_m = std::hypot(0.0325 * std::sin(a), 0.025 * std::cos(a));
  EXPECT_NEAR(lowest_place_m(scenario, attitude_of({a, 0.0, 0.0})), 0.025 - reach_m, kRounding_m);
}

}  // namespace
}  // namespace unbruised
