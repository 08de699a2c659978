// The way of a palm from stop to stop: straight, about a fixed axis, within all limits, from rest to rest.

#include "core/motion/palm_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

PalmStop passed(const Vector& place_m, double blend_m, const Vector& rotation_rad = {}) {
  PalmStop made = stop(place_m, rotation_rad);
  made.blend_m = blend_m;
  return made;
}

/// Velocity, acceleration and their like are derivatives of what comes before them all along the path, which a
/// jump of any of them would break, and the acceleration changes no faster than the jerk.
void expect_smooth(const PalmPath& path, double most_jerk, double most_spin_jerk) {
  constexpr int kLooks = 3000;
  const double h = path.duration_s() / kLooks;
  for (int i = 0; i < kLooks; ++i) {
    const PalmState a = path.at(h * i), b = path.at(h * (i + 1));
    const Vector turned_rad = rotation_to(attitude_of(b.rotation_rad) * inverse(attitude_of(a.rotation_rad)));
    Vector jerk{}, spin_jerk{};
    for (std::size_t d = 0; d < 3; ++d) {
      // Of the trapezoidal rule: h^2 / 12 of the derivative after the next.
      EXPECT_NEAR((b.position_m[d] - a.position_m[d]) / h, 0.5 * (a.velocity_m_s[d] + b.velocity_m_s[d]),
                  h * h * most_jerk / 10.0 + 1e-10);
      EXPECT_NEAR((b.velocity_m_s[d] - a.velocity_m_s[d]) / h,
                  0.5 * (a.acceleration_m_s2[d] + b.acceleration_m_s2[d]), h * most_jerk);
      EXPECT_NEAR(turned_rad[d] / h, 0.5 * (a.spin_rad_s[d] + b.spin_rad_s[d]), h * h * most_spin_jerk + 1e-9);
      jerk[d] = (b.acceleration_m_s2[d] - a.acceleration_m_s2[d]) / h;
      spin_jerk[d] = (b.spin_acceleration_rad_s2[d] - a.spin_acceleration_rad_s2[d]) / h;
    }
    EXPECT_LE(size(jerk), 1.001 * most_jerk) << h * i;
    EXPECT_LE(size(spin_jerk), 1.001 * most_spin_jerk) << h * i;
  }
}

const PalmPath::Limits kMetres{0.8, 3.0, 30.0}, kRadians{4.0, 20.0, 300.0};

TEST(PalmPath, KeepsTheJerkOfAnSCurveOnLinesArcsAndBlends) {
  PalmStop arc = passed({0.3, 0.4, 0.2}, 0.02, {0.0, 0.3, 0.5});
  arc.via_m = Vector{0.4, 0.2, 0.25};
  const std::vector<PalmStop> stops = {passed({0.0, 0.2, 0.3}, 0.03, {0.4, 0.0, 0.0}),
                                       passed({0.3, 0.2, 0.3}, 0.01, {0.0, 0.5, 0.0}), arc,
                                       stop({0.3, 0.6, 0.2}, {})};
  const PalmPath path(stop({}, {}), stops, ProfileKind::s_curve, kMetres, kRadians);
  expect_smooth(path, kMetres.jerk, kRadians.jerk);
  const Peaks peaks = peaks_of(path);
  EXPECT_LT(peaks.speed, 1.0001 * kMetres.speed);
  EXPECT_LT(peaks.acceleration, 1.0001 * kMetres.acceleration);
  EXPECT_LT(peaks.spin, 1.0001 * kRadians.speed);
  EXPECT_LT(peaks.spin_acceleration, 1.0001 * kRadians.acceleration);
}

TEST(PalmPath, OfMinimumJerkIsContinuousUpToTheAccelerationThroughBlends) {
  const std::vector<PalmStop> stops = {passed({0.0, 0.2, 0.3}, 0.05, {0.4, 0.0, 0.0}), stop({0.3, 0.2, 0.3}, {})};
  const PalmPath path(stop({}, {}), stops, ProfileKind::minimum_jerk, {0.8, 3.0}, {4.0, 20.0});
  // Jerks of 60 D / T^3 of the shorter leg, twice where they meet: a jump of the acceleration would be 3 / h.
  expect_smooth(path, 100.0, 400.0);
}

/// How near a path comes to a corner, and how slow it is where the stops are not.
struct Passing {
  double nearest_m = 1.0, slowest_m_s = 1.0;
};
Passing passing(const PalmPath& path, const Vector& corner) {
  Passing found;
  constexpr int kLooks = 20000;
  for (int i = kLooks / 4; i < 3 * kLooks / 4; ++i) {
    const PalmState palm = path.at(path.duration_s() * i / kLooks);
    const auto& p = palm.position_m;
    found.nearest_m = std::min(found.nearest_m, size({p[0] - corner[0], p[1] - corner[1], p[2] - corner[2]}));
    found.slowest_m_s = std::min(found.slowest_m_s, size(palm.velocity_m_s));
  }
  return found;
}

TEST(PalmPath, PassesWithinTheBlendAndSavesTheTimeOfStopping) {
  const Vector corner = {0.0, 0.3, 0.1};
  for (const ProfileKind kind : {ProfileKind::minimum_jerk, ProfileKind::s_curve, ProfileKind::trapezoid}) {
    double before_s = std::numeric_limits<double>::infinity();
    for (const double blend_m : {0.0, 0.002, 0.01, 0.05}) {
      const PalmPath path(stop({}, {}), {passed(corner, blend_m), stop({0.3, 0.3, 0.1}, {})}, kind, kMetres,
                          kRadians);
      const Passing found = passing(path, corner);
      EXPECT_LE(found.nearest_m, blend_m + 1e-6);
      // Trapezoids and s_curves are at their limits where they meet: little room for little blends.
      const bool goes_on = blend_m > (kind == ProfileKind::minimum_jerk ? 0.0 : 0.02);
      if (goes_on) {
        EXPECT_GT(found.slowest_m_s, 0.01) << blend_m;
        EXPECT_LT(path.duration_s(), before_s) << blend_m;
      }
      EXPECT_LE(path.duration_s(), before_s);
      before_s = path.duration_s();
    }
  }
}

TEST(PalmPath, SmallTurnsAreBlendedBySharpLimitsToo) {
  const Vector corner = {0.0, 0.3, 0.0};
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::trapezoid}) {
    const PalmPath path(stop({}, {}), {passed(corner, 0.005), stop({0.1, 0.6, 0.0}, {})}, kind, kMetres, kRadians);
    EXPECT_GT(passing(path, corner).slowest_m_s, 0.01);
  }
}

TEST(PalmPath, AnArcKeepsItsRadiusAndItsLimits) {
  PalmStop end = stop({0.4, 0.0, 0.0}, {});
  end.via_m = Vector{0.2, 0.0, 0.2};  // half a circle of 0.2 m
  for (const ProfileKind kind : {ProfileKind::minimum_jerk, ProfileKind::s_curve, ProfileKind::trapezoid}) {
    const PalmPath path(stop({}, {}), {end}, kind, kMetres, kRadians);
    double way_m = 0.0;
    Vector last{};
    constexpr int kLooks = 4000;
    for (int i = 0; i <= kLooks; ++i) {
      const Vector p = path.at(path.duration_s() * i / kLooks).position_m;
      EXPECT_NEAR(size({p[0] - 0.2, p[1], p[2]}), 0.2, kRounding);
      EXPECT_GE(p[2], -kRounding);
      way_m += size({p[0] - last[0], p[1] - last[1], p[2] - last[2]});
      last = p;
    }
    EXPECT_NEAR(way_m, 0.2 * kPi, 1e-5);
    const Peaks peaks = peaks_of(path);
    EXPECT_LE(peaks.acceleration, kMetres.acceleration);
    EXPECT_GT(peaks.acceleration, 0.5 * kMetres.acceleration)
        << "half of its square goes along the arc, half across";
    EXPECT_LE(peaks.speed, kMetres.speed);
  }
  const PalmPath smooth(stop({}, {}), {end}, ProfileKind::s_curve, kMetres, kRadians);
  expect_smooth(smooth, kMetres.jerk, kRadians.jerk);
}

TEST(PalmPath, TakesTheTimeAndKeepsTheSpeedOfAWaypoint) {
  for (const ProfileKind kind : {ProfileKind::minimum_jerk, ProfileKind::s_curve, ProfileKind::trapezoid}) {
    PalmStop end = stop({0.0, 0.3, 0.0}, {0.2, 0.0, 0.0});
    end.duration_s = 2.5;
    const PalmPath slow(stop({}, {}), {end}, kind, kMetres, kRadians);
    EXPECT_NEAR(slow.duration_s(), 2.5, 1e-12);
    EXPECT_NEAR(slow.at(2.5).position_m[1], 0.3, kRounding);
    end.duration_s = 0.01;  // the limits win
    const PalmPath fast(stop({}, {}), {end}, kind, kMetres, kRadians);
    EXPECT_GT(fast.duration_s(), 0.3);
    end.duration_s.reset();
    end.speed_m_s = 0.1;
    EXPECT_NEAR(peaks_of(PalmPath(stop({}, {}), {end}, kind, kMetres, kRadians)).speed, 0.1, 1e-6);
  }
}

}  // namespace
}  // namespace unbruised
