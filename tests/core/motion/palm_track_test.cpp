// A palm that goes otherwise than planned: between its knots as smooth as it is at them; and one that brakes along
// its path.

#include "core/motion/palm_track.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/stop_law.hpp"
#include "core/scenario/attitude.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

constexpr double kStep_s = 2e-3;

/// Swings along y, and turns about an axis that is not one of the cell's.
PalmState swinging(double time_s) {
  constexpr double kRate_1_s = 60.0;
  const double c = std::cos(kRate_1_s * time_s), s = std::sin(kRate_1_s * time_s);
  PalmState palm;
  palm.position_m = {0.1, 0.02 * s, 0.3 * time_s};
  palm.velocity_m_s = {0.0, 0.02 * kRate_1_s * c, 0.3};
  palm.acceleration_m_s2 = {0.0, -0.02 * kRate_1_s * kRate_1_s * s, 0.0};
  const Vector axis = {0.6, 0.0, 0.8};
  const double turn = 1.0 + 0.05 * s;
  palm.rotation_rad = times(turn, axis);
  palm.spin_rad_s = times(0.05 * kRate_1_s * c, axis);
  palm.spin_acceleration_rad_s2 = times(-0.05 * kRate_1_s * kRate_1_s * s, axis);
  return palm;
}

PalmTrack swinging_track() {
  std::vector<PalmState> knots;
  for (int i = 0; i <= 100; ++i) knots.push_back(swinging(i * kStep_s));
  return PalmTrack(0.5, kStep_s, std::move(knots));
}

double distance(const Vector& a, const Vector& b) { return length(between(a, b)); }

TEST(PalmTrack, GoesBetweenItsKnotsAsTheMotionDoes) {
  const PalmTrack track = swinging_track();
  for (double t = 0.0; t < 0.2; t += 0.37e-3) {
    const PalmState is = track.at(0.5 + t), wanted = swinging(t);
    // The rest of a polynomial of fifth degree over h: h^6 x^(6) / 46080, with x^(6) = 0.02 x 60^6; of its rates
    // that over h and h^2, times factors below 10 and 100.
    EXPECT_LT(distance(is.position_m, wanted.position_m), 2e-12);
    EXPECT_LT(distance(is.velocity_m_s, wanted.velocity_m_s), 1e-8);
    EXPECT_LT(distance(is.acceleration_m_s2, wanted.acceleration_m_s2), 5e-5);
    EXPECT_LT(angle_between_rad(attitude_of(is.rotation_rad), attitude_of(wanted.rotation_rad)), 1e-7);
    EXPECT_LT(distance(is.spin_rad_s, wanted.spin_rad_s), 1e-7);
    EXPECT_LT(distance(is.spin_acceleration_rad_s2, wanted.spin_acceleration_rad_s2), 2e-4);
  }
}

TEST(PalmTrack, IsSmoothAcrossKnotsAndItsRatesAreThoseOfItsPlaces) {
  // Turns about an axis that turns itself: there spins are not the rates of a vector.
  std::vector<PalmState> knots;
  for (int i = 0; i < 6; ++i) {
    PalmState palm;
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    palm.rotation_rad = {0.3 + 0.003 * i, 0.004 * sign, 0.002 * i};
    palm.spin_rad_s = {1.5, -2.0 * sign, 1.0};
    palm.spin_acceleration_rad_s2 = {30.0, 100.0 * sign, -50.0};
    palm.position_m = {0.001 * i, 0.0005 * sign, 0.0};
    palm.velocity_m_s = {0.5, sign, 0.1};
    palm.acceleration_m_s2 = {3.0, 100.0 * sign, 7.0};
    knots.push_back(palm);
  }
  const PalmTrack track(0.0, kStep_s, knots);
  const double d = 1e-7;
  for (double t = 0.3e-3; t < 4.9 * kStep_s; t += 0.41e-3) {
    const PalmState before = track.at(t - d), now = track.at(t), after = track.at(t + d);
    const auto rate = [d](const Vector& a, const Vector& b) { return times(0.5 / d, between(a, b)); };
    EXPECT_LT(distance(rate(before.position_m, after.position_m), now.velocity_m_s), 1e-6);
    EXPECT_LT(distance(rate(before.velocity_m_s, after.velocity_m_s), now.acceleration_m_s2), 1e-3);
    const Attitude turn = attitude_of(after.rotation_rad) * inverse(attitude_of(before.rotation_rad));
    // Rotation vectors between knots turn by r < 0.01: their spin is right to r^3 / 24 of 3 rad/s.
    EXPECT_LT(distance(times(0.5 / d, rotation_to(turn)), now.spin_rad_s), 1e-6);
    EXPECT_LT(distance(rate(before.spin_rad_s, after.spin_rad_s), now.spin_acceleration_rad_s2), 0.05);
  }
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const double t = static_cast<double>(i) * kStep_s;
    EXPECT_LT(distance(track.at(t - 1e-12).acceleration_m_s2, track.at(t + 1e-12).acceleration_m_s2), 1e-4);
    EXPECT_LT(distance(track.at(t - 1e-12).spin_acceleration_rad_s2, track.at(t + 1e-12).spin_acceleration_rad_s2),
              0.01);
  }
}

TEST(PalmTrack, StandsWhereItEnds) {
  const PalmTrack track = swinging_track();
  const PalmState end = track.at(10.0);
  EXPECT_EQ(end.position_m, swinging(0.2).position_m);
  EXPECT_EQ(end.velocity_m_s, Vector{});
  EXPECT_EQ(end.spin_acceleration_rad_s2, Vector{});
}

TEST(StopLaw, BrakesEvenlyInEachOfItsParts) {
  StopLaw law(2.0);
  law.add(-1.0, 0.5);
  law.add(-2.0, 0.25);
  EXPECT_EQ(law.duration_s(), 0.75);
  EXPECT_DOUBLE_EQ(law.at(0.5).rate, 0.5);
  EXPECT_DOUBLE_EQ(law.at(0.5).plan_s, 2.0 + 0.375);
  EXPECT_DOUBLE_EQ(law.at(0.25).plan_s, 2.0 + 0.25 - 0.5 * 0.0625);
  EXPECT_DOUBLE_EQ(law.at(0.75).rate, 0.0);
  EXPECT_DOUBLE_EQ(law.at(0.75).plan_s, 2.375 + 0.0625);
}

TEST(StopLaw, SlowsAPalmDownAsItsPathIsGoneAlong) {
  StopLaw law(0.05);
  law.add(-4.0, 0.25);
  const auto at = [&](double t) { return StopLaw::slowed(swinging(law.at(t).plan_s), law.at(t)); };
  const double d = 1e-6;
  for (const double t : {0.01, 0.1, 0.2}) {
    const PalmState before = at(t - d), now = at(t), after = at(t + d);
    // Central differences: their rest goes with d^2 times third rates of 1e4.
    EXPECT_LT(distance(times(0.5 / d, between(before.position_m, after.position_m)), now.velocity_m_s), 1e-7);
    EXPECT_LT(distance(times(0.5 / d, between(before.velocity_m_s, after.velocity_m_s)), now.acceleration_m_s2),
              1e-5);
    EXPECT_LT(distance(times(0.5 / d, between(before.spin_rad_s, after.spin_rad_s)), now.spin_acceleration_rad_s2),
              1e-5);
  }
}

}  // namespace
}  // namespace unbruised
