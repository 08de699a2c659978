// Counted random numbers: the published words, and the moments of the normal distribution.

#include "core/chance/philox.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

TEST(Philox, GivesThePublishedWords) {
  // Known answers of Random123 for philox4x32-10: counter and key 0; the digits of pi.
  EXPECT_EQ(philox(0, 0, 0).first, 0xe169c58d6627e8d5ULL);
  EXPECT_EQ(philox(0, 0, 0).second, 0x9b00dbd8bc57ac4cULL);
  EXPECT_EQ(philox(0x299f31d0a4093822ULL, 0x85a308d3243f6a88ULL, 0x0370734413198a2eULL).first,
            0x94fdccebd16cfe09ULL);
}

TEST(StandardNormal, HasTheMomentsOfTheNormalDistributionAndNoCorrelationWithItsNeighbours) {
  constexpr std::uint64_t n = 100'000;
  double mean = 0.0, square = 0.0, fourth = 0.0, along = 0.0, across = 0.0;
  for (std::uint64_t k = 0; k < n; ++k) {
    const double z = standard_normal(5, 6, k);
    mean += z / n;
    square += z * z / n;
    fourth += z * z * z * z / n;
    along += z * standard_normal(5, 6, k + 1) / n;
    across += z * standard_normal(5, 7, k) / n;
  }
  // Five standard errors: sd of z 1, of z^2 sqrt 2, of z^4 sqrt 96, of a product of two 1.
  const double root = std::sqrt(static_cast<double>(n));
  EXPECT_NEAR(mean, 0.0, 5.0 / root);
  EXPECT_NEAR(square, 1.0, 5.0 * std::sqrt(2.0) / root);
  EXPECT_NEAR(fourth, 3.0, 5.0 * std::sqrt(96.0) / root);
  EXPECT_NEAR(along, 0.0, 5.0 / root);
  EXPECT_NEAR(across, 0.0, 5.0 / root);
}

}  // namespace
}  // namespace unbruised
