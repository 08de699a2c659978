// Drives that press with less the faster they go: against closed forms, and the balance they are solved from.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/gripper/force_curve_lanes.hpp"
#include "tests/core/gripper/lone_jaw.hpp"

namespace unbruised {
namespace {

using testing::LoneJaw;

/// No guide, and a gain that lets the curve alone decide.
ParallelJawParameters with_curve(const std::vector<double>& speed_m_s, const std::vector<double>& force_N) {
  ParallelJawParameters jaw;
  jaw.coupling = FingerCoupling::independent;
  jaw.finger_mass_kg = 0.1;
  jaw.drive_gain_N_s_m = 1e5;
  jaw.drive_viscous_N_s_m = 0.0;
  jaw.stroke_m = 10.0;
  jaw.curve_speed_m_s = speed_m_s;
  jaw.curve_force_N = force_N;
  return jaw;
}

double on_curve(const ParallelJawParameters& jaw, double speed_m_s) {
  const auto& v = jaw.curve_speed_m_s;
  const auto& f = jaw.curve_force_N;
  if (speed_m_s <= v.front()) return f.front();
  for (std::size_t i = 1; i < v.size(); ++i) {
    if (speed_m_s <= v[i]) return f[i - 1] + (f[i] - f[i - 1]) * (speed_m_s - v[i - 1]) / (v[i] - v[i - 1]);
  }
  return f.back();
}

TEST(ForceCurve, IsLinearBetweenItsPointsAndFlatBeyond) {
  const ParallelJawParameters jaw = with_curve({0.0, 0.1, 0.3}, {20.0, 15.0, 5.0});
  ForceCurveLanes curve;
  curve.load(2, jaw.curve_speed_m_s, jaw.curve_force_N);
  curve.load(4, {}, {});
  for (const double speed : {-1.0, 0.0, 0.05, 0.1, 0.2, 0.3, 4.0}) {
    EXPECT_NEAR(curve.force_N(Lane(speed))[2], on_curve(jaw, speed), 1e-13) << speed;
    EXPECT_GT(curve.force_N(Lane(speed))[4], 1e100) << "no curve, no limit";
  }
  curve.load(2, {}, {});
  EXPECT_GT(curve.force_N(Lane(0.2))[2], 1e100) << "a lane forgets";
}

TEST(ForceCurve, OfAStraightLineLetsAFingerComeToItsNoLoadSpeedExponentially) {
  // m v' = F0 (1 - v / v0): v = v0 (1 - exp(-F0 t / (m v0))), 20 ms here.
  const double v0 = 0.2, F0 = 1.0, tau_s = 0.1 * v0 / F0;
  double coarse = 0.0;
  for (const double dt : {1e-3, 5e-4, 2.5e-4}) {
    LoneJaw jaw(with_curve({0.0, v0}, {F0, 0.0}), 0.0, 100.0, dt);
    jaw.set_speed(1.0);
    double worst = 0.0;
    for (int k = 1; k * dt < 10.0 * tau_s; ++k) {
      jaw.step();
      worst = std::max(worst, std::abs(jaw.speed(0) - v0 * (1.0 - std::exp(-k * dt / tau_s))));
      EXPECT_LT(jaw.speed(0), v0 * (1.0 + 1e-12));
    }
    // The drive's jump at the start is spread over theta dt, by which the motion lags.
    EXPECT_LT(worst, 1.4 * dt / tau_s * v0);
    if (coarse > 0.0) {
      EXPECT_LT(worst, 0.6 * coarse) << "first order from the jump";
    }
    coarse = worst;
    EXPECT_NEAR(jaw.speed(0), v0, 1e-4 * v0);  // exp(-10)
  }
}

TEST(ForceCurve, MeetsTheFrictionOfTheGuideWhereTheyAreEqual) {
  // c v = F(v) on each piece: 20 - 50 v, and 15 - 50 (v - 0.1) further out.
  for (const auto& [c, speed] : {std::pair{400.0, 20.0 / 450.0}, std::pair{50.0, 20.0 / 100.0}}) {
    ParallelJawParameters p = with_curve({0.0, 0.1, 0.3}, {20.0, 15.0, 5.0});
    p.drive_viscous_N_s_m = c;
    LoneJaw jaw(p, 0.0, 100.0);
    jaw.set_speed(1.0);
    for (int k = 0; k < 500; ++k) jaw.step();
    EXPECT_NEAR(jaw.speed(0), speed, 1e-9);
    EXPECT_NEAR(jaw.speed(0), jaw.speed(1), 1e-15);
  }
}

TEST(ForceCurve, BrakesWithTheForceAtRest) {
  // Against the motion a drive gives what it gives at rest: v = v0 - F0 t / m.
  LoneJaw jaw(with_curve({0.0, 0.5}, {2.0, 0.0}), 0.3, 100.0);
  jaw.set_speed(-0.1);
  const double before = jaw.speed(0);
  for (int k = 0; k < 10; ++k) jaw.step();
  EXPECT_NEAR(before - jaw.speed(0), 2.0 * 0.01 / 0.1, 0.14 * 0.2) << "the jump lags by theta dt";
}

TEST(ForceCurve, LeavesTheForceOfAFingerAtRestAsItIsSet) {
  for (const double limit_N : {5.0, 20.0}) {
    ParallelJawParameters p = with_curve({0.0, 0.1, 0.3}, {20.0, 15.0, 5.0});
    p.drive_viscous_N_s_m = 10.0;
    LoneJaw jaw(p, 0.02, limit_N);
    jaw.spring_N_m = 2e3;
    jaw.set_speed(0.5);
    for (int k = 0; k < 1000; ++k) jaw.step();
    EXPECT_NEAR(jaw.contact_N(0), limit_N, 1e-6);
  }
}

TEST(ForceCurve, IsSolvedToRounding) {
  // (a0 m + a1 c) w = push - S + D, D the speed control between the curve's limits, for any state and contact.
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int round = 0; round < 400; ++round) {
    std::vector<double> v = {0.0}, f = {10.0 * share(chance) + 1.0};
    for (int i = 0; i < 1 + round % 4; ++i) {
      v.push_back(v.back() + 0.01 + 0.2 * share(chance));
      f.push_back(f.back() * share(chance));
    }
    ParallelJawParameters p = with_curve(v, f);
    p.drive_gain_N_s_m = std::exp(8.0 * share(chance));
    p.drive_viscous_N_s_m = 5.0 * share(chance);
    const double limit_N = 8.0 * share(chance), set_speed = 0.8 * share(chance) - 0.4;
    LoneJaw jaw(p, 0.3 * share(chance), limit_N);
    const double contact_N = 20.0 * share(chance) - 5.0;
    for (int k = 0; k < round % 3; ++k) jaw.step_under({contact_N, 0.0});
    jaw.set_speed(set_speed);
    const double u = jaw.way(0), speed = jaw.speed(0), a = jaw.acceleration(0);
    const double way = jaw.way_at_theta_m(0, {contact_N, 0.0});
    const double viscous = jaw.w.viscous(u, speed, a), v_theta = jaw.w.a1 * way - viscous;
    const double most = std::min(limit_N, on_curve(p, v_theta)), least = -std::min(limit_N, on_curve(p, -v_theta));
    const double drive_N = std::clamp(p.drive_gain_N_s_m * (set_speed - v_theta), least, most);
    const double stiffness = jaw.w.a0 * p.finger_mass_kg + jaw.w.a1 * p.drive_viscous_N_s_m;
    const double push_N = p.finger_mass_kg * jaw.w.inertial(u, speed, a) + p.drive_viscous_N_s_m * viscous;
    // Rounding of the way (1e-16 of it), times the stiffness and the gain over the step, a1 x gain of some 1e7.
    const double rounding = 1e-14 * (std::abs(push_N) + 30.0) * (1.0 + jaw.w.a1 * p.drive_gain_N_s_m / stiffness);
    EXPECT_NEAR(stiffness * way, push_N + drive_N - contact_N, rounding) << "round " << round;
  }
}

}  // namespace
}  // namespace unbruised
