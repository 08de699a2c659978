// Hertz's limit on finer lattices than the quick tests afford.

#include <gtest/gtest.h>

#include "tests/core/contact/hertz_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(HertzRefinement, SuccessiveLatticesDifferLessAndLess) {
  // One indentation, finer and finer cells.
  const double a = force_over_hertz(8, 8.0 / 6.0), b = force_over_hertz(16, 16.0 / 6.0),
               c = force_over_hertz(24, 24.0 / 6.0);
  EXPECT_LT(std::abs(c - b), std::abs(b - a));
}

}  // namespace
}  // namespace unbruised
