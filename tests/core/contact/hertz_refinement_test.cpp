// Hertz's limit on finer lattices than the quick tests afford.

#include <gtest/gtest.h>

#include "tests/core/contact/hertz_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(HertzRefinement, SuccessiveLatticesDifferLessAndLess) {
  // One force, finer and finer cells.
  const double a = press_sphere(8, 20.0, 30.0).over_hertz, b = press_sphere(12, 20.0, 30.0).over_hertz,
               c = press_sphere(20, 20.0, 30.0).over_hertz;
  EXPECT_LT(std::abs(c - b), std::abs(b - a));
}

TEST(HertzRefinement, TheRatioTendsToOneAsTheIndentationShrinksBesideTheSphere) {
  constexpr double kStiffest = 200.0;  // gives less than 1 % of the approach
  // Hertz contact radii of 2.0 cells at ever smaller indentations; the force goes with the cube of the cell.
  const double force = 6.1049 * 8.0;  // at 10 cells: a = 12 mm
  const double coarse = press_sphere(10, force * 1.728, kStiffest).over_hertz;
  const double fine = press_sphere(20, force * 1.728 / 8.0, kStiffest).over_hertz;
  EXPECT_LT(std::abs(fine - 1.0), std::abs(coarse - 1.0));
  EXPECT_NEAR(fine, 1.0, 0.15);
}

}  // namespace
}  // namespace unbruised
