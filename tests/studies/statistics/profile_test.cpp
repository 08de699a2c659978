// The profile of a parameter of a linear model: a parabola, whose ends Student's interval has.

#include "studies/statistics/profile.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "studies/statistics/least_squares.hpp"

namespace unbruised::studies {
namespace {

using Rows = std::vector<std::vector<double>>;

// Residuals at d = 0 of y = p0 + p1 x with y = 1, 3, 4, 6 at x = 0, 1, 2, 3, in parts of 100: slope 0.016,
// intercept 0.011, least sum of squares 0.2e-4.
const Rows kLine = {{1, 0}, {1, 1}, {1, 2}, {1, 3}};
const std::vector<double> kResiduals = {-0.01, -0.03, -0.04, -0.06};
constexpr double kLeast = 0.2e-4;

TEST(Profile, OfALineHasItsEndsWhereTheSlopesIntervalEnds) {
  // 3 more than the least: sqrt(3 / sum (x - 1.5)^2) either way of the best slope.
  const double half = std::sqrt(3e-4 / 5.0);
  for (const Side side : {Side::low, Side::high}) {
    const ProfileStep step = profile_step(kLine, kResiduals, 1, kLeast + 3e-4, side);
    const double slope = 0.016 + (side == Side::low ? -half : half);
    EXPECT_NEAR(step.step[1], slope, 1e-15);
    EXPECT_NEAR(step.step[0], 0.035 - 1.5 * slope, 1e-15);  // through the means
    // With a slope of 0 the best intercept leaves the scatter of y alone: 13.
    EXPECT_NEAR(step.squares, 13e-4, 1e-15);
  }
}

TEST(Profile, LeadsToTheLeastWhereNothingIsAsLow) {
  const ProfileStep step = profile_step(kLine, kResiduals, 1, 0.5 * kLeast, Side::high);
  EXPECT_NEAR(step.step[1], 0.016, 1e-15);
}

TEST(Profile, OfOneParameterHasNoOthers) {
  const ProfileStep step = profile_step({{1}, {2}}, std::vector<double>{-0.1, -0.2}, 0, 0.05, Side::low);
  EXPECT_NEAR(step.squares, 0.05, 1e-15);
  EXPECT_NEAR(step.step[0], 0.0, 1e-15);
  EXPECT_NEAR(profile_step({{1}, {2}}, std::vector<double>{-0.1, -0.2}, 0, 0.05, Side::high).step[0], 0.2, 1e-15);
}

TEST(Profile, OfWhatTheResidualsDoNotTellGoesTheWholeWay) {
  const Rows same = {{1, 1}, {2, 2}, {3, 3}};
  const std::vector<double> r = {0.1, -0.1, 0.1};
  EXPECT_DOUBLE_EQ(profile_step(same, r, 0, 1.0, Side::low).step[0], -1.0);
  EXPECT_DOUBLE_EQ(profile_step(same, r, 0, 1.0, Side::high).step[0], 1.0);
  const Rows nothing(3, std::vector<double>(1, 0.0));
  EXPECT_DOUBLE_EQ(profile_step(nothing, r, 0, 1.0, Side::high).step[0], 1.0);
}

}  // namespace
}  // namespace unbruised::studies
