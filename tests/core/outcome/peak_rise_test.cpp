// In how few steps a force rose by half of its peak.

#include "core/outcome/peak_rise.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

PeakRise after(const std::vector<double>& forces_N) {
  PeakRise rise;
  for (const double force_N : forces_N) rise.observe(force_N);
  return rise;
}

TEST(PeakRise, OfHalfASineIsASixthOfItsHalfPeriod) {
  for (const int steps : {11, 17, 23}) {
    PeakRise rise;
    for (int i = 0; i <= steps; ++i) rise.observe(std::sin(std::numbers::pi * i / steps));
    EXPECT_EQ(rise.steps(), (steps + 1) / 6);  // sin(pi / 6) = 1/2
  }
}

TEST(PeakRise, OfAJumpIsOneStep) {
  EXPECT_EQ(after({0.0, 0.0, 5.0, 4.0, 3.0}).steps(), 1);
  EXPECT_EQ(after({0.0, 0.0, 5.0, 4.0, 3.0}).peak_N(), 5.0);
}

TEST(PeakRise, OfASlowRampIsAsLongAsIsCounted) {
  PeakRise rise;
  for (int i = 0; i <= 100; ++i) rise.observe(0.01 * i);
  EXPECT_EQ(rise.steps(), kMostRiseSteps);
}

TEST(PeakRise, SeesAJumpThatIsNotThePeakInTheEnd) {
  PeakRise rise;
  rise.observe(0.0);
  rise.observe(3.0);
  for (int i = 1; i <= 100; ++i) rise.observe(3.0 + 0.01 * i);
  EXPECT_EQ(rise.steps(), 1) << "the true one may have been higher";
  for (int i = 1; i <= 300; ++i) rise.observe(4.0 + 0.01 * i);
  EXPECT_EQ(rise.steps(), kMostRiseSteps) << "less than half of 7 N";
}

TEST(PeakRise, OfWhatPressesFromTheBeginningIsNone) {
  EXPECT_EQ(after({2.0, 2.0, 2.1}).steps(), kMostRiseSteps);
  EXPECT_EQ(after({}).steps(), kMostRiseSteps);
}

}  // namespace
}  // namespace unbruised
