#include "core/body/body_state.hpp"

#include <gtest/gtest.h>

#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

BodyModel built(const Scenario& scenario) {
  std::string error;
  auto body = build_body(scenario.product, WilsonTheta(1e-3, 1.4), error);
  EXPECT_TRUE(body.has_value()) << error;
  return std::move(*body);
}

TEST(BodyState, OfASolidMovesAsAWholeAndIsNotDeformed) {
  Scenario scenario = usual_grip();
  lattice_in(scenario).initial_velocity_m_s = {1.0, 2.0, 3.0};
  const BodyModel body = built(scenario);
  EXPECT_TRUE(body.is_solid);
  const BodyState state = written_state(scenario.product, body);
  ASSERT_EQ(state.velocity_m_s.size(), 3 * body.particle_count);
  for (std::size_t i = 0; i < state.velocity_m_s.size(); ++i) {
    EXPECT_EQ(state.displacement_m[i], 0.0);
    EXPECT_EQ(state.velocity_m_s[i], 1.0 + static_cast<double>(i % 3));
    EXPECT_EQ(state.acceleration_m_s2[i], 0.0);
  }
  EXPECT_EQ(written_load_N(scenario.product, body, 0.5), std::vector<double>(3 * body.particle_count, 0.0));
}

TEST(BodyState, OfANetworkIsWrittenParticleByParticleAndWallsStay) {
  Scenario scenario = usual_network();
  for (NetworkParticle& particle : network_in(scenario).particle) {
    particle.initial_displacement_m = {0.1, 0.2, 0.3};
    particle.initial_velocity_m_s = {4.0, 5.0, 6.0};
  }
  const BodyModel body = built(scenario);
  EXPECT_FALSE(body.is_solid);
  const BodyState state = written_state(scenario.product, body);
  EXPECT_EQ(state.displacement_m, (std::vector<double>{0.0, 0.0, 0.0, 0.1, 0.2, 0.3}));
  EXPECT_EQ(state.velocity_m_s, (std::vector<double>{0.0, 0.0, 0.0, 4.0, 5.0, 6.0}));
  // The load on particle 1 goes from (1, 0, 0) to (0, 2, 0) within a second.
  EXPECT_EQ(written_load_N(scenario.product, body, 0.5), (std::vector<double>{0.0, 0.0, 0.0, 0.5, 1.0, 0.0}));
}

}  // namespace
}  // namespace unbruised
