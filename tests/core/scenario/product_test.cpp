#include "core/scenario/product.hpp"

#include <gtest/gtest.h>

#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Product, OfALatticeAnswersWithItsMaterialAndItsShape) {
  Scenario scenario = usual_grip();
  LatticeParameters& lattice = lattice_in(scenario);
  lattice.friction = 0.375;
  lattice.size_m = {0.1, 0.2, 0.3};
  EXPECT_EQ(product_friction(scenario.product), 0.375);
  EXPECT_EQ(shape_extents_m(scenario.product), lattice.size_m);
  EXPECT_EQ(yield_stress_Pa(scenario.product), 1e5);
  EXPECT_TRUE(can_yield(scenario.product));
  EXPECT_FALSE(has_loads(scenario.product));
}

TEST(Product, HardensSoThatUniaxialLoadingHasTheTangentModulus) {
  // Past yield 1 / E_t = 1 / E + 1 / H.
  const auto law = yield_law(usual_grip().product);
  ASSERT_TRUE(law.has_value());
  EXPECT_EQ(law->yield_stress_Pa, 1e5);
  const double tangent_Pa = 1.0 / (1.0 / 1e6 + 1.0 / law->hardening_modulus_Pa);
  EXPECT_NEAR(tangent_Pa, 2e5, 1e-9 * 2e5);  // six roundings
}

TEST(Product, WithoutAYieldStressStaysElastic) {
  Scenario scenario = usual_grip();
  lattice_in(scenario).yield_stress_Pa.reset();
  lattice_in(scenario).tangent_modulus_Pa.reset();
  EXPECT_FALSE(can_yield(scenario.product));
  EXPECT_FALSE(yield_stress_Pa(scenario.product).has_value());
  EXPECT_FALSE(yield_law(scenario.product).has_value());
}

TEST(Product, OfANetworkYieldsByItsSpringsAndHasNoShape) {
  Scenario scenario = usual_network();
  network_in(scenario).friction = 0.25;
  EXPECT_EQ(product_friction(scenario.product), 0.25);
  EXPECT_FALSE(shape_extents_m(scenario.product).has_value());
  EXPECT_FALSE(yield_stress_Pa(scenario.product).has_value());
  EXPECT_FALSE(yield_law(scenario.product).has_value());
  EXPECT_TRUE(can_yield(scenario.product));
  EXPECT_TRUE(has_loads(scenario.product));
  network_in(scenario).spring.front().yield_force_N.reset();
  network_in(scenario).load.clear();
  EXPECT_FALSE(can_yield(scenario.product));
  EXPECT_FALSE(has_loads(scenario.product));
}

}  // namespace
}  // namespace unbruised
