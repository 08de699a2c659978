#include "core/contact/contact_time.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// physics.md, Hertz impact: a ball of R = 30 mm, E = 1 MPa, nu = 0.3, 0.1130973 kg meets a rigid plane.
Scenario falling_ball(double speed_m_s) {
  Scenario scenario;
  LatticeParameters ball;
  ball.shape = Shape::sphere;
  ball.size_m = {0.06, 0.06, 0.06};
  ball.mass_kg = 0.1130973;
  ball.youngs_modulus_Pa = 1e6;
  ball.poisson_ratio = 0.3;
  ball.initial_velocity_m_s = {0.0, 0.0, -speed_m_s};
  scenario.product = ball;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support_modulus_Pa = 1e12;  // rigid
  return scenario;
}

TEST(ContactTime, OfABallOnARigidPlaneIsAFixedPartOfThatOfHertz) {
  // tests/reference-data: t_c = 2.943275 d_m / v. Half a period on the stiffness of the largest force, which
  // F = v sqrt(m k) puts at d = 1.2^0.4 d_m, is (2 pi / 3) d / v = 0.7655 t_c at every speed. Four iterations
  // leave a per cent.
  for (const auto& [speed_m_s, hertz_s] : {std::pair{0.1, 14.6958e-3}, {0.5, 10.6512e-3}, {1.0, 9.2724e-3}}) {
    EXPECT_NEAR(support_contact_time_s(falling_ball(speed_m_s)) / hertz_s, 0.7655, 0.01) << speed_m_s;
  }
}

TEST(ContactTime, OfAFingerOnABlockIsHalfAPeriodOnLayerAndBlockInSeries) {
  Scenario scenario;
  LatticeParameters block;
  block.size_m = {0.05, 0.05, 0.05};
  block.youngs_modulus_Pa = 0.2e6;
  scenario.product = block;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).finger_mass_kg = 0.1;
  jaw_of(scenario).pad_size_m = {0.03, 0.03};
  const double area = 9e-4, product = 0.2e6 * area / 0.025, layer = 0.4e6 * area / 0.003;
  const double expected = std::numbers::pi * std::sqrt(0.1 * (1.0 / product + 1.0 / layer));
  EXPECT_NEAR(finger_contact_time_s(scenario), expected, 1e-12);  // the same arithmetic in another order
  EXPECT_EQ(contact_time_s(scenario), finger_contact_time_s(scenario)) << "a block put down at rest hits nothing";
}

TEST(ContactTime, OfANetworkIsHalfAPeriodOfItsMassOnItsTouchingLayers) {
  Scenario scenario;
  NetworkParameters ball;
  ball.particle.resize(1);
  ball.particle[0].mass_kg = 0.05;
  ball.particle[0].contact_stiffness_N_m = 5000.0;
  scenario.product = ball;
  // physics.md: the contact of 50 g on 5 kN/m lasts 10.07 ms with gravity, pi sqrt(m / k) = 9.93 ms without.
  EXPECT_NEAR(contact_time_s(scenario), std::numbers::pi * std::sqrt(0.05 / 5000.0), 1e-12);
  scenario.cell.support = false;
  EXPECT_EQ(contact_time_s(scenario), kNever);
}

TEST(ContactTime, CountsTheSupportOnlyWhereTheProductFallsOntoIt) {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  std::get<LatticeParameters>(scenario.product).mass_kg = 0.1;
  EXPECT_EQ(support_contact_time_s(scenario), kNever);
  scenario.strategy.release_height_m = 0.02;
  EXPECT_LT(support_contact_time_s(scenario), 1.0);
  EXPECT_EQ(support_contact_time_s(falling_ball(0.0)), kNever);
}

}  // namespace
}  // namespace unbruised
