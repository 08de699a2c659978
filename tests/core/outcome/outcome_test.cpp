// Every word of the closed list comes out of a small scenario, and the balances hold in all of them.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario yielding() {
  Scenario scenario = small_box();
  lattice_of(scenario).yield_stress_Pa = 600.0;
  lattice_of(scenario).tangent_modulus_Pa = 4e4;
  return scenario;
}

Scenario slipping() {
  Scenario scenario = small_box();
  scenario.strategy.profile = ProfileKind::trapezoid;
  scenario.strategy.lift_acceleration_m_s2 = 2.0;
  scenario.strategy.contact_force_N = 0.05;
  scenario.strategy.grip_force_N = 0.0925;  // m (g + a) / (2 mu) = 0.0945 N
  scenario.limits.slip_m = 1e-4;
  return scenario;
}

Scenario dropping() {
  Scenario scenario = small_box();
  scenario.strategy.contact_force_N = 0.03;
  scenario.strategy.grip_force_N = 0.04;        // less than m g / (2 mu) = 0.078 N
  scenario.strategy.approach_speed_m_s = 0.01;  // the fingers must not bounce off for long
  scenario.strategy.settle_s = 0.5;
  scenario.cell.lift_height_m = 0.1;
  return scenario;
}

Scenario damaging() {
  Scenario scenario = yielding();
  scenario.limits.permanent_set_m = 1e-6;
  return scenario;
}

Scenario missing() {
  Scenario scenario = small_box();
  scenario.cell.grip_height_m = 0.1;  // the pads close above the product
  return scenario;
}

Scenario straining() {
  Scenario scenario = small_box();
  lattice_of(scenario).youngs_modulus_Pa = 1e4;
  scenario.strategy.grip_force_N = 3.0;
  return scenario;
}

Scenario diverging() {
  Scenario scenario = small_box();
  scenario.cell.gravity_m_s2 = {1e308, 0.0, -1e308};
  return scenario;
}

struct Expected {
  const char* name;
  Scenario (*scenario)();
  Outcome outcome;
};

class Outcomes : public ::testing::TestWithParam<Expected> {};

TEST_P(Outcomes, WordComesOutWithItsCauseAndTime) {
  const Scenario scenario = GetParam().scenario();
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(outcome_word(result.outcome), outcome_word(GetParam().outcome)) << result.cause;
  EXPECT_EQ(result.cause.empty(), result.outcome == Outcome::held);
  EXPECT_EQ(std::isnan(result.outcome_time_s), result.outcome == Outcome::held);
  const bool aborted = result.outcome == Outcome::diverged || result.outcome == Outcome::out_of_range;
  if (aborted) return;
  const double impulse = result.metrics[Metric::impulse_balance_error];
  const double energy = result.metrics[Metric::energy_balance_error];
  EXPECT_LT(impulse, 0.005);
  EXPECT_LE(energy, 1e-3);
  // Numerical damping: a block of 8 g that drops strikes the support in some three steps.
  EXPECT_GE(energy, result.outcome == Outcome::dropped ? -0.03 : -0.01);
  std::cout << "[ measured ] " << GetParam().name << ": impulse " << impulse << ", energy " << energy << " of "
            << result.metrics[Metric::energy_input_J] << " J; " << result.cause << "\n";
}

INSTANTIATE_TEST_SUITE_P(All, Outcomes,
                         ::testing::Values(Expected{"held", small_box, Outcome::held},
                                           Expected{"held_yielding", yielding, Outcome::held},
                                           Expected{"slipped", slipping, Outcome::slipped},
                                           Expected{"dropped", dropping, Outcome::dropped},
                                           Expected{"damaged", damaging, Outcome::damaged},
                                           Expected{"not_grasped", missing, Outcome::not_grasped},
                                           Expected{"out_of_range", straining, Outcome::out_of_range},
                                           Expected{"diverged", diverging, Outcome::diverged}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Outcome, EveryLimitCanDecideDamage) {
  const ScenarioResult base = run(yielding());
  ASSERT_EQ(base.outcome, Outcome::held) << base.cause;
  using Limit = std::optional<double> LimitParameters::*;
  const std::vector<std::pair<Limit, Metric>> limits = {
      {&LimitParameters::permanent_set_m, Metric::permanent_set_max_m},
      {&LimitParameters::plastic_strain, Metric::plastic_strain_max},
      {&LimitParameters::peak_pressure_Pa, Metric::peak_pressure_Pa},
      {&LimitParameters::absorbed_energy_J, Metric::absorbed_energy_J},
      {&LimitParameters::finger_force_N, Metric::peak_finger_force_N},
      {&LimitParameters::contact_yield_ratio, Metric::contact_yield_ratio_max},
  };
  for (const auto& [limit, metric] : limits) {
    const MetricInfo& info = info_of(metric);
    const double value = base.metrics[metric];
    ASSERT_GT(value, 0.0) << info.name;
    Scenario below = yielding(), above = yielding();
    below.limits.*limit = 0.999 * value;
    above.limits.*limit = 1.001 * value;
    const ScenarioResult broken = run(below);
    EXPECT_EQ(broken.outcome, Outcome::damaged) << info.name;
    EXPECT_NE(broken.cause.find(info.name), std::string::npos) << broken.cause;
    EXPECT_EQ(run(above).outcome, Outcome::held) << info.name;
  }
  Scenario bruised = yielding();
  bruised.limits.bruised_volume_m3 = 1e-9;
  bruised.limits.plastic_strain = 1e6;
  EXPECT_EQ(run(bruised).outcome, Outcome::held);
}

TEST(Outcome, AGraspIsJudgedAtTheEndOfItsPhaseWhereverTheFirstContactFellIntoAStep) {
  // No lift, no rest: the release follows the grip phase at once, in the same step.
  for (double speed = 0.03; speed < 0.06; speed += 0.0017) {
    Scenario scenario = small_box();
    scenario.cell.lift_height_m = 0.0;
    scenario.cell.transfer_m = {0.0, 0.0};
    scenario.strategy.place_settle_s = 0.0;
    scenario.strategy.approach_speed_m_s = speed;
    const ScenarioResult result = run(scenario);
    EXPECT_EQ(result.outcome, Outcome::held) << speed << ": " << result.cause;
  }
}

TEST(Outcome, MetricsThatDoNotExistAreNaN) {
  Scenario free = small_box();
  free.gripper = NoGripper{};
  free.simulation.duration_s = 0.05;
  const ScenarioResult result = run(free);
  for (Metric metric : {Metric::cycle_time_s, Metric::lift_time_s, Metric::friction_margin_min,
                        Metric::hold_drift_m_s, Metric::peak_finger_force_N}) {
    EXPECT_TRUE(std::isnan(result.metrics[metric])) << info_of(metric).name;
  }
  EXPECT_EQ(result.metrics[Metric::step_count], 50.0);
}

}  // namespace
}  // namespace unbruised
