// The rigid motion that fits the ways of the anchors.

#include "core/contact/pad_slip.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr std::array<std::array<double, 2>, 4> kPlaces_m = {
    {{0.01, 0.02}, {0.03, 0.02}, {0.01, 0.05}, {0.03, 0.05}}};
constexpr std::array<double, 4> kForces_N = {1.0, 2.0, 0.5, 1.5};
constexpr double kLeastRadius_m = 1e-3;

Mask everywhere() { return Lane(1.0) > Lane(0.0); }

/// One step in which the places move by a way and an angle about a pivot.
void step(PadSlip& slip, const std::array<double, 2>& way_m, double angle_rad,
          const std::array<double, 2>& pivot_m) {
  slip.begin_step();
  for (std::size_t i = 0; i < kPlaces_m.size(); ++i) {
    const double y = kPlaces_m[i][0] - pivot_m[0], z = kPlaces_m[i][1] - pivot_m[1];
    slip.add_closed({Lane(kPlaces_m[i][0]), Lane(kPlaces_m[i][1])}, Lane(kForces_N[i]),
                    {Lane(way_m[0] - angle_rad * z), Lane(way_m[1] + angle_rad * y)});
  }
  slip.end_step(kLeastRadius_m, everywhere());
}

std::array<double, 2> center_of_force_m() {
  std::array<double, 2> center{};
  double force = 0.0;
  for (std::size_t i = 0; i < kPlaces_m.size(); ++i) {
    for (std::size_t t = 0; t < 2; ++t) center[t] += kForces_N[i] * kPlaces_m[i][t];
    force += kForces_N[i];
  }
  return {center[0] / force, center[1] / force};
}

TEST(PadSlip, OfARigidMotionIsItsWayAtTheCentreOfForceAndItsAngle) {
  PadSlip slip;
  for (int i = 0; i < 10; ++i) step(slip, {3e-4, 4e-4}, -1e-2, center_of_force_m());
  EXPECT_NEAR(slip.way_m(0), 5e-3, 1e-15);
  EXPECT_NEAR(slip.angle_rad(0), 0.1, 1e-13);
}

TEST(PadSlip, TurnsBackToNothing) {
  PadSlip slip;
  step(slip, {0.0, 0.0}, 0.02, {0.0, 0.0});
  step(slip, {0.0, 0.0}, -0.02, {0.0, 0.0});
  EXPECT_NEAR(slip.angle_rad(0), 0.0, 1e-15);
  EXPECT_NEAR(slip.way_m(0), 0.0, 1e-17);
}

TEST(PadSlip, OfOneContactHasNoAngle) {
  PadSlip slip;
  slip.begin_step();
  slip.add_closed({Lane(0.3), Lane(0.4)}, Lane(2.0), {Lane(1e-3), Lane(-1e-3)});
  slip.end_step(kLeastRadius_m, everywhere());
  EXPECT_EQ(slip.angle_rad(0), 0.0);
  EXPECT_NEAR(slip.way_m(0), std::sqrt(2.0) * 1e-3, 1e-15);
}

TEST(PadSlip, GoesWithTheParticlesWhileNothingTouches) {
  PadSlip slip;
  slip.begin_step();
  for (const double way : {1e-3, 3e-3}) slip.add_open({Lane(way), Lane(0.0)}, everywhere());
  slip.end_step(kLeastRadius_m, everywhere());
  EXPECT_DOUBLE_EQ(slip.way_m(0), 2e-3);
  slip.forget(0);
  EXPECT_EQ(slip.way_m(0), 0.0);
  EXPECT_DOUBLE_EQ(slip.way_m(1), 2e-3) << "another lane keeps its own";
}

}  // namespace
}  // namespace unbruised
