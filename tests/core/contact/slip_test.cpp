// Slip is the way that a person would measure between pad and product.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Slip, IsTheWayOfThePadAlongAProductThatStays) {
  // A slippery post stands on the floor while the pads are lifted along it: contacts at the pads' edges open and
  // close, and each knows only its own part of the way.
  const ScenarioResult result = run(standing_post(0.0));
  EXPECT_EQ(result.outcome, Outcome::slipped) << result.cause;
  // The springs of the pads take some 10 um of it; the mean travel of closed contacts saturated at 26 mm.
  EXPECT_NEAR(result.metrics[Metric::slip_max_m], 0.04, 1e-4);
}

TEST(Slip, DoesNotDependOnHowFineTheFaceIs) {
  // 2 mu F = 0.12 N carries 8 g at rest (0.08 N), not at 10 m/s2 (0.16 N): it slips while the lift speeds up, and
  // sticks again.
  std::vector<double> slip;
  for (const double cell : {0.01, 0.005}) {
    Scenario scenario = small_box();
    lattice_of(scenario).cell_size_m = cell;
    lattice_of(scenario).youngs_modulus_Pa = 1e6;
    scenario.strategy.grip_force_N = 0.12;
    scenario.strategy.lift_acceleration_m_s2 = 10.0;
    scenario.strategy.hold_s = 0.1;
    scenario.cell.transfer_m = {0.0, 0.0};
    scenario.strategy.release_height_m = 0.008;  // it hangs lower than it stood
    scenario.simulation.duration_s = 0.45;       // and would land harder than a millisecond resolves
    scenario.limits.slip_m = 0.1;
    const ScenarioResult result = run(scenario);
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    slip.push_back(result.metrics[Metric::slip_max_m]);
  }
  EXPECT_GT(slip[0], 1e-3);
  EXPECT_NEAR(slip[1], slip[0], 0.03 * slip[0]) << "of what the faces deform";
}

}  // namespace
}  // namespace unbruised
