// Vectors, matrices and rotations with a value per lane, against their definitions.

#include "core/lanes/lane_rotation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr int kLane = 3;

LaneVector vector(double x, double y, double z) { return to_lanes({x, y, z}); }

void expect_equal(const LaneVector& a, const LaneVector& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i][kLane], b[i][kLane], tolerance) << i;
}

TEST(LaneRotation, TurnsAboutItsVectorByItsLength) {
  // 120 deg about the diagonal: x to y to z to x.
  const double angle = 2.0 * std::acos(-1.0) / 3.0 / std::sqrt(3.0);
  const LaneMatrix R = rotation_by(vector(angle, angle, angle)).matrix();
  // Rounding of a dozen operations.
  expect_equal(R * vector(1.0, 2.0, 3.0), vector(3.0, 1.0, 2.0), 4e-15);
  expect_equal(transposed(R) * vector(3.0, 1.0, 2.0), vector(1.0, 2.0, 3.0), 4e-15);
}

TEST(LaneRotation, HasTheSineAndCosineOfAnyAngleUpToThree) {
  for (const double angle : {1e-9, 1e-3, 0.1, 1.0, 2.0, 3.0}) {
    const LaneMatrix R = rotation_by(vector(0.0, 0.0, angle)).matrix();
    EXPECT_NEAR(R(0, 0)[kLane], std::cos(angle), 4e-15) << angle;
    EXPECT_NEAR(R(1, 0)[kLane], std::sin(angle), 4e-15 * std::max(1e-3, angle)) << angle;
  }
}

TEST(LaneRotation, GivesTheVectorOfASmallRotationBack) {
  for (const double size : {1e-12, 1e-3, 0.1}) {
    const LaneVector small = vector(0.6 * size, 0.0, -0.8 * size);
    const LaneRotation rotation = rotation_by(small);
    expect_equal(small_rotation_rad(rotation), small, 4e-15 * size);
    // The same rotation with the other sign, as where half a turn is passed.
    const LaneRotation other{Lane(-1.0) * rotation.w, Lane(-1.0) * rotation.axis};
    expect_equal(small_rotation_rad(other), small, 4e-15 * size);
  }
}

TEST(LaneRotation, OfAProductIsTheProductOfTheMatrices) {
  const LaneRotation a = rotation_by(vector(0.3, -0.2, 0.9)), b = rotation_by(vector(-1.1, 0.4, 0.1));
  const LaneMatrix product = (a * b).matrix(), matrices = a.matrix() * b.matrix();
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(product.at[i][kLane], matrices.at[i][kLane], 1e-15) << i;
}

TEST(LaneRotation, StaysOneHoweverOftenItIsComposed) {
  const LaneRotation little = rotation_by(vector(1e-2, 2e-2, -3e-2));
  LaneRotation all;
  for (int k = 0; k < 100000; ++k) all = little * all;
  EXPECT_NEAR((all.w * all.w + dot(all.axis, all.axis))[kLane], 1.0, 1e-15);
}

TEST(LaneMatrix, SolvesWhatItMultiplies) {
  LaneMatrix A;
  for (std::size_t i = 0; i < 9; ++i) A.at[i] = Lane(std::sin(1.0 + static_cast<double>(i * i)));
  const LaneVector x = vector(1.0, -2.0, 0.5);
  expect_equal(solve(A, A * x), x, 1e-13);  // rounding times the condition of A, about 10
}

}  // namespace
}  // namespace unbruised
