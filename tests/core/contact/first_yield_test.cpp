// The mean pressure of a contact patch at first yield below it, against Hertz.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contact/patch_area.hpp"
#include "tests/core/contact/kiwi_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kPlane_Pa = 0.288e6 / (1.0 - 0.35 * 0.35);

TEST(HertzPatch, IsTheCircleOfASphere) {
  const PatchArea area = ellipse_area({0.025, 0.025}, kPlane_Pa);
  const double radius = std::cbrt(0.75 * 2.0 * 0.025 / kPlane_Pa);  // of 2 N
  EXPECT_NEAR(area.body * std::cbrt(4.0), std::numbers::pi * radius * radius, 1e-12);
  EXPECT_NEAR(area.semi_axis[0], std::sqrt(1.0 / std::numbers::pi), 1e-12);
  EXPECT_NEAR(area.semi_axis[1], std::sqrt(1.0 / std::numbers::pi), 1e-12);
}

TEST(HertzPatch, IsTheEllipseOfTwoRadii) {
  // Radii 3 : 1 are cos(tau) = (B - A)/(B + A) = 1/2 in the tables of Hertz's solution (Timoshenko and Goodier, 60
  // degrees): a = 1.486 c, b = 0.717 c with c^3 = 3 F / (4 E* (A + B)), A + B = (1/R' + 1/R'')/2.
  const double flat = 0.03, sharp = 0.01, force = 2.0;
  const PatchArea area = ellipse_area({flat, sharp}, kPlane_Pa);
  const double unit = std::cbrt(0.75 * force / (kPlane_Pa * 0.5 * (1.0 / flat + 1.0 / sharp)));
  const double root_area = std::sqrt(area.body * std::cbrt(force * force));
  EXPECT_NEAR(area.semi_axis[0] * root_area, 1.486 * unit,
              2e-3 * unit);  // the table's last digit and its rounding
  EXPECT_NEAR(area.semi_axis[1] * root_area, 0.717 * unit, 2e-3 * unit);
}

TEST(FirstYield, OfASphereBetweenStiffPlatesIsThatOfHertz) {
  // Shipped resolution, and one cell fewer across: a particle and a cell under the pole.
  for (const int cells : {10, 9}) {
    const double force = yield_force_N(sphere_between_plates(0.05 / cells), 0.8, 4.0);
    // Johnson (1985), 4.2: F = pi^3 R^2 p0^3 / (6 E*^2), with p0 = Y / 0.597, the peak stress on the axis for nu =
    // 0.35.
    const double p0 = 0.024e6 / 0.5973;
    const double hertz = std::pow(std::numbers::pi * p0, 3) * 0.025 * 0.025 / (6.0 * kPlane_Pa * kPlane_Pa);
    // Tolerance: that of the shipped window; the plates' layer itself raises the force by 8 %.
    EXPECT_NEAR(force, hertz, 0.15 * hertz) << cells << " cells";
  }
}

TEST(FirstYield, RatioGrowsWithTheGripForce) {
  for (const Scenario& scenario : {sphere_between_plates(0.05 / 9), kiwi_grip(0.00625)}) {
    const auto grips = run_grips(scenario, 0.5, 8.0);
    for (std::size_t i = 1; i < grips.size(); ++i) {
      EXPECT_GT(grips[i].metrics[Metric::contact_yield_ratio_max],
                grips[i - 1].metrics[Metric::contact_yield_ratio_max]);
    }
  }
}

TEST(FirstYield, ComesEarlierUnderAPadSmallerThanThePatch) {
  Scenario scenario = kiwi_grip(0.00625);
  const double wide = yield_force_N(scenario, 2.0, 10.0);
  jaw_of(scenario).pad_size_m = {0.012, 0.012};
  const double narrow = yield_force_N(scenario, 0.5, 10.0);
  EXPECT_LT(narrow, 0.9 * wide);
}

TEST(FirstYield, ComesLaterUnderASofterPad) {
  Scenario scenario = kiwi_grip(0.00625);
  const double soft = yield_force_N(scenario, 2.0, 10.0);
  jaw_of(scenario).pad_modulus_Pa *= 10.0;
  const double firm = yield_force_N(scenario, 2.0, 10.0);
  EXPECT_LT(firm, 0.8 * soft);
  // Between the rigid plate's 3.84 N (boundary elements; elliptic Hertz with radii of 50.4 and 25 mm says 3.85 N)
  // and the soft pad's.
  EXPECT_GT(firm, 3.84);
}

}  // namespace
}  // namespace unbruised
