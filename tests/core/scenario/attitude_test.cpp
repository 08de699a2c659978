// Rotations of one body: the vector, the quaternion and what they do to others.

#include "core/scenario/attitude.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;
/// Rounding of a dozen operations on numbers near 1.
constexpr double kRounding = 4e-15;

void expect_equal(const Vector& a, const Vector& b, double tolerance = kRounding) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(Attitude, TurnsAboutItsVectorByItsLength) {
  // 120 deg about the diagonal: x to y to z to x.
  const double part = 2.0 * kPi / 3.0 / std::sqrt(3.0);
  const Attitude attitude = attitude_of({part, part, part});
  expect_equal(turned(attitude, {1.0, 2.0, 3.0}), {3.0, 1.0, 2.0});
  expect_equal(turned(inverse(attitude), {3.0, 1.0, 2.0}), {1.0, 2.0, 3.0});
  expect_equal(turned(attitude_of({}), {1.0, 2.0, 3.0}), {1.0, 2.0, 3.0});
}

TEST(Attitude, OfAProductTurnsBySecondThenFirst) {
  const Attitude a = attitude_of({0.3, -0.2, 0.9}), b = attitude_of({-1.1, 0.4, 0.1});
  const Vector x = {0.7, -0.4, 1.0};
  expect_equal(turned(a * b, x), turned(a, turned(b, x)));
}

TEST(Attitude, GivesItsVectorBackUpToHalfATurn) {
  for (const Vector& vector : {Vector{1e-12, 0.0, 0.0}, Vector{0.4, -0.6, 0.5}, Vector{0.0, kPi, 0.0},
                               Vector{0.0, 0.0, -kPi}, Vector{-kHalfTurn_rad, 0.0, 0.0}}) {
    expect_equal(rotation_to(attitude_of(vector)), vector);
  }
}

TEST(Attitude, OfMoreThanHalfATurnIsReachedTheOtherWayRound) {
  expect_equal(rotation_to(attitude_of({0.0, 3.2, 0.0})), {0.0, 3.2 - 2.0 * kPi, 0.0});
  // A quaternion and its negative are one rotation.
  const Attitude attitude = attitude_of({0.5, 0.0, -1.0});
  expect_equal(rotation_to({-attitude.w, {-attitude.axis[0], 0.0, -attitude.axis[2]}}), {0.5, 0.0, -1.0});
}

TEST(Attitude, AnglesBetweenTwoAreAtMostHalfATurn) {
  EXPECT_NEAR(angle_between_rad(attitude_of({0.0, 0.0, 2.0}), attitude_of({0.0, 0.0, -2.0})), 2.0 * kPi - 4.0,
              kRounding);
  EXPECT_NEAR(angle_between_rad(attitude_of({kPi / 2.0, 0.0, 0.0}), attitude_of({0.0, kPi / 2.0, 0.0})),
              2.0 * kPi / 3.0, kRounding);
  EXPECT_EQ(angle_between_rad({}, {}), 0.0);
}

}  // namespace
}  // namespace unbruised
