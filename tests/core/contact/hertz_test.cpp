// An elastic sphere between two plates, against Hertz.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/contact/hertz_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// Plates so stiff that their layer gives 3 % of the sphere's approach; that share is taken out.
constexpr double kStiff = 30.0;

TEST(Hertz, ForceIsWithinAFifthWhereThePatchIsWiderThanACellAndAHalf) {
  // Hertz contact radii of 1.5 to 2.2 cells. Finite indentation itself adds some 5-12 % (a finer lattice of
  // another program, R / cell = 14, gives 1.12 at an indentation of R / 15).
  for (const auto& [cells, force] : {std::pair(12, 20.0), std::pair(12, 40.0), std::pair(14, 20.0)}) {
    EXPECT_NEAR(press_sphere(cells, force, kStiff).over_hertz, 1.0, 0.2) << cells << " cells, " << force << " N";
  }
}

TEST(Hertz, ApproachThroughASoftPadConvergesWithTheCells) {
  // A layer as soft as the product, as pads are.
  const double a = press_sphere(6, 20.0, 1.0).approach_m, b = press_sphere(10, 20.0, 1.0).approach_m,
               c = press_sphere(14, 20.0, 1.0).approach_m;
  EXPECT_NEAR(b, c, 0.03 * c);
  EXPECT_NEAR(a, c, 0.12 * c);
}

}  // namespace
}  // namespace unbruised
