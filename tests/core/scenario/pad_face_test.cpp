// Faces of pads, and where they meet a product.

#include "core/scenario/pad_face.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/pad_law.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

ParallelJawParameters jaw_with(PadShape shape, double radius_m = 0.04) {
  ParallelJawParameters jaw;
  jaw.pad_size_m = {0.03, 0.02};
  jaw.pad.shape = shape;
  jaw.pad.radius_m = radius_m;
  jaw.pad.half_angle_rad = 1.2;
  return jaw;
}

constexpr double kRounding_m = 1e-15;

TEST(PadFace, ACylinderIsACircleAcross) {
  ParallelJawParameters jaw = jaw_with(PadShape::cylinder);
  const double fall = 0.04 - std::sqrt(0.04 * 0.04 - 0.01 * 0.01);
  EXPECT_NEAR(PadFace(jaw).height_m({0.01, 0.007}), -fall, kRounding_m);
  jaw.pad.radius_m = -0.04;
  EXPECT_NEAR(PadFace(jaw).height_m({-0.01, 0.007}), fall, kRounding_m) << "a cradle rises beside its middle";
  jaw.pad.along = PadAlong::y;
  EXPECT_NEAR(PadFace(jaw).height_m({-0.01, 0.0}), 0.0, kRounding_m);
  EXPECT_NEAR(PadFace(jaw).curvature_1_m()[1], -25.0, 1e-12);
  EXPECT_EQ(PadFace(jaw).curvature_1_m()[0], 0.0);
}

TEST(PadFace, ASphereFallsAlongBoth) {
  const PadFace face(jaw_with(PadShape::sphere));
  const double square = 0.01 * 0.01 + 0.005 * 0.005;
  EXPECT_NEAR(face.height_m({0.01, -0.005}), std::sqrt(0.04 * 0.04 - square) - 0.04, kRounding_m);
  EXPECT_NEAR(face.slope({0.01, 0.0}, 0, 1e-5), -0.01 / std::sqrt(0.04 * 0.04 - 0.01 * 0.01), 1e-7);
}

TEST(PadFace, AGrooveRisesToBothSides) {
  const PadFace face(jaw_with(PadShape::v_groove));
  EXPECT_NEAR(face.height_m({-0.01, 0.0}), 0.01 / std::tan(1.2), kRounding_m);
  EXPECT_NEAR(face.groove_cosine(), std::sin(1.2), 1e-15) << "its face leans by pi / 2 - 1.2";
  EXPECT_NEAR(face.range_m()[1], 0.015 / std::tan(1.2), kRounding_m);
}

TEST(PadFace, AProfileHasTheCurvatureOfWhatItSamples) {
  ParallelJawParameters jaw = jaw_with(PadShape::profile);
  for (int i = -30; i <= 30; ++i) {
    jaw.pad.profile_place_m.push_back(i * 5e-4);
    jaw.pad.profile_height_m.push_back(-i * 5e-4 * i * 5e-4 / (2.0 * 0.05));
  }
  const PadFace face(jaw);
  EXPECT_NEAR(face.curvature_1_m()[0], 20.0, 0.1) << "chords of a parabola";
  EXPECT_NEAR(face.height_m({0.5e-4, 0.0}), -5e-4 * 5e-4 / 0.1 / 10.0, kRounding_m) << "linear between its places";
  EXPECT_EQ(face.height_m({0.02, 0.0}), face.height_m({0.015, 0.0})) << "beside the pad that of its edge";
}

Scenario grip(PadShape shape, double radius_m) {
  Scenario s = testing::usual_grip();
  LatticeParameters& product = testing::lattice_in(s);
  product.shape = Shape::cylinder;
  product.axis = Axis::z;
  product.size_m = {0.05, 0.05, 0.06};
  s.gripper = jaw_with(shape, radius_m);
  return s;
}

TEST(PadMeeting, AGrooveMeetsACylinderOnItsFaces) {
  const auto meeting = pad_meeting(grip(PadShape::v_groove, 0.0));
  ASSERT_TRUE(meeting);
  const double alpha = std::acos(std::sin(1.2));
  EXPECT_NEAR(meeting->depth_share, 0.5 * (1.0 - std::cos(alpha)), 1e-6);
  EXPECT_NEAR(meeting->reach_m, 0.025 / std::cos(alpha) - 0.025, 1e-9) << "the vertex stands behind";
  EXPECT_NEAR(meeting->lean_rad, 0.0, 1e-4) << "the face lies along the cylinder";
}

TEST(PadMeeting, ANarrowCradleMeetsTheProductWithItsEdges) {
  const auto meeting = pad_meeting(grip(PadShape::cylinder, -0.02));
  ASSERT_TRUE(meeting);
  EXPECT_NEAR(meeting->depth_share, 0.5 * (1.0 - std::sqrt(1.0 - 0.36)), 1e-6) << "15 mm beside the middle";
  EXPECT_GT(meeting->lean_rad, 0.1);
  const auto wide = pad_meeting(grip(PadShape::cylinder, -0.03));
  EXPECT_NEAR(wide->depth_share, 0.0, 1e-9);
  EXPECT_NEAR(wide->reach_m, 0.0, 1e-12);
}

TEST(Opening, OfShapedPadsLeavesWhatTheirFacesLeave) {
  Scenario s = grip(PadShape::v_groove, 0.0);
  jaw_of(s).opening_m = 0.08;
  const double reach = 0.025 / std::sin(1.2) - 0.025;
  EXPECT_NEAR(approach_gap_m(s), 0.015 - reach, 1e-9);
  EXPECT_NEAR(opened_half_m(s), 0.04, 1e-12);
}

TEST(PadLaw, PointsAndCoefficientsSayTheSame) {
  PadParameters pad;
  pad.law_coefficients = {2401.0, 4.28e6};
  const PadLaw law = *pad_law(pad);
  EXPECT_NEAR(law.force_N(2e-3), 2401.0 * 2e-3 + 4.28e6 * 4e-6, 1e-9);
  EXPECT_NEAR(law.slope_at_N_m(2e-3), 2401.0 + 2.0 * 4.28e6 * 2e-3, 1e-9);
  EXPECT_NEAR(law.depth_m(law.force_N(1.7e-3)), 1.7e-3, 1e-12);
  pad.law_coefficients.clear();
  for (int i = 0; i <= 6; ++i) {
    pad.law_depth_m.push_back(i * 0.5e-3);
    pad.law_force_N.push_back(law.force_N(i * 0.5e-3));
  }
  const PadLaw points = *pad_law(pad);
  for (int i = 0; i <= 6; ++i) EXPECT_NEAR(points.force_N(i * 0.5e-3), law.force_N(i * 0.5e-3), 1e-9) << i;
  EXPECT_NEAR(points.force_N(0.75e-3), 0.5 * (law.force_N(0.5e-3) + law.force_N(1e-3)), 1e-9);
}

}  // namespace
}  // namespace unbruised
