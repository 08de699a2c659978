#include "core/motion/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// A handful of roundings of numbers of the same size: each closed form takes fewer than 20 operations.
constexpr double kRounding = 20 * std::numeric_limits<double>::epsilon();

struct Case {
  ProfileKind kind;
  double distance_m;
  double acceleration_m_s2;
  double speed_m_s;
  double jerk_m_s3 = kNoLimit;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  constexpr const char* kWords[] = {"trapezoid", "minimum_jerk", "s_curve"};
  return out << kWords[static_cast<int>(c.kind)] << " D=" << c.distance_m << " a=" << c.acceleration_m_s2
             << " v=" << c.speed_m_s << " j=" << c.jerk_m_s3;
}

MotionProfile plan(const Case& c) {
  return MotionProfile::plan(c.kind, c.distance_m, c.acceleration_m_s2, c.speed_m_s, c.jerk_m_s3);
}

/// Limits that bite, limits that do not, both directions, millimetres to kilometres.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    for (const double distance_m : {1e-6, 0.1, -0.3, 1000.0}) {
      for (const double acceleration_m_s2 : {0.01, 2.0, 50.0}) {
        for (const double speed_m_s : {0.02, 1.0, kNoLimit}) {
          all.push_back({kind, distance_m, acceleration_m_s2, speed_m_s});
        }
      }
    }
  }
  for (const double distance_m : {1e-6, 0.1, -0.3, 1000.0}) {
    for (const double acceleration_m_s2 : {0.01, 2.0, 50.0}) {
      for (const double speed_m_s : {0.02, 1.0, kNoLimit}) {
        for (const double jerk_m_s3 : {0.5, 40.0, 1e4}) {
          all.push_back({ProfileKind::s_curve, distance_m, acceleration_m_s2, speed_m_s, jerk_m_s3});
        }
      }
    }
  }
  return all;
}

template <typename Check>
void for_every_case(const Check& check) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(testing::PrintToString(c));
    check(c);
  }
}

TEST(MotionProfile, TrapezoidWithoutCruiseIsBangBang) {
  const MotionProfile profile = MotionProfile::plan(ProfileKind::trapezoid, 0.5, 2.0, kNoLimit);
  EXPECT_DOUBLE_EQ(profile.duration_s(), 1.0);  // 2 sqrt(D / a)
  EXPECT_DOUBLE_EQ(profile.at(0.25).position_m, 0.0625);
  EXPECT_DOUBLE_EQ(profile.at(0.25).velocity_m_s, 0.5);
  EXPECT_EQ(profile.at(0.25).acceleration_m_s2, 2.0);
  EXPECT_EQ(profile.at(0.75).acceleration_m_s2, -2.0);
  EXPECT_DOUBLE_EQ(profile.at(0.75).position_m, 0.4375);
}

TEST(MotionProfile, TrapezoidCruisesAtTheSpeedLimit) {
  const MotionProfile profile = MotionProfile::plan(ProfileKind::trapezoid, 1.0, 2.0, 0.5);
  EXPECT_DOUBLE_EQ(profile.duration_s(), 2.25);  // D / v + v / a
  EXPECT_DOUBLE_EQ(profile.at(1.0).velocity_m_s, 0.5);
  EXPECT_EQ(profile.at(1.0).acceleration_m_s2, 0.0);
  EXPECT_DOUBLE_EQ(profile.at(1.125).position_m, 0.5);
}

TEST(MotionProfile, MinimumJerkTakesTheTimeItsPeakAccelerationAllows) {
  const MotionProfile profile = MotionProfile::plan(ProfileKind::minimum_jerk, 0.1, 2.0, kNoLimit);
  const double T = std::sqrt(10.0 / std::sqrt(3.0) * 0.1 / 2.0);
  EXPECT_NEAR(profile.duration_s(), T, kRounding * T);
  // The peak stands where the jerk 60 - 360 s + 360 s^2 is zero.
  const double s = 0.5 * (1.0 - 1.0 / std::sqrt(3.0));
  EXPECT_NEAR(profile.at(s * T).acceleration_m_s2, 2.0, 2.0 * kRounding);
  EXPECT_NEAR(profile.at(0.5 * T).velocity_m_s, 1.875 * 0.1 / T, kRounding);
}

TEST(MotionProfile, MinimumJerkIsLengthenedUntilItsPeakSpeedIsTheLimit) {
  const MotionProfile profile = MotionProfile::plan(ProfileKind::minimum_jerk, 0.3, 2.0, 0.2);
  EXPECT_DOUBLE_EQ(profile.duration_s(), 1.875 * 0.3 / 0.2);
  EXPECT_DOUBLE_EQ(profile.at(0.5 * profile.duration_s()).velocity_m_s, 0.2);
}

TEST(MotionProfile, MinimumJerkStartsAndEndsWithoutAcceleration) {
  const MotionProfile profile = MotionProfile::plan(ProfileKind::minimum_jerk, 0.3, 2.0, 1.0);
  EXPECT_EQ(profile.at(0.0).acceleration_m_s2, 0.0);
  // 60 D / T^3 is the jerk, so one part in 1e9 of T away from the end the acceleration is 60 D / T^2 1e-9.
  const double T = profile.duration_s();
  EXPECT_NEAR(profile.at(T * (1.0 - 1e-9)).acceleration_m_s2, 0.0, 61.0 * 0.3 / (T * T) * 1e-9);
}

TEST(MotionProfile, AnSCurveTakesTheTimeOfItsClosedForms) {
  struct Known {
    double distance_m, acceleration_m_s2, speed_m_s, jerk_m_s3, duration_s, peak_speed_m_s, peak_acceleration_m_s2;
  };
  const Known all[] = {
      {1.0, 2.0, 0.5, 20.0, 2.35, 0.5, 2.0},  // cruises: D / v + v / a + a / j
      {0.5, 8.0, 0.2, 20.0, 2.7, 0.2, 2.0},   // so little speed that a is not reached: D / v + 2 sqrt(v / j)
      {6.0, 2.0, kNoLimit, 2.0, 1.0 + std::sqrt(13.0), std::sqrt(13.0) - 1.0, 2.0},  // no cruise
      {0.25, 10.0, kNoLimit, 8.0, 4.0 * 0.25, 0.5, 2.0},  // neither: 4 (D / (2 j))^(1/3)
  };
  for (const Known& known : all) {
    const MotionProfile profile = MotionProfile::plan(ProfileKind::s_curve, known.distance_m,
                                                      known.acceleration_m_s2, known.speed_m_s, known.jerk_m_s3);
    EXPECT_NEAR(profile.duration_s(), known.duration_s, kRounding * known.duration_s);
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;
    constexpr int kLooks = 10000;
    for (int i = 0; i <= kLooks; ++i) {
      const auto state = profile.at(profile.duration_s() * i / kLooks);
      speed = std::max(speed, std::abs(state.velocity_m_s));
      acceleration = std::max(acceleration, std::abs(state.acceleration_m_s2));
      jerk = std::max(jerk, std::abs(state.jerk_m_s3));
    }
    EXPECT_NEAR(speed, known.peak_speed_m_s, 1e-6);
    // The looks pass a corner of the acceleration by half a step at most.
    EXPECT_NEAR(acceleration, known.peak_acceleration_m_s2, known.jerk_m_s3 * profile.duration_s() / kLooks);
    EXPECT_NEAR(jerk, known.jerk_m_s3, kRounding * known.jerk_m_s3);
  }
}

TEST(MotionProfile, OfAnSCurveWithMuchJerkATrapezoidIsLeft) {
  const MotionProfile curve = MotionProfile::plan(ProfileKind::s_curve, 0.7, 2.0, 0.8, 1e9);
  const MotionProfile trapezoid = MotionProfile::plan(ProfileKind::trapezoid, 0.7, 2.0, 0.8);
  EXPECT_NEAR(curve.duration_s(), trapezoid.duration_s(), 1e-8);  // a / j
  for (const double share : {0.1, 0.3, 0.5, 0.8}) {
    const double time_s = share * trapezoid.duration_s();
    EXPECT_NEAR(curve.at(time_s).position_m, trapezoid.at(time_s).position_m, 1e-8);
  }
}

TEST(MotionProfile, AnSCurveNeedsAJerk) {
  for (const double bad : {0.0, -1.0, kNoLimit, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(MotionProfile::plan(ProfileKind::s_curve, 1.0, 1.0, 1.0, bad), std::invalid_argument) << bad;
  }
}

TEST(MotionProfile, JerkIsTheDerivativeOfTheAcceleration) {
  for (const ProfileKind kind : {ProfileKind::minimum_jerk, ProfileKind::s_curve}) {
    const MotionProfile profile = MotionProfile::plan(kind, 0.4, 2.0, 0.6, 15.0);
    for (const double share : {0.02, 0.2, 0.45, 0.77, 0.98}) {
      const double t = share * profile.duration_s(), h = 1e-6;
      const double difference = profile.at(t + h).acceleration_m_s2 - profile.at(t - h).acceleration_m_s2;
      EXPECT_NEAR(profile.at(t).jerk_m_s3, difference / (2.0 * h), 1e-5) << share;
    }
  }
}

TEST(MotionProfile, ZeroDistanceTakesNoTime) {
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    for (const double distance_m : {0.0, -0.0}) {
      const MotionProfile profile = MotionProfile::plan(kind, distance_m, 2.0, 1.0);
      EXPECT_EQ(profile.duration_s(), 0.0);
      for (const double time_s : {-1.0, 0.0, 1.0}) {
        EXPECT_EQ(profile.at(time_s).position_m, 0.0);
        EXPECT_EQ(profile.at(time_s).velocity_m_s, 0.0);
        EXPECT_EQ(profile.at(time_s).acceleration_m_s2, 0.0);
      }
    }
  }
  EXPECT_EQ(MotionProfile().duration_s(), 0.0);
}

TEST(MotionProfile, RefusesLimitsThatAreNotPositiveAndDistancesThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    for (const double bad : {0.0, -1.0, nan}) {
      EXPECT_THROW(MotionProfile::plan(kind, 1.0, bad, 1.0), std::invalid_argument) << bad;
      EXPECT_THROW(MotionProfile::plan(kind, 1.0, 1.0, bad), std::invalid_argument) << bad;
    }
    EXPECT_THROW(MotionProfile::plan(kind, 1.0, kNoLimit, 1.0), std::invalid_argument);
    EXPECT_THROW(MotionProfile::plan(kind, nan, 1.0, 1.0), std::invalid_argument);
    EXPECT_THROW(MotionProfile::plan(kind, kNoLimit, 1.0, 1.0), std::invalid_argument);
  }
}

TEST(EveryMotionProfile, RestsBeforeItsStartAndFromItsEndOn) {
  for_every_case([](const Case& c) {
    const MotionProfile profile = plan(c);
    const double T = profile.duration_s();
    ASSERT_GT(T, 0.0);
    for (const double time_s : {-T, T, 2.0 * T, kNoLimit}) {
      EXPECT_EQ(profile.at(time_s).position_m, time_s < 0.0 ? 0.0 : c.distance_m);
      EXPECT_EQ(profile.at(time_s).velocity_m_s, 0.0);
      EXPECT_EQ(profile.at(time_s).acceleration_m_s2, 0.0);
    }
    EXPECT_EQ(profile.at(0.0).position_m, 0.0);
    EXPECT_EQ(profile.at(0.0).velocity_m_s, 0.0);
  });
}

TEST(EveryMotionProfile, KeepsItsLimitsAndReachesOne) {
  for_every_case([](const Case& c) {
    const MotionProfile profile = plan(c);
    double peak_acceleration = 0.0;
    double peak_speed = 0.0, peak_jerk = 0.0;
    constexpr int kSamples = 2000;
    for (int i = 0; i <= kSamples; ++i) {
      const MotionProfile::State state = profile.at(profile.duration_s() * i / kSamples);
      peak_acceleration = std::max(peak_acceleration, std::abs(state.acceleration_m_s2));
      peak_speed = std::max(peak_speed, std::abs(state.velocity_m_s));
      peak_jerk = std::max(peak_jerk, std::abs(state.jerk_m_s3));
    }
    EXPECT_LE(peak_acceleration, c.acceleration_m_s2 * (1.0 + kRounding));
    EXPECT_LE(peak_speed, c.speed_m_s * (1.0 + kRounding));
    // Sampling misses a smooth peak by at most (pi / kSamples)^2 / 2 of it: about 1e-6.
    if (c.kind == ProfileKind::s_curve) {
      EXPECT_LE(peak_jerk, c.jerk_m_s3 * (1.0 + kRounding));
    }
    EXPECT_GE(
        std::max({peak_acceleration / c.acceleration_m_s2, peak_speed / c.speed_m_s, peak_jerk / c.jerk_m_s3}),
        1.0 - 1e-5);
  });
}

TEST(EveryMotionProfile, PositionAndVelocityAreContinuous) {
  for_every_case([](const Case& c) {
    const MotionProfile profile = plan(c);
    const double T = profile.duration_s();
    const double a = c.acceleration_m_s2;
    const double D = std::abs(c.distance_m);
    constexpr int kSamples = 2000;
    MotionProfile::State before = profile.at(-T / kSamples);
    for (int i = 0; i <= kSamples + 1; ++i) {
      const MotionProfile::State now = profile.at(T * i / kSamples);
      const double dt = T / kSamples;
      // |change| <= peak rate x dt: a jump of either would be larger. Rounding is relative to the largest value.
      EXPECT_LE(std::abs(now.velocity_m_s - before.velocity_m_s), a * dt * (1.0 + 1e-9) + kRounding * a * T);
      EXPECT_LE(std::abs(now.position_m - before.position_m), 2.0 * D / T * dt * (1.0 + 1e-9) + kRounding * D);
      before = now;
    }
  });
}

TEST(EveryMotionProfile, VelocityIntegratesToPositionAndAccelerationToVelocity) {
  for_every_case([](const Case& c) {
    const MotionProfile profile = plan(c);
    const double T = profile.duration_s();
    const double D = std::abs(c.distance_m);
    const double a = c.acceleration_m_s2;
    constexpr int kSteps = 4000;
    const double dt = T / kSteps;
    // Midpoint rule. Smooth: error <= T dt^2 / 24 x 60 D / T^3, 1.6e-7 of D. A trapezoid's two corners, which may
    // fall into single steps, add at most peak speed x dt and peak acceleration x dt each.
    const bool corners = c.kind != ProfileKind::minimum_jerk;
    const double peak_speed = std::abs(profile.at(0.5 * T).velocity_m_s);
    const double position_tolerance = 1e-6 * D + (corners ? 2.0 * peak_speed * dt : 0.0);
    const double velocity_tolerance = 1e-6 * a * T + (corners ? 3.0 * a * dt : 0.0);
    double position = 0.0;
    double velocity = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const MotionProfile::State middle = profile.at((i + 0.5) * dt);
      position += dt * middle.velocity_m_s;
      velocity += dt * middle.acceleration_m_s2;
      const MotionProfile::State end = profile.at((i + 1) * dt);
      ASSERT_NEAR(position, end.position_m, position_tolerance);
      ASSERT_NEAR(velocity, end.velocity_m_s, velocity_tolerance);
    }
    EXPECT_NEAR(position, c.distance_m, position_tolerance);
  });
}

TEST(EveryMotionProfile, RunsBackwardsAsTheMirrorImage) {
  for_every_case([](const Case& c) {
    Case mirrored = c;
    mirrored.distance_m = -mirrored.distance_m;
    const MotionProfile profile = plan(c);
    const MotionProfile mirror = plan(mirrored);
    ASSERT_EQ(mirror.duration_s(), profile.duration_s());
    for (const double s : {0.0, 0.1, 0.5, 0.77, 1.0}) {
      const MotionProfile::State state = profile.at(s * profile.duration_s());
      const MotionProfile::State image = mirror.at(s * profile.duration_s());
      EXPECT_EQ(image.position_m, -state.position_m);
      EXPECT_EQ(image.velocity_m_s, -state.velocity_m_s);
      EXPECT_EQ(image.acceleration_m_s2, -state.acceleration_m_s2);
    }
  });
}

TEST(EveryMotionProfile, IsTheSameInOtherUnitsOfLengthAndTime) {
  for_every_case([](const Case& c) {
    // Powers of two scale without rounding: lengths x 8, times x 4 (so the square root stays exact).
    constexpr double kLength = 8.0;
    constexpr double kTime = 4.0;
    Case scaled = c;
    scaled.distance_m *= kLength;
    scaled.acceleration_m_s2 *= kLength / (kTime * kTime);
    scaled.speed_m_s *= kLength / kTime;
    scaled.jerk_m_s3 *= kLength / (kTime * kTime * kTime);
    const MotionProfile profile = plan(c);
    const MotionProfile other = plan(scaled);
    ASSERT_EQ(other.duration_s(), kTime * profile.duration_s());
    for (const double s : {0.05, 0.3, 0.5, 0.9}) {
      const MotionProfile::State state = profile.at(s * profile.duration_s());
      const MotionProfile::State image = other.at(s * other.duration_s());
      EXPECT_EQ(image.position_m, kLength * state.position_m);
      EXPECT_EQ(image.velocity_m_s, kLength / kTime * state.velocity_m_s);
      EXPECT_EQ(image.acceleration_m_s2, kLength / (kTime * kTime) * state.acceleration_m_s2);
    }
  });
}

}  // namespace
}  // namespace unbruised
