// An elastic sphere between two stiff plates, against Hertz.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/contact/hertz_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Hertz, ForceIsWithinAFifthWhereThePatchIsWiderThanACellAndAHalf) {
  for (const auto& [cells, radius_cells] : {std::pair(12, 1.7), std::pair(12, 2.2), std::pair(16, 1.7)}) {
    const double ratio = force_over_hertz(cells, radius_cells);
    EXPECT_NEAR(ratio, 1.0, 0.2) << cells << " cells, contact radius of " << radius_cells << " cells";
  }
}

TEST(Hertz, TheRatioTendsToOneAsTheIndentationShrinksBesideTheSphere) {
  // At a fixed contact radius of 2 cells, finer lattices mean smaller indentations: Hertz's own limit.
  const double coarse = force_over_hertz(10, 2.0), middle = force_over_hertz(14, 2.0), fine = force_over_hertz(18, 2.0);
  EXPECT_LT(std::abs(middle - 1.0), std::abs(coarse - 1.0));
  EXPECT_LT(std::abs(fine - 1.0), std::abs(middle - 1.0));
}

}  // namespace
}  // namespace unbruised
