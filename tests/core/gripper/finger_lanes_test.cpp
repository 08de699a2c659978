// The two fingers of a jaw alone: the law of their drives, the end stop, how they start, and what moves both.

#include "core/gripper/finger_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr int kLane = 5;
/// Of the end stop [N/m]: steel on steel.
constexpr double kStop_N_m = 1e7;
using Forces = std::array<double, kJawFingers>;

/// One jaw in one lane, stepped under commands and contact forces that hold at t + theta dt.
class Jaw {
 public:
  Jaw(const ParallelJawParameters& jaw, double closing_speed_m_s, double force_limit_N, double opened_m = 0.0) {
    fingers.load(kLane, &jaw, closing_speed_m_s, force_limit_N, opened_m);
    running_.set(kLane, true);
    command_.force_limit_N.set(kLane, force_limit_N);
    command_.set_speed_m_s.set(kLane, closing_speed_m_s);
  }
  void set_speed(double speed_m_s) { command_.set_speed_m_s.set(kLane, speed_m_s); }
  void palm_acceleration(double a_m_s2) {
    for (int f = 0; f < kJawFingers; ++f) {
      command_.palm_acceleration_m_s2[static_cast<std::size_t>(f)].set(kLane, normal_sign(f) * a_m_s2);
    }
  }
  void spin_across(double rad_s) {
    for (Lane& square : command_.centrifugal_1_s2) square.set(kLane, rad_s * rad_s);
  }
  void begin() { fingers.begin_step(w, command_); }
  void end(const Forces& contact_N) { fingers.advance(w, lanes(contact_N), running_); }
  void step(const Forces& contact_N = {}) {
    begin();
    end(contact_N);
  }
  [[nodiscard]] double way_at_theta(int finger, const Forces& contact_N) const {
    return fingers.way_at_theta(finger, lanes(contact_N))[kLane];
  }
  [[nodiscard]] double way(int finger) const { return fingers.way(finger)[kLane]; }
  [[nodiscard]] double speed(int finger) const { return fingers.speed(finger)[kLane]; }
  [[nodiscard]] double acceleration(int finger) const { return fingers.acceleration(finger)[kLane]; }

  const WilsonTheta w{1e-3, 1.4};
  FingerLanes fingers;

 private:
  static FingerForces lanes(const Forces& contact_N) {
    FingerForces all;
    all.fill(Lane(0.0));
    for (std::size_t f = 0; f < kJawFingers; ++f) all[f].set(kLane, contact_N[f]);
    return all;
  }
  Mask running_{false};
  DriveCommand command_;
};

ParallelJawParameters jaw_with(FingerCoupling coupling) {
  ParallelJawParameters jaw;
  jaw.finger_mass_kg = 0.1;
  jaw.drive_gain_N_s_m = 500.0;
  jaw.drive_viscous_N_s_m = 20.0;
  jaw.stroke_m = 0.04;
  jaw.coupling = coupling;
  return jaw;
}

constexpr std::array<FingerCoupling, 2> kCouplings = {FingerCoupling::centric, FingerCoupling::independent};

TEST(FingerLanes, StartInTheSteadyMotionThatTheirDriveKeepsUp) {
  // gain (v_set - v) = c v; nothing accelerates, so they go on like that.
  const double steady = 0.05 * 500.0 / 520.0;
  for (const FingerCoupling coupling : kCouplings) {
    Jaw jaw(jaw_with(coupling), 0.05, 10.0);
    for (int k = 0; k < 100; ++k) jaw.step();
    for (int f = 0; f < kJawFingers; ++f) {
      // Rounding of a hundred steps.
      EXPECT_NEAR(jaw.speed(f), steady, 1e-13);
      EXPECT_NEAR(jaw.way(f), 0.1 * steady, 1e-14);
      EXPECT_NEAR(jaw.acceleration(f), 0.0, 1e-10);
    }
    // The drive's work goes into the guides: c v^2 t for each finger.
    const double guided_J = kJawFingers * 20.0 * steady * steady * 0.1;
    EXPECT_NEAR(jaw.fingers.work()[kLane], guided_J, 1e-12 * guided_J);
    EXPECT_NEAR(jaw.fingers.dissipated()[kLane], guided_J, 1e-12 * guided_J);
    EXPECT_NEAR(jaw.fingers.energy()[kLane], kJawFingers * 0.5 * 0.1 * steady * steady, 1e-14);
  }
}

TEST(FingerLanes, StartWithTheSpeedThatIsSetAndAreBrakedWhereTheLimitIsTooLow) {
  // 0.4 N against a guide that takes 1 N at this speed: v = L/c + (v_0 - L/c) exp(-c t/m).
  const double limit_N = 0.4, c = 20.0, m = 0.1, v = 0.05;
  Jaw jaw(jaw_with(FingerCoupling::independent), v, limit_N);
  EXPECT_EQ(jaw.speed(0), v);
  EXPECT_NEAR(jaw.acceleration(0), (limit_N - c * v) / m, 1e-12);
  for (int k = 1; k <= 50; ++k) {
    jaw.step();
    const double wanted = limit_N / c + (v - limit_N / c) * std::exp(-c * 1e-3 * k / m);
    // Second order in the step: theta^2 (c dt/m)^2 / 2 of what changes, 0.04 here.
    EXPECT_NEAR(jaw.speed(0), wanted, 0.04 * (v - limit_N / c)) << k;
    EXPECT_GT(jaw.speed(0), limit_N / c);
  }
}

TEST(FingerLanes, ReachTheSpeedThatIsSetAndNoMore) {
  // From rest: v = v_set gain / (gain + c) (1 - exp(-t / tau)), tau = m / (gain + c) = 20 steps.
  ParallelJawParameters p = jaw_with(FingerCoupling::centric);
  p.drive_gain_N_s_m = 4.0;
  p.drive_viscous_N_s_m = 1.0;
  p.stroke_m = 1.0;
  Jaw jaw(p, 0.0, 100.0);
  jaw.set_speed(0.2);
  const double steady = 0.2 * 4.0 / 5.0, tau_s = 0.1 / 5.0;
  for (int k = 1; k <= 1000; ++k) {
    jaw.step();
    const double wanted = steady * (1.0 - std::exp(-k * jaw.w.dt / tau_s));
    // The drive's jump is spread over theta dt; no motion lags by more, theta dt / tau = 0.07 of its speed.
    EXPECT_NEAR(jaw.speed(0), wanted, 0.07 * steady) << k;
    EXPECT_LE(jaw.speed(0), steady * (1.0 + 1e-12)) << k;
  }
  EXPECT_NEAR(jaw.speed(0), steady, 1e-12 * steady);  // after fifty tau only rounding is left
}

TEST(FingerLanes, SolveTheBalanceWithTheClampedDriveAtTheta) {
  // (a0 m + a1 c) w = m (...) + c (...) + clamp(gain (v_set - v), +-limit) - S, with v = a1 w - (...): the drive
  // regulates, saturates forwards and saturates backwards.
  struct Case {
    double set_speed_m_s, contact_N, drive_N;
  };
  const ParallelJawParameters p = jaw_with(FingerCoupling::independent);
  for (const Case& c : {Case{0.05, 0.0, NAN}, Case{0.05, 300.0, 3.0}, Case{-0.05, 0.0, -3.0}}) {
    Jaw jaw(p, 0.05, 3.0);
    jaw.step({0.1, 0.2});
    jaw.set_speed(c.set_speed_m_s);
    const double u = jaw.way(0), v = jaw.speed(0), a = jaw.acceleration(0);
    jaw.begin();
    const double way = jaw.way_at_theta(0, {c.contact_N, 0.0});
    const double viscous = jaw.w.viscous(u, v, a);
    const double wanted_N = p.drive_gain_N_s_m * (c.set_speed_m_s - (jaw.w.a1 * way - viscous));
    const double drive_N = std::clamp(wanted_N, -3.0, 3.0);
    if (std::isnan(c.drive_N)) {
      EXPECT_EQ(drive_N, wanted_N) << "regulates";
    } else {
      EXPECT_EQ(drive_N, c.drive_N) << "saturates";
    }
    const double stiffness = jaw.w.a0 * p.finger_mass_kg + jaw.w.a1 * p.drive_viscous_N_s_m;
    const double push_N = p.finger_mass_kg * jaw.w.inertial(u, v, a) + p.drive_viscous_N_s_m * viscous;
    // Rounding of the sums, times the gain's share of the stiffness, about 3.
    EXPECT_NEAR(stiffness * way, push_N + drive_N - c.contact_N, 1e-13 * (push_N + 300.0));
  }
}

TEST(FingerLanes, YieldToContactForcesByTheComplianceTheySay) {
  for (const FingerCoupling coupling : kCouplings) {
    Jaw jaw(jaw_with(coupling), 0.0, 0.0);  // without drive it is linear
    jaw.begin();
    const double compliance = jaw.fingers.compliance()[kLane];
    for (int f = 0; f < kJawFingers; ++f) {
      Forces own{};
      own[static_cast<std::size_t>(f)] = 2.0;
      const double moved = jaw.way_at_theta(f, own) - jaw.way_at_theta(f, {});
      EXPECT_NEAR(moved, -2.0 * compliance, 1e-14 * compliance);
    }
  }
}

TEST(FingerLanes, RestAgainstTheEndOfTheirStrokePressedInByTheDrive) {
  for (const FingerCoupling coupling : kCouplings) {
    ParallelJawParameters p = jaw_with(coupling);
    p.stroke_m = 1e-3;
    const double limit_N = 50.0;
    Jaw jaw(p, 0.05, limit_N);
    jaw.set_speed(0.5);  // at rest the drive wants 250 N and gives its limit
    EXPECT_FALSE(jaw.fingers.at_end_of_stroke()[kLane]);
    for (int k = 0; k < 400; ++k) jaw.step();
    const double depth = limit_N / kStop_N_m;
    for (int f = 0; f < kJawFingers; ++f) {
      // The impact has died away to rounding of the way over the length of a step.
      EXPECT_NEAR(jaw.way(f), p.stroke_m + depth, 1e-9 * p.stroke_m);
      EXPECT_NEAR(jaw.speed(f), 0.0, 1e-9);
    }
    EXPECT_TRUE(jaw.fingers.at_end_of_stroke()[kLane]);
    const double stored_J = kJawFingers * 0.5 * kStop_N_m * depth * depth;
    EXPECT_NEAR(jaw.fingers.energy()[kLane], stored_J, 1e-6 * stored_J);
    // What the contacts carry the stop need not.
    for (int k = 0; k < 400; ++k) jaw.step({20.0, 20.0});
    EXPECT_NEAR(jaw.way(0), p.stroke_m + (limit_N - 20.0) / kStop_N_m, 1e-9 * p.stroke_m);
  }
}

TEST(FingerLanes, StayWhereTheyAreInSpaceWhileAnAcceleratedPalmLeavesThem) {
  // Independent fingers without drive and friction: w'' = -dir a_palm. With a = j t the acceleration is linear, as
  // the method assumes, so dir w = -j t^3 / 6 to rounding; the distance of the fingers stays.
  ParallelJawParameters p = jaw_with(FingerCoupling::independent);
  p.drive_viscous_N_s_m = 0.0;
  Jaw jaw(p, 0.0, 0.0);
  const double jerk = 30.0;
  for (int k = 1; k <= 100; ++k) {
    jaw.palm_acceleration(jerk * (k - 1 + jaw.w.theta) * jaw.w.dt);
    jaw.step();
    const double t = k * jaw.w.dt;
    for (int f = 0; f < kJawFingers; ++f) {
      EXPECT_NEAR(jaw.way(f), -normal_sign(f) * jerk * t * t * t / 6.0, 1e-11 * jerk * t) << k;
    }
    EXPECT_NEAR(jaw.fingers.closing()[kLane], 0.0, 1e-15);
  }
}

TEST(FingerLanes, FlyApartFromATurningPalmThatNothingHoldsThemTo) {
  // s'' = Omega^2 s of the distance s from the axis: s = s_0 cosh(Omega t).
  ParallelJawParameters free = jaw_with(FingerCoupling::centric);
  free.drive_viscous_N_s_m = 0.0;
  const double opened_m = 0.03, spin_rad_s = 8.0;
  Jaw jaw(free, 0.0, 0.0, opened_m);
  jaw.spin_across(spin_rad_s);
  const int steps = 125;
  for (int k = 0; k < steps; ++k) jaw.step();
  const double expected_m = opened_m * std::cosh(spin_rad_s * steps * jaw.w.dt);
  // The pull is taken at the start of a step: theta Omega dt = 1 % late.
  for (int f = 0; f < kJawFingers; ++f) EXPECT_NEAR(opened_m - jaw.way(f), expected_m, 0.01 * expected_m);
}

TEST(FingerLanes, OnARackMoveAsOneUnderTheMeanOfTheirContactForces) {
  // Neither the palm's acceleration nor the difference of the forces moves a rack: m w'' = -(S_0 + S_1) / 2,
  // linear in time here.
  ParallelJawParameters p = jaw_with(FingerCoupling::centric);
  p.drive_viscous_N_s_m = 0.0;
  Jaw jaw(p, 0.0, 0.0);
  for (int k = 1; k <= 100; ++k) {
    const double later = (k - 1 + jaw.w.theta) * jaw.w.dt;
    jaw.palm_acceleration(20.0);
    jaw.step({3.0 * later, 1.0 * later});
    const double t = k * jaw.w.dt;
    EXPECT_EQ(jaw.way(0), jaw.way(1)) << k;
    EXPECT_NEAR(jaw.way(0), -2.0 * t * t * t / (6.0 * p.finger_mass_kg), 1e-10 * t) << k;
  }
}

TEST(FingerLanes, EachAnswerToTheirOwnContactWhereTheyAreDrivenAlone) {
  ParallelJawParameters p = jaw_with(FingerCoupling::independent);
  p.drive_viscous_N_s_m = 0.0;
  Jaw jaw(p, 0.0, 0.0);
  for (int k = 1; k <= 100; ++k) jaw.step({3.0 * (k - 1 + jaw.w.theta) * jaw.w.dt, 0.0});
  EXPECT_NEAR(jaw.way(0), -3.0 * 1e-3 / (6.0 * p.finger_mass_kg), 1e-11);  // t = 0.1 s
  EXPECT_EQ(jaw.way(1), 0.0);
  EXPECT_EQ(jaw.fingers.furthest_way()[kLane], 0.0);
}

TEST(FingerLanes, OfALaneThatDoesNotRunKeepTheirState) {
  Jaw jaw(jaw_with(FingerCoupling::centric), 0.05, 10.0);
  jaw.begin();
  const double speed = jaw.speed(0);
  jaw.fingers.advance(jaw.w, {Lane(1.0), Lane(1.0)}, Mask(false));
  EXPECT_EQ(jaw.way(0), 0.0);
  EXPECT_EQ(jaw.speed(0), speed);
  EXPECT_EQ(jaw.fingers.work()[kLane], 0.0);
}

TEST(FingerLanes, AreLoadedIntoALaneThatThereIs) {
  FingerLanes fingers;
  const ParallelJawParameters jaw;
  EXPECT_THROW(fingers.load(-1, &jaw, 0.05, 10.0), std::logic_error);
  EXPECT_THROW(fingers.load(kLanes, &jaw, 0.05, 10.0), std::logic_error);
}

TEST(FingerLanes, WithoutAJawStayAtRest) {
  FingerLanes fingers;
  fingers.load(kLane, nullptr, 0.05, 10.0);
  const WilsonTheta w(1e-3, 1.4);
  fingers.begin_step(w, {});
  fingers.advance(w, {Lane(0.0), Lane(0.0)}, Mask(true));
  for (int f = 0; f < kJawFingers; ++f) EXPECT_EQ(fingers.way(f)[kLane], 0.0);
  EXPECT_EQ(fingers.energy()[kLane], 0.0);
}

}  // namespace
}  // namespace unbruised
