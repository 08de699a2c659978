// The motion of a body alone: what it takes in, and what it refuses.

#include "core/body/body_lanes.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

constexpr int kLane = 4;

class BodyLanesTest : public ::testing::Test {
 protected:
  BodyLanesTest() {
    Scenario scenario = testing::usual_network();
    NetworkParameters& network = testing::network_in(scenario);
    network.spring.front().stiffness_N_m = 0.0;  // a free particle beside a wall
    network.spring.front().yield_force_N.reset();
    std::string error;
    body_ = std::move(*build_body(scenario.product, w_, error));
    state_ = written_state(scenario.product, body_);
  }
  const WilsonTheta w_{1e-3, 1.4};
  BodyModel body_;
  BodyState state_;
};

TEST_F(BodyLanesTest, FreeParticleFollowsGravityAndTheForcesThatAreAdded) {
  // Acceleration constant from the start: u = a t^2 / 2 exactly, but for rounding.
  const std::array<double, 3> gravity_m_s2 = {0.0, 0.0, -10.0};
  const double force_N = 6.0, mass_kg = body_.mass_kg[1];
  state_.acceleration_m_s2 = {0.0, 0.0, 0.0, force_N / mass_kg, 0.0, -10.0};
  BodyLanes lanes(body_, w_);
  lanes.load(kLane, state_, gravity_m_s2);
  EXPECT_NEAR(lanes.mass_a()[2][kLane], -10.0 * mass_kg, 1e-14);
  Mask running(false);
  running.set(kLane, true);
  for (int k = 0; k < 100; ++k) {
    lanes.begin_step(running);
    lanes.add_forces(kLane,
                     std::vector<double>{9.0, 9.0, 9.0, force_N, 0.0, 0.0});  // the wall takes what acts on it
    lanes.start_solve(nullptr);
    lanes.finish_solve(running);
    lanes.advance(running);
  }
  EXPECT_NEAR(lanes.u().at(3, kLane), 0.5 * force_N / mass_kg * 0.01, 1e-13);
  EXPECT_NEAR(lanes.u().at(5, kLane), -0.5 * 10.0 * 0.01, 1e-13);
  EXPECT_EQ(lanes.u().at(0, kLane), 0.0);
  EXPECT_EQ(lanes.u().at(3, kLane + 1), 0.0) << "another lane";
}

TEST_F(BodyLanesTest, RefusesABodyThatIsNotFactored) {
  const BodyModel empty;
  EXPECT_THROW(BodyLanes(empty, w_), std::logic_error);
}

TEST_F(BodyLanesTest, RefusesStatesLanesAndForcesThatDoNotFit) {
  BodyLanes lanes(body_, w_);
  EXPECT_THROW(lanes.load(kLanes, state_, {}), std::logic_error);
  EXPECT_THROW(lanes.load(-1, state_, {}), std::logic_error);
  EXPECT_THROW(lanes.add_forces(kLane, std::vector<double>(3, 0.0)), std::logic_error);
  EXPECT_THROW(lanes.add_forces(kLanes, std::vector<double>(6, 0.0)), std::logic_error);
  const LaneArray load(3);
  EXPECT_THROW(lanes.start_solve(&load), std::logic_error);
  LaneArray base(4);
  const std::vector<int> particles = {1};
  EXPECT_THROW(lanes.solve_without_contact({.particle = particles, .reach = {}, .compliance = {}}, base),
               std::logic_error);
  EXPECT_THROW(lanes.add_contact(particles, {}, base), std::logic_error);
  state_.velocity_m_s.pop_back();
  EXPECT_THROW(lanes.load(kLane, state_, {}), std::logic_error);
}

TEST_F(BodyLanesTest, RefusesParametersOfAnotherBody) {
  Scenario other = testing::usual_network();
  testing::network_in(other).particle.emplace_back();
  EXPECT_THROW(written_state(other.product, body_), std::logic_error);
}

TEST(StaticSolver, RefusesForcesAndFreedomsOfAnotherBody) {
  std::string error;
  const auto body = build_body(testing::usual_network().product, WilsonTheta(1e-3, 1.4), error);
  ASSERT_TRUE(body && body->statics) << error;
  EXPECT_THROW(body->statics->free_shape(std::vector<double>(5, 0.0)), std::logic_error);
  EXPECT_THROW(body->statics->compliance(std::vector<std::size_t>{6}), std::logic_error);
}

}  // namespace
}  // namespace unbruised
