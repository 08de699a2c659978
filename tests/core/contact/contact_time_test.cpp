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

/// The shipped silicone block between fingers of 0.1 kg and pads of 3 mm and 0.4 MPa.
Scenario gripped_block() {
  Scenario scenario;
  LatticeParameters block;
  block.size_m = {0.05, 0.05, 0.05};
  block.cell_size_m = 0.01;
  block.mass_kg = 0.1;
  block.youngs_modulus_Pa = 0.2e6;
  scenario.product = block;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).finger_mass_kg = 0.1;
  jaw_of(scenario).pad_size_m = {0.03, 0.03};
  scenario.strategy.approach_speed_m_s = 0.02;
  scenario.strategy.grip_force_N = 2.0;
  return scenario;
}

TEST(ContactTime, OfAFingerOnABlockIsHalfAPeriodOnLayerAndBlockInSeries) {
  const Scenario scenario = gripped_block();
  const double area = 9e-4, product = 0.2e6 * area / 0.025, layer = 0.4e6 * area / 0.003;
  const double expected = std::numbers::pi * std::sqrt(0.1 * (1.0 / product + 1.0 / layer));
  EXPECT_NEAR(finger_contact_time_s(scenario), expected, 1e-12);  // the same arithmetic in another order
  EXPECT_EQ(contact_time_s(scenario), finger_contact_time_s(scenario)) << "a block put down at rest hits nothing";
}

TEST(ContactTime, OfAFastFlatFingerIsAWholePeriodOfTheSurfaceOnTheLayer) {
  Scenario scenario = gripped_block();
  scenario.strategy.approach_speed_m_s = 0.2;
  // Half a cell of 10 mm at 800 kg/m3 under the pad, in relative motion with the finger.
  const double surface_kg = 800.0 * 0.005 * 9e-4, layer = 0.4e6 * 9e-4 / 0.003;
  const double relative_kg = surface_kg * 0.1 / (surface_kg + 0.1);
  EXPECT_NEAR(finger_surface_time_s(scenario), 2.0 * std::numbers::pi * std::sqrt(relative_kg / layer), 1e-12);
  EXPECT_EQ(contact_time_s(scenario), finger_surface_time_s(scenario));
  EXPECT_EQ(shortest_contact(scenario).part, ContactPart::finger_surface);
  // Finer cells stop sooner.
  const double coarse_s = finger_surface_time_s(scenario);
  std::get<LatticeParameters>(scenario.product).cell_size_m = 0.005;
  EXPECT_NEAR(finger_surface_time_s(scenario) / coarse_s, std::sqrt(0.5), 0.01);  // the finger's share
}

TEST(ContactTime, LeavesOutThePeakOfASurfaceThatDecidesNothing) {
  Scenario slow = gripped_block();  // 2.2 v sqrt(m k) = 0.67 N, pressed with 2 N
  slow.strategy.approach_speed_m_s = 0.015;
  EXPECT_EQ(finger_surface_time_s(slow), kNever);
  slow.strategy.grip_force_N = 0.5;
  slow.cell.gravity_m_s2 = {0.0, 0.0, -0.1};
  EXPECT_LT(finger_surface_time_s(slow), 1e-2);
  // With gravity nothing below 0.98 N / (2 x 0.5) holds it, so no answer rests on 0.5 N.
  slow.cell.gravity_m_s2 = {0.0, 0.0, -9.80665};
  EXPECT_EQ(finger_surface_time_s(slow), kNever);
  Scenario unjudged = gripped_block();
  unjudged.strategy.approach_speed_m_s = 0.2;
  unjudged.limits.damage = DamageJudging::not_considered;
  EXPECT_EQ(finger_surface_time_s(unjudged), kNever);
  Scenario curved = gripped_block();
  curved.strategy.approach_speed_m_s = 0.2;
  std::get<LatticeParameters>(curved.product).shape = Shape::sphere;
  EXPECT_EQ(finger_surface_time_s(curved), kNever);
}

TEST(ContactTime, OfAFlatBaseThatFallsCountsItsOwnSurface) {
  Scenario scenario = gripped_block();
  EXPECT_EQ(support_surface_time_s(scenario), kNever);
  scenario.strategy.release_height_m = 0.005;
  const double surface_kg = 800.0 * 0.005 * 25e-4;
  const double layer = scenario.cell.support_modulus_Pa / scenario.cell.support_thickness_m * 25e-4;
  EXPECT_NEAR(support_surface_time_s(scenario), 2.0 * std::numbers::pi * std::sqrt(surface_kg / layer), 1e-12);
  EXPECT_EQ(shortest_contact(scenario).part, ContactPart::support_surface);
  scenario.cell.support = false;
  EXPECT_EQ(support_surface_time_s(scenario), kNever);
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
