// A belt's motion, and the way of a palm from one moving place to another.

#include "core/motion/belt.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "core/motion/moving_transfer.hpp"

namespace unbruised {
namespace {

/// A dozen operations on numbers near 1.
constexpr double kRounding = 1e-14;

TEST(Belt, RunsAtItsSpeedAlsoBeforeTheStart) {
  ConveyorParameters conveyor;
  conveyor.speed_m_s = 0.4;
  conveyor.direction = {3.0, 4.0};
  const Belt belt(conveyor);
  EXPECT_NEAR(belt.direction()[0], 0.6, kRounding);
  for (const double time_s : {-0.5, 0.0, 2.0}) {
    EXPECT_NEAR(belt.at(time_s).position_m, 0.4 * time_s, kRounding);
    EXPECT_EQ(belt.at(time_s).velocity_m_s, 0.4);
    EXPECT_EQ(belt.at(time_s).acceleration_m_s2, 0.0);
  }
}

/// To 0.3 m/s at 2 m/s2.
ConveyorParameters changing(std::optional<double> initial_speed_m_s, double start_s) {
  ConveyorParameters conveyor;
  conveyor.speed_m_s = 0.3;
  conveyor.initial_speed_m_s = initial_speed_m_s;
  conveyor.acceleration_m_s2 = 2.0;
  conveyor.start_s = start_s;
  return conveyor;
}

TEST(Belt, GetsFromOneSpeedToAnotherEvenly) {
  for (const double from : {0.0, 0.9}) {
    const Belt belt(changing(from, 0.1));
    const double signed_m_s2 = from < 0.3 ? 2.0 : -2.0, change_s = (0.3 - from) / signed_m_s2;
    const double halfway_s = 0.1 + 0.5 * change_s;
    EXPECT_NEAR(belt.at(0.1).position_m, 0.1 * from, kRounding);
    EXPECT_EQ(belt.at(0.1).acceleration_m_s2, signed_m_s2);
    EXPECT_NEAR(belt.at(halfway_s).velocity_m_s, 0.5 * (from + 0.3), kRounding);
    const double end_m = 0.1 * from + 0.5 * (from + 0.3) * change_s;
    EXPECT_NEAR(belt.at(0.1 + change_s + 1.0).position_m, end_m + 0.3, kRounding);
    EXPECT_EQ(belt.at(0.1 + change_s + 1.0).velocity_m_s, 0.3);
    EXPECT_EQ(belt.at(0.1 + change_s + 1.0).acceleration_m_s2, 0.0);
  }
  EXPECT_EQ(Belt(changing(std::nullopt, 0.0)).at(0.0).velocity_m_s, 0.0)
      << "with an acceleration it starts at rest";
}

TEST(MotionProfile, InAGivenTimeArrivesThenAtRest) {
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    const MotionProfile profile = MotionProfile::in_time(kind, 0.6, 0.5);
    EXPECT_EQ(profile.duration_s(), 0.5);
    EXPECT_NEAR(profile.at(0.25).position_m, 0.3, kRounding);
    EXPECT_NEAR(profile.at(0.5 - 1e-9).position_m, 0.6, 1e-15);  // its last nanosecond is worth a x 1e-18
    // Peaks: 3/2 and 15/8 of the mean speed.
    EXPECT_NEAR(profile.at(0.25).velocity_m_s, (kind == ProfileKind::trapezoid ? 1.5 : 1.875) * 1.2, kRounding);
  }
}

struct Crossing {
  const char* what;
  MovingPlace from, to;
};
const Crossing kCrossings[] = {
    {"from a belt onto a table", {{0.2, 0.5}, {0.0, 0.4}}, {{0.6, 0.8}, {0.0, 0.0}}},
    {"from a belt onto a table behind", {{0.0, 0.5}, {0.0, 0.4}}, {{0.0, 0.1}, {0.0, 0.0}}},
    {"from a table onto a belt that leads", {{0.0, 0.0}, {0.0, 0.0}}, {{0.0, 0.3}, {0.0, 0.4}}},
    {"from one belt onto another across", {{0.0, 0.0}, {0.3, 0.0}}, {{0.4, 0.1}, {0.0, -0.4}}},
    {"from a stop to a stop", {{0.0, 0.0}, {0.0, 0.0}}, {{0.3, -0.4}, {0.0, 0.0}}},
};

TEST(MovingTransfer, LeavesOnePlaceWithItsSpeedAndMeetsTheOtherWithIts) {
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    for (const Crossing& crossing : kCrossings) {
      SCOPED_TRACE(crossing.what);
      const MovingTransfer transfer = MovingTransfer::plan(kind, crossing.from, crossing.to, {1.0, 2.0});
      const double T = transfer.duration_s();
      for (const double late_s : {0.0, 0.7}) {
        for (std::size_t i = 0; i < 2; ++i) {
          const double met_m = crossing.to.place_m[i] + crossing.to.velocity_m_s[i] * (T + late_s);
          EXPECT_NEAR(transfer.at(T + late_s).place_m[i], met_m, kRounding);
          EXPECT_NEAR(transfer.at(T + late_s).velocity_m_s[i], crossing.to.velocity_m_s[i], kRounding);
          EXPECT_NEAR(transfer.at(-late_s).place_m[i],
                      crossing.from.place_m[i] - crossing.from.velocity_m_s[i] * late_s, kRounding);
        }
      }
    }
  }
}

TEST(MovingTransfer, StaysWithinItsLimitsAndReachesOneOfThem) {
  constexpr double kAcceleration_m_s2 = 2.0, kSpeed_m_s = 0.7;
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    for (const Crossing& crossing : kCrossings) {
      SCOPED_TRACE(crossing.what);
      const MovingTransfer transfer =
          MovingTransfer::plan(kind, crossing.from, crossing.to, {kSpeed_m_s, kAcceleration_m_s2});
      double most = 0.0;
      constexpr int kLooks = 2000;
      for (int i = 1; i < kLooks; ++i) {
        const auto state = transfer.at(transfer.duration_s() * i / kLooks);
        most = std::max({most,
                         std::hypot(state.acceleration_m_s2[0], state.acceleration_m_s2[1]) / kAcceleration_m_s2,
                         std::hypot(state.velocity_m_s[0], state.velocity_m_s[1]) / kSpeed_m_s});
      }
      // It was looked at in 96 places: a peak between two of them is (pi / 96)^2 / 8 higher at most, 0.02 %; a
      // trapezoid peaks in its corners, which are among them.
      EXPECT_LT(most, 1.001);
      EXPECT_GT(most, 0.999);
    }
  }
}

TEST(MovingTransfer, VelocityAndAccelerationAreThoseOfItsPlaces) {
  const Crossing& crossing = kCrossings[3];
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    const MovingTransfer transfer = MovingTransfer::plan(kind, crossing.from, crossing.to, {1.0, 2.0});
    constexpr double kStep_s = 1e-4;
    for (const double share : {0.1, 0.25, 0.5, 0.9}) {
      const double t = share * transfer.duration_s();
      const auto before = transfer.at(t - kStep_s), now = transfer.at(t), after = transfer.at(t + kStep_s);
      for (std::size_t i = 0; i < 2; ++i) {
        // Central differences: of second order with derivatives of some 10 and 100, and 1e-16 / step twice.
        EXPECT_NEAR((after.place_m[i] - before.place_m[i]) / (2.0 * kStep_s), now.velocity_m_s[i], 1e-6);
        EXPECT_NEAR((after.velocity_m_s[i] - before.velocity_m_s[i]) / (2.0 * kStep_s), now.acceleration_m_s2[i],
                    1e-5);
      }
    }
  }
}

TEST(MovingTransfer, OfAnSCurveKeepsItsJerk) {
  constexpr double kJerk_m_s3 = 20.0;
  for (const Crossing& crossing : kCrossings) {
    SCOPED_TRACE(crossing.what);
    const MovingTransfer transfer =
        MovingTransfer::plan(ProfileKind::s_curve, crossing.from, crossing.to, {0.7, 2.0, kJerk_m_s3});
    constexpr int kLooks = 2000;
    const double h = transfer.duration_s() / kLooks;
    for (int i = 0; i < kLooks; ++i) {
      const auto a = transfer.at(h * i), b = transfer.at(h * (i + 1));
      const double jerk = std::hypot(b.acceleration_m_s2[0] - a.acceleration_m_s2[0],
                                     b.acceleration_m_s2[1] - a.acceleration_m_s2[1]) /
                          h;
      EXPECT_LE(jerk, 1.001 * kJerk_m_s3);  // between 96 looks a peak is 0.02 % higher at most
    }
  }
}

TEST(MovingTransfer, OfAPlaceToItselfTakesNoTime) {
  const MovingPlace place{{0.1, 0.2}, {0.0, 0.4}};
  const MovingTransfer transfer = MovingTransfer::plan(ProfileKind::minimum_jerk, place, place, {1.0, 2.0});
  EXPECT_EQ(transfer.duration_s(), 0.0);
  EXPECT_NEAR(transfer.at(1.0).place_m[1], 0.6, kRounding);
}

}  // namespace
}  // namespace unbruised
