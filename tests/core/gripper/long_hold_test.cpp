// A minute in the gripper.

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(LongHold, DoesNotCreepForAMinuteAtTwiceTheNeededForce) {
  Scenario scenario = small_box();
  lattice_of(scenario).size_m = {0.05, 0.05, 0.05};
  jaw_of(scenario).pad_size_m = {0.04, 0.04};
  scenario.strategy.grip_force_N = 2.0 * 0.125 * kGravity / (2.0 * 0.5);
  scenario.strategy.hold_s = 60.0;
  scenario.strategy.lift_acceleration_m_s2 = 1.0;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(result.metrics[Metric::hold_drift_m_s], 1e-6);
  std::cout << "[ measured ] drift " << result.metrics[Metric::hold_drift_m_s] << " m/s over 60 s\n";
}

}  // namespace
}  // namespace unbruised
