// Fingers alone, held by a lock: what stays, what gives way and by how much, and where the energy goes.

#include "core/gripper/finger_lock.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/gripper/lone_jaw.hpp"

namespace unbruised {
namespace {

using testing::LoneJaw;

constexpr double kLimit_N = 5.0;
constexpr double kProduct_N_m = 2000.0;

ParallelJawParameters locking(std::optional<double> stiffness_N_m) {
  ParallelJawParameters jaw;
  jaw.coupling = FingerCoupling::independent;
  jaw.hold = HoldMode::position;
  jaw.lock_stiffness_N_m = stiffness_N_m;
  return jaw;
}

/// Fingers that press on springs, by default until they rest.
LoneJaw pressing(const ParallelJawParameters& jaw, int steps = 3000) {
  LoneJaw fingers(jaw, 0.02, kLimit_N);
  fingers.spring_N_m = kProduct_N_m;
  for (int k = 0; k < steps; ++k) fingers.step();
  return fingers;
}

TEST(FingerLock, ThatDoesNotGiveWayKeepsTheWayWhateverPresses) {
  LoneJaw jaw = pressing(locking(std::nullopt));
  const double way = jaw.way(0);
  jaw.lock(1.0);
  for (int k = 0; k < 100; ++k) {
    jaw.step_under({kLimit_N + 3.0 * std::sin(0.3 * k), 0.0});
    EXPECT_EQ(jaw.way(0), way) << k;
    EXPECT_EQ(jaw.speed(0), 0.0) << k;
    EXPECT_EQ(jaw.acceleration(0), 0.0) << k;
  }
  EXPECT_EQ(jaw.fingers.compliance()[LoneJaw::kLane], 0.0);
}

TEST(FingerLock, StopsAMovingFingerAndLosesItsEnergyOfMotion) {
  LoneJaw jaw(locking(std::nullopt), 0.2, kLimit_N);
  jaw.step();
  const double moving_J = jaw.fingers.energy()[LoneJaw::kLane], lost_J = jaw.fingers.dissipated()[LoneJaw::kLane];
  jaw.lock(1.0);
  jaw.step();
  EXPECT_EQ(jaw.fingers.energy()[LoneJaw::kLane], 0.0);
  EXPECT_NEAR(jaw.fingers.dissipated()[LoneJaw::kLane] - lost_J, moving_J, 1e-15);
}

TEST(FingerLock, GivesWayByTheChangeOfTheForceOverItsStiffness) {
  // It goes on with the force of the drive: at first nothing moves. 2 N more push the finger back by 2 N / k.
  const double k_N_m = 1e4;
  LoneJaw jaw = pressing(locking(k_N_m));
  const double way = jaw.way(0);
  jaw.lock(1.0);
  for (int k = 0; k < 100; ++k) jaw.step_under({kLimit_N, kLimit_N});
  EXPECT_NEAR(jaw.way(0), way, 1e-12);
  for (int k = 0; k < 1000; ++k) jaw.step_under({kLimit_N + 2.0, kLimit_N});
  EXPECT_NEAR(jaw.way(0), way - 2.0 / k_N_m, 1e-9);
  EXPECT_NEAR(jaw.way(1), way, 1e-9) << "each for itself";
  EXPECT_NEAR(jaw.fingers.energy()[LoneJaw::kLane], 0.5 * 2.0 * 2.0 / k_N_m, 1e-9);
}

TEST(FingerLock, SharesTheShrinkingOfAProductAsTwoSpringsInSeries) {
  // A product that shrinks by d on either side keeps F - d k_p k / (k_p + k); without giving way F - d k_p; held
  // by force, F.
  const double shrinks_m = 1e-3;
  for (const double k_N_m : {1e2, 2e3, 1e5, 1e9}) {
    LoneJaw jaw = pressing(locking(k_N_m));
    jaw.lock(1.0);
    jaw.touch_m += shrinks_m;
    for (int k = 0; k < 4000; ++k) jaw.step();
    const double series_N_m = kProduct_N_m * k_N_m / (kProduct_N_m + k_N_m);
    EXPECT_NEAR(jaw.contact_N(0), kLimit_N - shrinks_m * series_N_m, 1e-6) << k_N_m;
  }
  LoneJaw jaw = pressing(locking(std::nullopt));
  jaw.lock(1.0);
  jaw.touch_m += shrinks_m;
  jaw.step();
  EXPECT_NEAR(jaw.contact_N(0), kLimit_N - shrinks_m * kProduct_N_m, 1e-6);
}

TEST(FingerLock, OnARackHoldsBothFingersUnderTheMeanOfTheirForces) {
  ParallelJawParameters centric = locking(1e4);
  centric.coupling = FingerCoupling::centric;
  LoneJaw jaw = pressing(centric);
  const double way = jaw.way(0);
  jaw.lock(1.0);
  for (int k = 0; k < 1000; ++k) jaw.step_under({kLimit_N + 3.0, kLimit_N - 1.0});
  for (int f = 0; f < kJawFingers; ++f) EXPECT_NEAR(jaw.way(f), way - 1.0 / 1e4, 1e-9);
}

TEST(FingerLock, LetsGoWhenItOpens) {
  for (const std::optional<double> stiffness : {std::optional<double>(), std::optional<double>(1e5)}) {
    LoneJaw jaw = pressing(locking(stiffness));
    const double way = jaw.way(0);
    jaw.lock(1.0);
    for (int k = 0; k < 100; ++k) jaw.step();
    jaw.lock(0.0);
    jaw.set_speed(-0.1);
    for (int k = 0; k < 200; ++k) jaw.step();
    EXPECT_LT(jaw.way(0), way - 0.01);
    EXPECT_NEAR(jaw.speed(0), -0.1, 1e-3);
  }
}

TEST(FingerLock, ClosesAtARealTime) {
  // Ways and forces after it are as continuous in the moment at which it closes as its share of the step.
  for (const std::optional<double> stiffness : {std::optional<double>(), std::optional<double>(1e4)}) {
    const auto way_after = [&](double first, double second) {
      LoneJaw jaw = pressing(locking(stiffness), 60);  // still swinging
      for (const double share : {first, second}) {
        jaw.lock(share);
        jaw.step();
      }
      jaw.lock(1.0);
      for (int k = 0; k < 30; ++k) jaw.step();
      return jaw.way(0);
    };
    const double late = way_after(0.0, 0.0), next = way_after(0.0, 1.0), now = way_after(1.0, 1.0);
    ASSERT_GT(std::abs(next - now), 1e-7) << "or there is nothing to see";
    EXPECT_NEAR(way_after(0.0, 1e-6), late, 1e-5 * std::abs(next - now));
    EXPECT_NEAR(way_after(1e-6, 1.0), next, 1e-5 * std::abs(next - now));
    EXPECT_NEAR(way_after(1.0 - 1e-6, 1.0), now, 1e-5 * std::abs(next - now));
  }
}

TEST(FingerLock, LeavesNoEnergyUnbooked) {
  // What the drives put in and the springs of the product hold is found in fingers, guides and locks.
  for (const std::optional<double> stiffness :
       {std::optional<double>(), std::optional<double>(3e3), std::optional<double>(1e5)}) {
    LoneJaw jaw = pressing(locking(stiffness), 60);
    const double swinging_J = jaw.booked_J();
    jaw.lock(0.3);
    jaw.step();
    jaw.lock(1.0);
    for (int k = 0; k < 300; ++k) jaw.step();
    jaw.lock(0.0);
    jaw.set_speed(-0.1);
    for (int k = 0; k < 300; ++k) jaw.step();
    // The error of the method in so many swings is that of the free motion before.
    EXPECT_NEAR(jaw.booked_J(), 0.0, 2e-3 * jaw.fingers.positive_work()[LoneJaw::kLane])
        << stiffness.value_or(0.0) << ", before " << swinging_J;
    EXPECT_GT(jaw.fingers.dissipated()[LoneJaw::kLane], 0.0);
  }
}

TEST(FingerLock, OfALaneWithoutOneChangesNothing) {
  ParallelJawParameters plain;
  LoneJaw a(plain, 0.02, kLimit_N), b(plain, 0.02, kLimit_N);
  a.spring_N_m = b.spring_N_m = kProduct_N_m;
  b.lock(1.0);
  for (int k = 0; k < 200; ++k) {
    a.step();
    b.step();
    EXPECT_EQ(a.way(0), b.way(0)) << k;
  }
}

}  // namespace
}  // namespace unbruised
