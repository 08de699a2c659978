// The plane under a product: another one once the product is lifted, and never within it.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Support, OfAProductThatWasNotLiftedStaysWhereItIs) {
  for (const double height : {0.0, 0.03}) {
    Trace trace;
    const ScenarioResult result = run(standing_post(height), &trace);
    EXPECT_EQ(result.outcome, Outcome::slipped) << result.cause;
    // The pads pull at most 2 mu F = 0.2 N upwards and later downwards; landing of the pads' pull rings a little.
    EXPECT_LT(largest(column(trace, "support_force_N", 2)), 1.0 * kGravity + 1.0) << height;
    // 3e-3 at this step and mesh, of second order in the step; a plane that jumped into the post made 2.5e4.
    EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 6e-3) << height;
  }
}

TEST(Support, IsTheTargetPlaneOnceTheProductHangsAboveIt) {
  Scenario scenario = small_box();
  scenario.cell.place_height_m = 0.015;
  scenario.strategy.recover_s = 0.3;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  // At the end it stands 15 mm higher than where it began, pressed into the layer as it was.
  const std::size_t rows = trace.time_s.size(), width = 3 * static_cast<std::size_t>(trace.particle_count);
  EXPECT_NEAR(trace.displacement_m[(rows - 1) * width + 2], 0.015 + trace.displacement_m[2], 2e-6);
}

TEST(Support, EndsUnderAProductThatIsCarriedOffWithoutALift) {
  Scenario scenario = small_box();
  scenario.cell.lift_height_m = 0.0;
  scenario.cell.place_height_m = -0.01;
  scenario.strategy.recover_s = 0.3;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  // What the layer under it held is booked as it goes: 5e-8 J of 2e-3 J.
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 5e-3);
}

TEST(Support, ABodyAtRestHasNoEnergyBalanceToBeOff) {
  Scenario scenario = small_box();
  scenario.gripper = NoGripper{};
  scenario.simulation.duration_s = 0.1;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_TRUE(std::isnan(result.metrics[Metric::energy_balance_error]));
}

TEST(Support, AProductThatFallsForEverAfterItsReleaseWasHeld) {
  Scenario scenario = small_box();
  only_grip(scenario);
  scenario.cell.gravity_m_s2 = {0.0, 0.5, 0.0};  // it turns a little as it leaves the pads
  scenario.cell.grip_offset_m = 0.004;
  scenario.strategy.recover_s = 5.0;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
}

TEST(Layers, PressedFlatAreOutOfRange) {
  Scenario scenario = small_box();
  make_product(scenario, {0.05, 0.05, 0.05}, 0.0125, 0.1, 1e9).shape = Shape::sphere;
  jaw_of(scenario).pad_size_m = {0.2, 0.2};
  only_grip(scenario);
  scenario.strategy.approach_speed_m_s = 0.02;
  scenario.simulation.time_step_s = 5e-4;
  // A stiff ball in a layer of thickness t: F = pi R k d^2 with k = E/t. At 100 N d = 3.1 mm of 3 mm; at 30 N
  // d = 1.7 mm.
  scenario.strategy.grip_force_N = 100.0;
  const ScenarioResult flat = run(scenario);
  EXPECT_EQ(flat.outcome, Outcome::out_of_range);
  EXPECT_EQ(flat.cause,
            "a pad, the support or a surface of the cell is pressed in by more than 80 % of its thickness");
  scenario.strategy.grip_force_N = 30.0;
  EXPECT_EQ(run(scenario).outcome, Outcome::held);
}

}  // namespace
}  // namespace unbruised
