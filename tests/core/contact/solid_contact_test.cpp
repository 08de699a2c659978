// Contact of solids of revolution and superellipsoids: where they are a sphere or an ellipsoid, its contact.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contact/patch_form.hpp"
#include "core/contact/surface_places.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/profile_curve.hpp"
#include "core/scenario/true_shape.hpp"
#include "tests/core/contact/hertz_scenes.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/scenario/solids.hpp"

namespace unbruised {
namespace {

using namespace testing;

void as_profile(LatticeParameters& ball) {
  const LatticeParameters turned = revolution_of(sphere_profile(), ball.size_m);
  ball.shape = turned.shape;
  ball.profile_height = turned.profile_height;
  ball.profile_radius = turned.profile_radius;
}

void as_superellipsoid(LatticeParameters& ball) { ball.shape = Shape::superellipsoid; }

// The same cells and the same surface to round-off; the contact solve ends within its tolerance.
TEST(SolidContact, OfASphereIsPressedAsASphere) {
  const Pressed sphere = press_sphere(8, 20.0, 30.0);
  for (const auto change : {as_profile, as_superellipsoid}) {
    const Pressed same = press_sphere(8, 20.0, 30.0, change);
    EXPECT_NEAR(same.approach_m / sphere.approach_m, 1.0, 1e-6);
    EXPECT_EQ(same.contact_count, sphere.contact_count);
  }
}

void as_mesh(LatticeParameters& ball) {
  const LatticeParameters meshed = mesh_product(icosphere(4), ball.size_m);
  ball.shape = meshed.shape;
  ball.mesh = meshed.mesh;
}

// 5,120 triangles. The surface is met within 1e-4 of the extent, 1 % of the approach.
TEST(SolidContact, OfAMeshedSphereIsPressedAsASphere) {
  const Pressed sphere = press_sphere(8, 20.0, 30.0), meshed = press_sphere(8, 20.0, 30.0, as_mesh);
  EXPECT_NEAR(meshed.approach_m / sphere.approach_m, 1.0, 0.02);
  EXPECT_NEAR(meshed.over_hertz / sphere.over_hertz, 1.0, 0.02);
}

// Curvature is fitted to a fifth of the half extent around the pole, where an ellipsoid is no parabola any more.
TEST(SolidContact, AMeshedEllipsoidHasItsPatches) {
  LatticeParameters kiwi;
  kiwi.shape = Shape::ellipsoid;
  kiwi.size_m = {0.05, 0.05, 0.07};
  LatticeParameters same = kiwi;
  as_mesh(same);
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2, first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    const PatchForm a = patch_form(kiwi, side, {first, second}, {}),
                    b = patch_form(same, side, {first, second}, {});
    EXPECT_EQ(b.area.kind, PatchKind::ellipse);
    EXPECT_NEAR(b.area.body / a.area.body, 1.0, 0.02);
    EXPECT_NEAR(b.yield_factor / a.yield_factor, 1.0, 0.02);
    EXPECT_NEAR(b.cross_section_m2 / a.cross_section_m2, 1.0, 0.01);
  }
}

// The surface of a sphere, whose places are summed in 7 x 7 parts each.
TEST(SolidContact, PlacesOfAMeshedSphereAddUpToItsSurface) {
  LatticeParameters ball = mesh_product(icosphere(4), {0.05, 0.05, 0.05});
  ball.cell_size_m = 0.006;
  double sum = 0.0;
  for (const SurfacePlace& place : surface_places(ball, build_lattice(ball), ContactSet::whole_surface)) {
    sum += place.area_m2;
  }
  EXPECT_NEAR(sum / (std::numbers::pi * 0.05 * 0.05), 1.0, 0.01);
}

TEST(SolidContact, HasThePatchesOfAnEllipsoid) {
  LatticeParameters kiwi;
  kiwi.shape = Shape::ellipsoid;
  kiwi.size_m = {0.05, 0.05, 0.07};
  for (const auto change : {as_profile, as_superellipsoid}) {
    LatticeParameters same = kiwi;
    change(same);
    for (std::size_t side = 0; side < 6; ++side) {
      const std::size_t axis = side / 2, first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
      const PatchForm a = patch_form(kiwi, side, {first, second}, {}),
                      b = patch_form(same, side, {first, second}, {});
      EXPECT_EQ(b.area.kind, PatchKind::ellipse);
      EXPECT_NEAR(b.area.body / a.area.body, 1.0, 1e-9);
      EXPECT_NEAR(b.area.semi_axis[0], a.area.semi_axis[0], 1e-6);
      EXPECT_NEAR(b.yield_factor / a.yield_factor, 1.0, 1e-6);
      EXPECT_NEAR(b.cross_section_m2 / a.cross_section_m2, 1.0, 0.01);  // summed with five points a piece
    }
  }
}

TEST(SolidContact, AFlatEndIsAFlatPatchAndAWallAStrip) {
  const LatticeParameters pear = revolution_of(pear_profile(), {0.06, 0.06, 0.08});
  EXPECT_EQ(patch_form(pear, 4, {0, 1}, {}).area.kind, PatchKind::flat);
  EXPECT_EQ(patch_form(pear, 5, {0, 1}, {}).area.kind, PatchKind::ellipse);
  const LatticeParameters bottle = revolution_of(bottle_profile(), {0.03, 0.03, 0.066});
  const PatchForm wall = patch_form(bottle, 1, {1, 2}, {});
  EXPECT_EQ(wall.area.kind, PatchKind::strip);
  EXPECT_EQ(wall.area.straight, 1U);
}

// Pieces are summed in 7 x 7 parts, as those of a sphere (surface_places_test).
TEST(SolidContact, PlacesAddUpToTheSurface) {
  LatticeParameters pear = revolution_of(pear_profile(), {0.06, 0.06, 0.08});
  pear.cell_size_m = 0.006;
  const ProfileCurve curve(pear.profile_height, pear.profile_radius, 0.08, 0.03);
  double expected = std::numbers::pi * curve.q(-0.04);  // the flat end
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double z = -0.04 + 0.08 * (i + 0.5) / kSteps, half_slope = 0.5 * curve.slope(z);
    expected += 2.0 * std::numbers::pi * std::sqrt(curve.q(z) + half_slope * half_slope) * 0.08 / kSteps;
  }
  const TrueShape shape(pear);
  const Lattice lattice = build_lattice(pear);
  double sum = 0.0;
  for (const SurfacePlace& place : surface_places(pear, lattice, ContactSet::whole_surface)) {
    sum += place.area_m2;
    std::array<double, 3> from_center{};
    for (std::size_t d = 0; d < 3; ++d) from_center[d] = place.place_m[d] - lattice.center_m[d];
    EXPECT_NEAR(shape.nearest(from_center).distance_m, 0.0, 1e-8);
  }
  EXPECT_NEAR(sum / expected, 1.0, 0.01);
}

TEST(SolidContact, PadsMeetThePearWhereItIsWidest) {
  Scenario scenario = small_box();
  lattice_of(scenario) = revolution_of(pear_profile(), {0.06, 0.06, 0.08});
  jaw_of(scenario).pad_size_m = {0.02, 0.02};
  scenario.cell.grip_height_m = -0.016;  // its widest place is 0.3 of its height up
  const PadMeeting belly = pad_meeting(scenario).value();
  EXPECT_NEAR(belly.depth_share, 0.0, 1e-9);
  EXPECT_NEAR(belly.lean_rad, 0.0, 1e-4);
  scenario.cell.grip_height_m = 0.02;  // at the neck
  EXPECT_GT(pad_meeting(scenario).value().depth_share, kDeepestMeeting);
}

}  // namespace
}  // namespace unbruised
