// The way of a palm from stop to stop: straight, about a fixed axis, within all limits, from rest to rest.

#include "core/motion/palm_path.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;
/// Sums of a dozen numbers near 1.
constexpr double kRounding = 1e-14;

double size(const Vector& x) { return std::hypot(x[0], x[1], x[2]); }

PalmStop stop(const Vector& place_m, const Vector& rotation_rad, double wait_s = 0.0) {
  return {place_m, attitude_of(rotation_rad), wait_s};
}

/// Largest speeds and accelerations on the way.
struct Peaks {
  double speed = 0.0, acceleration = 0.0, spin = 0.0, spin_acceleration = 0.0;
};

Peaks peaks_of(const PalmPath& path) {
  Peaks peaks;
  constexpr int kLooks = 20000;
  for (int i = 0; i <= kLooks; ++i) {
    const PalmState palm = path.at(path.duration_s() * i / kLooks);
    peaks.speed = std::max(peaks.speed, size(palm.velocity_m_s));
    peaks.acceleration = std::max(peaks.acceleration, size(palm.acceleration_m_s2));
    peaks.spin = std::max(peaks.spin, size(palm.spin_rad_s));
    peaks.spin_acceleration = std::max(peaks.spin_acceleration, size(palm.spin_acceleration_rad_s2));
  }
  return peaks;
}

TEST(PalmPath, KeepsEveryLimitAndReachesOne) {
  // Way and turn, each slower than the other in speed or in acceleration, and alone.
  struct Case {
    Vector way_m, turn_rad;
    PalmPath::Limits m, rad;
  };
  const std::vector<Case> cases = {
      {{0.3, 0.4, 0.0}, {0.0, 1.0, 0.0}, {1.0, 2.0}, {6.0, 40.0}},
      {{0.03, 0.0, 0.04}, {2.0, 1.0, 0.0}, {1.0, 2.0}, {3.0, 10.0}},
      {{0.3, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.2, 50.0}, {100.0, 4.0}},
      {{0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, {1.0, 2.0}, {3.0, 10.0}},
      {{0.0, 0.3, 0.0}, {0.0, 0.0, 0.0}, {0.5, 2.0}, {3.0, 10.0}},
  };
  for (const ProfileKind profile : {ProfileKind::minimum_jerk, ProfileKind::trapezoid}) {
    for (const Case& c : cases) {
      const PalmPath path(stop({}, {}), {stop(c.way_m, c.turn_rad)}, profile, c.m, c.rad);
      const Peaks peaks = peaks_of(path);
      const std::array<double, 4> shares = {peaks.speed / c.m.speed, peaks.acceleration / c.m.acceleration,
                                            peaks.spin / c.rad.speed,
                                            peaks.spin_acceleration / c.rad.acceleration};
      const double largest = *std::max_element(shares.begin(), shares.end());
      EXPECT_LT(largest, 1.0 + kRounding);
      EXPECT_GT(largest, 1.0 - 1e-6);  // the looks miss the peak by the square of a 20000th
    }
  }
}

TEST(PalmPath, OfMinimumJerkTakesTheTimeOfTheSlower) {
  const PalmPath::Limits m{1.0, 2.0}, rad{3.0, 10.0};
  const Vector way_m = {0.3, 0.0, 0.4}, turn_rad = {0.0, 1.2, 0.0};
  const auto duration_s = [&](const Vector& way, const Vector& turn) {
    return PalmPath(stop({}, {}), {stop(way, turn)}, ProfileKind::minimum_jerk, m, rad).duration_s();
  };
  EXPECT_NEAR(duration_s(way_m, turn_rad), std::max(duration_s(way_m, {}), duration_s({}, turn_rad)), kRounding);
}

TEST(PalmPath, RestsAtEachStopForItsTime) {
  const std::vector<PalmStop> stops = {stop({0.0, 0.1, 0.2}, {0.5, 0.0, 0.0}, 0.3),
                                       stop({0.0, 0.1, 0.2}, {0.5, 0.0, 0.0}, 0.2),
                                       stop({0.2, 0.1, 0.2}, {0.5, 0.8, 0.0})};
  const PalmPath path(stop({0.0, 0.0, 0.1}, {}), stops, ProfileKind::trapezoid, {1.0, 2.0}, {3.0, 10.0});
  const PalmPath first(stop({0.0, 0.0, 0.1}, {}), {stops[0]}, ProfileKind::trapezoid, {1.0, 2.0}, {3.0, 10.0});
  for (const double later_s : {-0.3, -0.15, 0.0, 0.1, 0.2}) {
    const PalmState palm = path.at(first.duration_s() + later_s);
    EXPECT_EQ(palm.position_m, stops[0].place_m) << later_s;
    EXPECT_EQ(size(palm.velocity_m_s), 0.0) << later_s;
    EXPECT_NEAR(palm.rotation_rad[0], 0.5, kRounding) << later_s;
    EXPECT_EQ(size(palm.spin_rad_s), 0.0) << later_s;
  }
  EXPECT_EQ(path.at(-1.0).position_m, (Vector{0.0, 0.0, 0.1}));
  const PalmState end = path.at(path.duration_s() + 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(end.position_m[i], stops[2].place_m[i], kRounding);
    EXPECT_NEAR(end.rotation_rad[i], (Vector{0.5, 0.8, 0.0}[i]), kRounding);
  }
}

TEST(PalmPath, TurnsAboutAFixedAxisWithTheSpinThatItsRotationHas) {
  const PalmPath path(stop({}, {1.0, 0.2, -0.4}), {stop({}, {-0.3, 1.1, 0.7})}, ProfileKind::minimum_jerk,
                      {1.0, 2.0}, {3.0, 10.0});
  const Vector axis = path.at(0.3 * path.duration_s()).spin_rad_s;
  for (const double share : {0.1, 0.4, 0.6, 0.9}) {
    const double time_s = share * path.duration_s(), h = 1e-5;
    const PalmState before = path.at(time_s - h), palm = path.at(time_s), after = path.at(time_s + h);
    const Vector step_rad =
        rotation_to(attitude_of(after.rotation_rad) * inverse(attitude_of(before.rotation_rad)));
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(palm.spin_rad_s[i], step_rad[i] / (2.0 * h), 1e-7);  // h^2 times the jerk
      EXPECT_NEAR(palm.spin_acceleration_rad_s2[i], (after.spin_rad_s[i] - before.spin_rad_s[i]) / (2.0 * h),
                  1e-6);
      EXPECT_NEAR(palm.spin_rad_s[i] / size(palm.spin_rad_s), axis[i] / size(axis), kRounding);
    }
  }
}

TEST(PalmPath, TurnsTheShortWayRound) {
  const PalmPath path(stop({}, {0.0, 0.0, 3.0}), {stop({}, {0.0, 0.0, -3.0})}, ProfileKind::minimum_jerk,
                      {1.0, 2.0}, {3.0, 10.0});
  const PalmState mid = path.at(0.5 * path.duration_s());
  EXPECT_GT(mid.spin_rad_s[2], 0.0);
  EXPECT_NEAR(std::abs(mid.rotation_rad[2]), kPi, 1e-12);
  // Of half a turn both ways are as long: the one that is written.
  for (const double half : {kPi, -kPi, 3.1416}) {
    const PalmPath over(stop({}, {}), {stop({}, {half, 0.0, 0.0})}, ProfileKind::minimum_jerk, {1.0, 2.0},
                        {3.0, 10.0});
    EXPECT_GT(over.at(0.5 * over.duration_s()).rotation_rad[0] * half, 0.0);
  }
}

TEST(PalmPath, WithoutStopsStandsStill) {
  const PalmPath path(stop({0.0, 0.0, 0.1}, {0.2, 0.0, 0.0}), {}, ProfileKind::trapezoid, {1.0, 2.0}, {3.0, 10.0});
  EXPECT_EQ(path.duration_s(), 0.0);
  EXPECT_EQ(path.at(5.0).position_m, (Vector{0.0, 0.0, 0.1}));
  EXPECT_NEAR(path.at(5.0).rotation_rad[0], 0.2, kRounding);
}

}  // namespace
}  // namespace unbruised
