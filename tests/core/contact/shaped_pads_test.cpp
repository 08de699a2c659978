// Pads with faces of their own, against closed forms of contact.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contact/patch_area.hpp"
#include "tests/core/contact/shaped_pad_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;
using std::numbers::pi;

/// Of plates that give 3 % of a sphere's approach (hertz_test).
constexpr double kStiff_N_m3 = 3.5e9;
/// Hertz's force is met within 15 % where a patch is wider than two cells, within 20 % from 1.4 on (hertz_test).
constexpr double kHertz = 0.2;

/// Pressed between stiff layers: long steps, which only have to come to rest.
Scenario stiffly_pressed(Shape shape, const std::array<double, 3>& size_m) {
  Scenario s = pressed_product(shape, size_m, 0.005, kStiff_N_m3);
  s.simulation.time_step_s = 4e-3;
  s.simulation.duration_s = 0.4;
  return s;
}

void set_shape(Scenario& s, PadShape shape, PadAlong along, double radius_m) {
  pad_of(s).shape = shape;
  pad_of(s).along = along;
  pad_of(s).radius_m = radius_m;
}

/// What two opposite forces on a block of half the thickness `half` do beyond the half-space under one of them:
/// its middle plane, which rests, would have gone along under a single force; and the block is pressed as a
/// column.
double finite_block_m(const Scenario& s, double half_m, double area_m2) {
  const auto& product = std::get<LatticeParameters>(s.product);
  const double E = product.youngs_modulus_Pa, nu = product.poisson_ratio, F = s.strategy.grip_force_N;
  return F * half_m / (E * area_m2) - F * (1.0 + nu) * (3.0 - 2.0 * nu) / (2.0 * pi * E * half_m);
}

TEST(ShapedPads, ASphericalTipPressesABlockAsHertzSays) {
  const double R = 0.045, side = 0.06, F = 12.0;
  Scenario s = stiffly_pressed(Shape::box, {side, side, side});
  set_shape(s, PadShape::sphere, PadAlong::z, R);
  s.strategy.grip_force_N = F;
  lattice_of(s).yield_stress_Pa = 1e9;
  lattice_of(s).tangent_modulus_Pa = 1e5;
  const AtRest rest = press(s);
  const double E = plane_Pa(s), a = std::cbrt(0.75 * F * R / E), p0 = 1.5 * F / (pi * a * a);
  const double hertz_m = a * a / R + finite_block_m(s, 0.5 * side, side * side);
  const double over = std::pow(hertz_m / (rest.approach_m - p0 / kStiff_N_m3), 1.5);
  std::cout << "[ measured ] sphere on block: approach " << rest.approach_m * 1e3 << " mm, Hertz " << hertz_m * 1e3
            << " mm, force / Hertz " << over << ", p0 / Hertz " << rest.yield_ratio * 1e9 / (0.62 * p0) << "\n";
  // The force goes with the approach to 3/2.
  EXPECT_NEAR(over, 1.0, kHertz);
  // The largest stress below a circular patch is 0.62 p0 at a Poisson ratio of 0.3; the layer makes the patch
  // larger.
  EXPECT_NEAR(rest.yield_ratio * 1e9, 0.62 * p0, 0.05 * 0.62 * p0);
  EXPECT_NEAR(rest.force_N[0], F, 1e-2);
  EXPECT_NEAR(std::hypot(rest.force_N[1], rest.force_N[2]), 0.0, 1e-6) << "by symmetry";
}

TEST(ShapedPads, ACylindricalTipPressesABlockAsHertzSays) {
  const double R = 0.05, side = 0.06, L = 0.03, F = 30.0;
  Scenario s = stiffly_pressed(Shape::box, {side, side, L});
  lattice_of(s).poisson_ratio = 0.0;  // plane stress is plane strain
  set_shape(s, PadShape::cylinder, PadAlong::z, R);
  s.strategy.grip_force_N = F;
  const AtRest rest = press(s);
  // Half of a disc that two planes press (Johnson 1985, 5.6; nu = 0), P / (pi E) (2 ln (4 d / b) - 1): the block
  // is the square around it, a few per cent stiffer.
  const double E = 1e6, P = F / L, b = std::sqrt(4.0 * P * R / (pi * E)), d = 0.5 * side;
  const double hertz_m = P / (pi * E) * (2.0 * std::log(4.0 * d / b) - 1.0);
  std::cout << "[ measured ] cylinder on block: approach " << rest.approach_m * 1e3 << " mm, Hertz "
            << hertz_m * 1e3 << " mm, half width " << b * 1e3 << " mm\n";
  EXPECT_NEAR(rest.approach_m, hertz_m, 0.15 * hertz_m);
}

TEST(ShapedPads, ThePatchIsThatOfTheRelativeCurvature) {
  Scenario s = pressed_product(Shape::cylinder, {0.06, 0.06, 0.06}, 0.005, kStiff_N_m3);
  lattice_of(s).axis = Axis::z;  // curved along y
  const double E = plane_Pa(s), F = 20.0, stiff = 1e30;
  const auto area = [&](PadShape shape, PadAlong along, double radius_m) {
    set_shape(s, shape, along, radius_m);
    return pad_patch_area(lattice_of(s), PadFace(jaw_of(s)));
  };
  // Two cylinders side by side: b^2 = 4 P / (pi E*) / (1 / R1 + 1 / R2).
  const PatchArea convex = area(PadShape::cylinder, PadAlong::z, 0.06);
  EXPECT_EQ(convex.kind, PatchKind::strip);
  EXPECT_NEAR(convex.half_width_m(500.0, stiff), std::sqrt(4.0 * 500.0 * 0.02 / (pi * E)), 1e-9);
  const PatchArea hollow = area(PadShape::cylinder, PadAlong::z, -0.04);
  EXPECT_NEAR(hollow.half_width_m(500.0, stiff), std::sqrt(4.0 * 500.0 * 0.12 / (pi * E)), 1e-9);
  // Crossed ones of one radius: a circle of that radius.
  const PatchArea crossed = area(PadShape::cylinder, PadAlong::y, 0.03);
  EXPECT_EQ(crossed.kind, PatchKind::ellipse);
  EXPECT_NEAR(crossed.ellipse_m2(F, stiff), pi * std::pow(0.75 * F * 0.03 / E, 2.0 / 3.0), 1e-9);
  EXPECT_EQ(area(PadShape::cylinder, PadAlong::z, -0.03).kind, PatchKind::flat) << "the cradle fits";
}

/// Approach of an elliptical patch of Hertz (Johnson 1985, 4.2): 3 F K(e) / (2 pi E* a), a the longer semi-axis.
double ellipse_approach_m(const std::array<double, 2>& radius_m, double E, double F) {
  const PatchArea area = ellipse_area(radius_m, E);
  const double root = std::sqrt(area.ellipse_m2(F, 1e30));
  const double a = root * std::max(area.semi_axis[0], area.semi_axis[1]);
  const double b = root * std::min(area.semi_axis[0], area.semi_axis[1]);
  return 1.5 * F / (pi * E * a) * std::comp_ellint_1(std::sqrt(1.0 - b * b / (a * a)));
}

TEST(ShapedPads, CrossedCylindersOfOneRadiusPressEachOtherAsASphereAPlane) {
  // hertz_test presses this sphere: the same approach, of cylinders of which each curves along one tangent.
  EXPECT_NEAR(ellipse_approach_m({0.03, 0.03}, 1e6, 20.0),
              std::pow(0.75 * 20.0 / (1e6 * std::sqrt(0.03)), 2.0 / 3.0), 1e-6);
}

TEST(ShapedPads, CrossedCylindersPressEachOtherAsHertzSays) {
  // The product's along y, curved along z; the tips' along z, curved along y.
  for (const double tip_m : {0.03, 0.06}) {
    Scenario s = stiffly_pressed(Shape::cylinder, {0.06, 0.06, 0.06});
    lattice_of(s).axis = Axis::y;
    set_shape(s, PadShape::cylinder, PadAlong::z, tip_m);
    s.strategy.grip_force_N = 20.0;
    const AtRest rest = press(s);
    const double F = 20.0, E = plane_Pa(s);
    const PatchArea area = ellipse_area({tip_m, 0.03}, E);
    const double hertz_m =
        ellipse_approach_m({tip_m, 0.03}, E, F) + finite_block_m(s, 0.03, 0.25 * pi * 0.06 * 0.06);
    const double layer_m = 1.5 * F / area.ellipse_m2(F, 1e30) / kStiff_N_m3;
    const double over = std::pow(hertz_m / (rest.approach_m - layer_m), 1.5);
    std::cout << "[ measured ] crossed cylinders, tip " << tip_m * 1e3 << " mm: approach " << rest.approach_m * 1e3
              << " mm, Hertz " << hertz_m * 1e3 << " mm, force / Hertz " << over << "\n";
    EXPECT_NEAR(over, 1.0, kHertz);
  }
}

/// Layers as soft as foam under a product that gives next to nothing.
Scenario on_soft_layers(Shape shape, const std::array<double, 3>& size_m) {
  Scenario s = pressed_product(shape, size_m, 0.005, 1e6);
  LatticeParameters& product = lattice_of(s);
  product.youngs_modulus_Pa = 1e9;
  product.axis = Axis::z;
  jaw_of(s).pad_size_m = {0.03, 0.02};
  jaw_of(s).drive_viscous_N_s_m = 10.0;
  return s;
}

TEST(ShapedPads, ACradleOfTheProductsRadiusIsPressedAllAround) {
  const double R = 0.025, L = 0.02, k = 1e6;
  Scenario s = on_soft_layers(Shape::cylinder, {2 * R, 2 * R, 0.04});
  set_shape(s, PadShape::cylinder, PadAlong::z, -R);
  s.strategy.grip_force_N = 0.3;
  const AtRest rest = press(s);
  // The layer is pressed by delta cos(phi) along its normal: F = k delta R L (phi0 + sin phi0 cos phi0).
  const double phi0 = std::asin(0.015 / R);
  const double closed = 0.3 / (k * R * L * (phi0 + std::sin(phi0) * std::cos(phi0)));
  std::cout << "[ measured ] cradle: depth " << rest.approach_m * 1e6 << " um, closed form " << closed * 1e6
            << " um\n";
  // A cell counts as straight: its normal leans by up to 0.1 rad from the circle's.
  EXPECT_NEAR(rest.approach_m, closed, 0.02 * closed);
  // A plane touches b = (3/2 R F / (k L))^(1/3) to each side, and is pressed in by b^2 / (2 R).
  Scenario flat = on_soft_layers(Shape::cylinder, {2 * R, 2 * R, 0.04});
  flat.strategy.grip_force_N = 0.3;
  const double b = std::cbrt(1.5 * R * 0.3 / (k * L));
  const AtRest plane = press(flat);
  EXPECT_NEAR(plane.approach_m, b * b / (2.0 * R), 0.03 * b * b / (2.0 * R));
  EXPECT_LT(rest.approach_m, 0.45 * plane.approach_m) << "the cradle spreads the force";
}

TEST(ShapedPads, TheFacesOfAGrooveShareTheForce) {
  // Each carries N / (2 cos alpha) along its normal, of a depth delta cos alpha: F_V(delta) = 2 cos alpha
  // F_plane(delta cos alpha); of a cylinder F_plane goes with delta^(3/2).
  const double R = 0.025, half_angle = 1.1, alpha = 0.5 * pi - half_angle, F = 0.3;
  Scenario s = on_soft_layers(Shape::cylinder, {2 * R, 2 * R, 0.04});
  pad_of(s).shape = PadShape::v_groove;
  pad_of(s).along = PadAlong::z;
  pad_of(s).half_angle_rad = half_angle;
  jaw_of(s).pad_size_m[0] = 0.04;  // both patches lie within it
  s.strategy.grip_force_N = F;
  const AtRest groove = press(s);
  const double k = 1e6, L = 0.02, share = F / (2.0 * std::cos(alpha));
  const double b = std::cbrt(1.5 * R * share / (k * L)), depth = b * b / (2.0 * R) / std::cos(alpha);
  std::cout << "[ measured ] groove: depth " << groove.approach_m * 1e6 << " um, closed form " << depth * 1e6
            << " um\n";
  EXPECT_NEAR(groove.approach_m, depth, 0.04 * depth);
}

TEST(ShapedPads, AProfileThatIsFlatIsAPlane) {
  for (const Shape shape : {Shape::ellipsoid, Shape::box}) {
    Scenario s = small_box();
    lattice_of(s).shape = shape;
    lattice_of(s).size_m = {0.03, 0.028, 0.032};
    lattice_of(s).cell_size_m = 0.006;
    jaw_of(s).pad_size_m = {0.02, 0.018};
    const ScenarioResult plane = run(s);
    pad_of(s).shape = PadShape::profile;
    pad_of(s).profile_place_m = {-0.02, 0.0, 0.02};
    pad_of(s).profile_height_m = {0.0, 0.0, 0.0};
    const ScenarioResult profile = run(s);
    EXPECT_EQ(plane.outcome, profile.outcome);
    for (const Metric metric : {Metric::peak_finger_force_N, Metric::compression_max_m, Metric::lift_time_s,
                                Metric::cycle_time_s, Metric::energy_input_J, Metric::grip_impulse_N_s}) {
      const double a = plane.metrics[metric], b = profile.metrics[metric];
      EXPECT_NEAR(a, b, 1e-8 * std::abs(a)) << static_cast<int>(metric) << ", contacts are solved to 1e-8";
    }
  }
}

TEST(ShapedPads, AProfileIsTheCylinderThatItSamples) {
  Scenario s = pressed_product(Shape::sphere, {0.05, 0.05, 0.05}, 0.005, 1e8);
  s.strategy.grip_force_N = 10.0;
  set_shape(s, PadShape::cylinder, PadAlong::y, 0.04);
  const AtRest cylinder = press(s);
  pad_of(s).shape = PadShape::profile;
  pad_of(s).radius_m.reset();
  for (int i = -40; i <= 40; ++i) {
    const double place = i * 0.5e-3;
    pad_of(s).profile_place_m.push_back(place);
    pad_of(s).profile_height_m.push_back(std::sqrt(0.04 * 0.04 - place * place) - 0.04);
  }
  const AtRest profile = press(s);
  // Chords of 0.5 mm lie 0.8 um below the circle; 0.1 % of the approach.
  EXPECT_NEAR(profile.approach_m, cylinder.approach_m, 2e-3 * cylinder.approach_m);
}

}  // namespace
}  // namespace unbruised
