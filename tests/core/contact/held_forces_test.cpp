// A step of a free solid begins with the contact forces of the last one: what is met follows from a motion under
// them, and what they act on is no matter of what other lanes touch.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/contact/kiwi_scenes.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

double first_contact_s(double time_step_s, double gap_m) {
  Scenario scenario = kiwi_grip(0.00833);
  scenario.cell.approach_gap_m = gap_m;
  scenario.simulation.levels = LevelUse::off;
  scenario.simulation.time_step_s = time_step_s;
  scenario.simulation.duration_s = gap_m / scenario.strategy.approach_speed_m_s + 0.02;
  return run_side_by_side({scenario}).front().metrics[Metric::first_contact_time_s];
}

// One that fell freely for the step in which it is met was met up to 35 us late. What is left is its own sway.
TEST(HeldForces, AKiwiOnItsSupportIsMetWhereFineStepsMeetIt) {
  for (const double gap_m : {2e-3, 2.004e-3, 2.008e-3}) {
    EXPECT_NEAR(first_contact_s(0.7e-3, gap_m), first_contact_s(0.7e-3 / 8.0, gap_m), 1e-6) << gap_m;
  }
}

// Kiwis that are held and dropped, so that contacts come and go at other times in each.
TEST(HeldForces, GiveTheSameBitsAloneAndInCompany) {
  std::vector<Scenario> scenarios;
  for (int i = 0; i < 20; ++i) {
    Scenario scenario = kiwi_grip(0.00833);
    scenario.simulation.time_step_s = 1e-3;
    scenario.simulation.duration_s = 1.0;
    scenario.cell.lift_height_m = 0.03;
    scenario.strategy.grip_ramp_s = 0.05;
    scenario.strategy.settle_s = 0.05;
    scenario.strategy.approach_speed_m_s = 0.05 + 0.05 * (i % 4);
    scenario.strategy.grip_force_N = 0.3 + 0.2 * (i / 4);
    scenarios.push_back(scenario);
  }
  const std::vector<ScenarioResult> together = run_side_by_side(scenarios);
  const auto model = build(scenarios.front());
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, scenarios.size() - 1}) {
    expect_same_bits(simulate(model, scenarios[i], nullptr), together[i], "kiwi " + std::to_string(i));
  }
  EXPECT_NE(together.front().outcome, together.back().outcome);
}

}  // namespace
}  // namespace unbruised
