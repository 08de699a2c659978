// The frame of each surface: where it stands, how it moves with finger and palm, what it covers.

#include "core/surface/surface_lanes.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr int kLane = 3;

Scenario scene() {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).pad_size_m = {0.02, 0.04};
  jaw_of(scenario).pad_modulus_Pa = 3e5;
  jaw_of(scenario).pad_thickness_m = 0.003;
  scenario.cell.approach_gap_m = 0.005;
  scenario.cell.grip_offset_m = 0.001;
  scenario.cell.grip_height_m = 0.002;
  scenario.cell.support_friction = 0.7;
  std::get<LatticeParameters>(scenario.product).friction = 0.4;
  return scenario;
}

SurfaceLanes loaded() {
  SurfaceLanes surfaces;
  surfaces.load(kLane, scene(), {{0.0, 0.0, 0.025}, {-0.025, 0.025}}, {1e8, 1e8, 4e8});
  return surfaces;
}

TEST(Surfaces, ArePadsOfFingersInTheirOrderThenTheSupport) {
  for (int f = 0; f < kJawFingers; ++f) EXPECT_TRUE(is_pad(f));
  EXPECT_FALSE(is_pad(kSupport));
  EXPECT_EQ(surface_codes({0, 1, 2, 3}), "0 left pad, 1 right pad, 2 support, 3 cell.surface.0");
  EXPECT_EQ(surface_codes({kFirstListedPad, kSupport}), "0 gripper.finger.0, 1 support");
}

CarrierMotion at_rest() { return {}; }

TEST(SurfaceLanes, AreLoadedIntoALaneThatThereIs) {
  SurfaceLanes surfaces;
  EXPECT_THROW(surfaces.load(-1, scene(), {}, {}), std::logic_error);
  EXPECT_THROW(surfaces.load(kLanes, scene(), {}, {}), std::logic_error);
}

TEST(SurfaceLanes, EachSurfaceHasItsOwnLayerAndFriction) {
  const SurfaceLanes surfaces = loaded();
  for (const int pad : {kLeftPad, kRightPad}) {
    EXPECT_EQ(surfaces[pad].friction[kLane], 0.4);
    EXPECT_EQ(surfaces[pad].stiffness_N_m3[kLane], 1e8);
    EXPECT_TRUE(surfaces[pad].present[kLane]);
  }
  EXPECT_EQ(surfaces[kSupport].friction[kLane], 0.7);
  EXPECT_EQ(surfaces[kSupport].stiffness_N_m3[kLane], 4e8);
  EXPECT_FALSE(surfaces[kLeftPad].present[kLane + 1]) << "another lane";
}

TEST(SurfaceLanes, PadsStandTheGapFromThePolesAndCloseOnThem) {
  const SurfaceLanes surfaces = loaded();
  CarrierMotion carriers = at_rest();
  EXPECT_DOUBLE_EQ(surfaces.place(kLeftPad, carriers, Lane(0.0))[kLane], -0.030);
  EXPECT_DOUBLE_EQ(surfaces.place(kRightPad, carriers, Lane(0.005))[kLane], 0.025);
  set_motion(carriers.palm[0], kLane, {0.1, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(surfaces.place(kRightPad, carriers, Lane(0.005))[kLane], 0.125) << "with the palm";
  EXPECT_EQ(surfaces.place(kSupport, carriers, Lane(0.005))[kLane], 0.0) << "no finger moves the support";
}

TEST(SurfaceLanes, AMovingCarrierGivesPlaceVelocityAndAcceleration) {
  const SurfaceLanes surfaces = loaded();
  CarrierMotion carriers = at_rest();
  set_motion(carriers.palm[0], kLane, {0.1, 0.2, 0.3});
  set_motion(carriers.cell[2], kLane, {0.01, 0.02, 0.03});
  const AxisMotion closing{Lane(0.001), Lane(0.05), Lane(2.0)};
  const AxisMotion left = surfaces.motion(kLeftPad, carriers, closing);
  const AxisMotion right = surfaces.motion(kRightPad, carriers, closing);
  EXPECT_DOUBLE_EQ(left.velocity_m_s[kLane], 0.25);
  EXPECT_DOUBLE_EQ(right.velocity_m_s[kLane], 0.15);
  EXPECT_DOUBLE_EQ(left.acceleration_m_s2[kLane], 2.3);
  EXPECT_DOUBLE_EQ(right.acceleration_m_s2[kLane], -1.7);
  const AxisMotion support = surfaces.motion(kSupport, carriers, closing);
  EXPECT_EQ(support.place_m[kLane], 0.01);
  EXPECT_EQ(support.velocity_m_s[kLane], 0.02);
  EXPECT_EQ(support.acceleration_m_s2[kLane], 0.03);
}

TEST(SurfaceLanes, APadReachesToItsEdgesAndTheSupportBeyondEverything) {
  const SurfaceLanes surfaces = loaded();
  CarrierMotion carriers = at_rest();
  set_motion(carriers.palm[1], kLane, {0.1, 0.0, 0.0});
  // The pad's centre: y = offset, z = the product's centre + grip height; half extents 10 mm and 20 mm.
  const Stretch y = surfaces.reach(kLeftPad, carriers, 0), z = surfaces.reach(kLeftPad, carriers, 1);
  EXPECT_DOUBLE_EQ(y.low[kLane], 0.1 + 0.001 - 0.01) << "the palm carries it";
  EXPECT_DOUBLE_EQ(y.high[kLane], 0.1 + 0.001 + 0.01);
  EXPECT_DOUBLE_EQ(z.low[kLane], 0.027 - 0.02);
  EXPECT_DOUBLE_EQ(z.high[kLane], 0.027 + 0.02);
  const Stretch support = surfaces.reach(kSupport, carriers, 0);
  EXPECT_LT(support.low[kLane], -1e3);
  EXPECT_GT(support.high[kLane], 1e3);
}

}  // namespace
}  // namespace unbruised
