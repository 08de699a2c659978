// Handlings of one product one after another: what it keeps, and what is counted over them.

#include <gtest/gtest.h>

#include "core/outcome/handlings.hpp"
#include "core/scenario/body_modes.hpp"
#include "tests/core/material/pressed_bar.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario repeated(Scenario scenario, int count) {
  scenario.strategy.repeat = count;
  return scenario;
}

/// A box that yields where it is gripped hard.
Scenario yielding_box() {
  Scenario scenario = small_box();
  lattice_of(scenario).yield_stress_Pa = 500.0;
  lattice_of(scenario).tangent_modulus_Pa = 2e4;
  scenario.cell.transfer_m = {0.0, 0.0};
  return scenario;
}

TEST(Repeat, AnElasticProductGoesThroughTheSameEachTime) {
  const ScenarioResult once = run(small_box()), thrice = run(repeated(small_box(), 3));
  ASSERT_EQ(once.outcome, Outcome::held);
  EXPECT_EQ(thrice.outcome, Outcome::held) << thrice.cause;
  for (const MetricInfo& info : kMetricTable) {
    const double one = once.metrics[info.metric], three = thrice.metrics[info.metric];
    const bool is_sum = over_handlings(info.metric) == OverHandlings::sum;
    EXPECT_TRUE(same_bits(three, is_sum ? one + one + one : one)) << info.name << " " << one << " and " << three;
  }
}

// A bar that hardens bears what it was pressed with: the second press finds it elastic. It shakes down.
TEST(Repeat, AHardeningBarShakesDownInTheFirstHandling) {
  constexpr double kMost_Pa = 1.8 * kYield_Pa;
  Scenario scenario = yielding_bar(kMost_Pa);
  scenario.strategy.grip_ramp_s = 1.0;
  const double strain = (kMost_Pa - kYield_Pa) * (1.0 / kTangent_Pa - 1.0 / kE_Pa);
  const double work_J = 0.5 * (kYield_Pa + kMost_Pa) * strain * kWidth_m * kWidth_m * kLength_m;
  ScenarioResult first;
  for (const int count : {1, 2, 5}) {
    const ScenarioResult result = run(repeated(scenario, count));
    ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
    // As plasticity_test has them of one press.
    EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], strain, 0.02 * strain) << count;
    EXPECT_NEAR(result.metrics[Metric::absorbed_energy_J], work_J, 0.02 * work_J) << count;
    if (count == 1) first = result;
    // What the step's overshoot in force adds in later presses.
    for (const Metric metric :
         {Metric::plastic_strain_max, Metric::permanent_set_max_m, Metric::absorbed_energy_J}) {
      EXPECT_NEAR(result.metrics[metric], first.metrics[metric], 2e-3 * first.metrics[metric]) << count;
      EXPECT_GE(result.metrics[metric], first.metrics[metric] * (1.0 - 1e-9)) << count;
    }
    EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 0.02) << count;
  }
}

// The shape that it comes back with is one in equilibrium: nothing of it swings.
TEST(Repeat, ADeformedProductBeginsAtRest) {
  Trace trace;
  trace.keeps_motion = true;
  Scenario scenario = repeated(yielding_box(), 2);
  const ScenarioResult result = run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  ASSERT_GT(result.metrics[Metric::permanent_set_max_m], 1e-5);
  const ScenarioResult once = run(repeated(scenario, 1));
  const double contact_s = once.metrics[Metric::first_contact_time_s];
  const auto first =
      std::ranges::find_if(trace.time_s, [&](double t) { return t > once.metrics[Metric::cycle_time_s]; });
  const std::vector<double> phase = column(trace, "phase");
  std::size_t begin = static_cast<std::size_t>(first - trace.time_s.begin());
  while (phase[begin] != 0.0) ++begin;  // approach
  double fastest_m_s = 0.0;
  const std::size_t row = 3 * static_cast<std::size_t>(trace.particle_count);
  for (std::size_t k = begin; trace.time_s[k] < trace.time_s[begin] + 0.5 * contact_s; ++k) {
    for (std::size_t i = 0; i < row; ++i) {
      fastest_m_s = std::max(fastest_m_s, std::abs(trace.velocity_m_s[k * row + i]));
    }
  }
  // A set of 10 um that was let go of would swing with some millimetres per second.
  EXPECT_LT(fastest_m_s, 1e-7);
}

TEST(Repeat, TheTraceGoesOn) {
  Trace once, twice;
  run(small_box(), &once);
  run(repeated(small_box(), 2), &twice);
  ASSERT_EQ(twice.time_s.size(), 2 * once.time_s.size() - 1);
  for (std::size_t k = 1; k < twice.time_s.size(); ++k) ASSERT_GT(twice.time_s[k], twice.time_s[k - 1]);
  const std::vector<double> phase = column(twice, "phase"), of_one = column(once, "phase");
  for (std::size_t k = 1; k < of_one.size(); ++k) EXPECT_EQ(phase[of_one.size() - 1 + k], of_one[k]);
}

TEST(Repeat, TheFirstThatGoesWrongIsTheLast) {
  Scenario scenario = repeated(yielding_box(), 4);
  const double strain = run(repeated(scenario, 1)).metrics[Metric::plastic_strain_max];
  scenario.limits.plastic_strain = strain * 0.5;
  const ScenarioResult first = run(scenario);
  EXPECT_EQ(first.outcome, Outcome::damaged);
  EXPECT_EQ(first.cause, "handling 1 of 4: plastic_strain_max > limits.plastic_strain");
  EXPECT_EQ(first.metrics[Metric::step_count], run(repeated(scenario, 1)).metrics[Metric::step_count]);
}

// Alone, beside others, with levels of steps and without: the same bits.
TEST(Repeat, ALaneKeepsItsBits) {
  for (const LevelUse levels : {LevelUse::off, LevelUse::automatic}) {
    std::vector<Scenario> scenarios;
    for (const int count : {1, 3, 2, 4}) {
      Scenario scenario = repeated(yielding_box(), count);
      scenario.simulation.levels = levels;
      scenario.simulation.time_step_s = 2e-4;
      scenario.strategy.grip_force_N = 0.3 + 0.01 * count;
      scenarios.push_back(scenario);
    }
    const std::vector<ScenarioResult> together = run_side_by_side(scenarios);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
      EXPECT_EQ(together[i].outcome, Outcome::held) << together[i].cause;
      expect_same_bits(together[i], run_side_by_side({scenarios[i]}).front(), std::to_string(i));
    }
  }
}

// A spring that yields at 1 N beside one that never does, pulled by 3 N again and again: it yields once, and then
// the two share the load elastically for good (Melan).
TEST(Repeat, ANetworkKeepsItsPlasticElongation) {
  NetworkParameters network;
  NetworkParticle wall, mass;
  wall.fixed = {true, true, true};
  mass.position_m = {0.1, 0.0, 0.0};
  mass.mass_kg = 0.01;
  mass.fixed = {false, true, true};
  network.particle = {wall, mass};
  NetworkSpring yields, holds;
  for (NetworkSpring* spring : {&yields, &holds}) {
    spring->between = {0, 1};
    spring->stiffness_N_m = 1000.0;
    spring->damping_N_s_m = 5.0;
  }
  yields.yield_force_N = 1.0;
  network.spring = {yields, holds};
  NetworkLoad load;
  load.particle = 1;
  load.time_s = {0.0, 0.2, 0.3, 0.5};
  load.force_N = {{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  network.load = {load};
  Scenario scenario;
  scenario.product = network;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  scenario.simulation.duration_s = 0.6;
  scenario.simulation.time_step_s = 1e-3;
  // u = (3 N - 1 N) / k at the peak, of which 1 N / k is elastic in the one that yields: 1 mm stays in it, and
  // half a millimetre between the two.
  for (const int count : {1, 2, 6}) {
    const ScenarioResult result = run(repeated(scenario, count));
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], 0.01, 1e-4) << count;
    EXPECT_NEAR(result.metrics[Metric::permanent_set_max_m], 5e-4, 5e-6) << count;
  }
}

TEST(Repeat, OfAProductByModesEveryParticleMoves) {
  Scenario scenario = small_box();
  scenario.simulation.body = ProductBody::modes;
  EXPECT_GT(mode_count(scenario), 0);
  EXPECT_EQ(mode_count(repeated(scenario, 2)), 0);
}

TEST(Repeat, IsRefusedWhereNothingSaysWhatHappensBetween) {
  Scenario relaxing = repeated(small_box(), 2);
  lattice_of(relaxing).prony_modulus = {0.3};
  lattice_of(relaxing).prony_time_s = {1.0};
  Scenario stopped = repeated(small_box(), 2);
  stopped.strategy.stop_time_s = 0.5;
  for (const Scenario& scenario : {relaxing, stopped}) {
    const Violations broken = validate(scenario);
    ASSERT_EQ(broken.size(), 1U);
    EXPECT_EQ(broken.front().field, "strategy.repeat");
  }
}

TEST(Handlings, AreCountedAsTheirMetricsSay) {
  Handlings handlings(3);
  ScenarioResult each;
  each.outcome = Outcome::held;
  for (const double value : {2.0, -3.0, 1.0}) {
    for (double& metric : each.metrics.values()) metric = value;
    handlings.add(each, 5.0);
    EXPECT_EQ(handlings.go_on(), value != 1.0);
  }
  const Metrics& together = handlings.together().metrics;
  EXPECT_EQ(together[Metric::permanent_set_max_m], 1.0);
  EXPECT_EQ(together[Metric::peak_finger_force_N], 2.0);
  EXPECT_EQ(together[Metric::friction_margin_min], -3.0);
  EXPECT_EQ(together[Metric::step_count], 0.0);
  EXPECT_EQ(together[Metric::energy_balance_error], -3.0);
}

TEST(Handlings, TimesOfOutcomesCountFromTheFirst) {
  Handlings handlings(3);
  ScenarioResult each;
  each.outcome = Outcome::held;
  handlings.add(each, 5.0);
  each.outcome = Outcome::slipped;
  each.cause = "slip";
  each.outcome_time_s = 1.0;
  handlings.add(each, 2.0);
  EXPECT_FALSE(handlings.go_on());
  EXPECT_EQ(handlings.together().outcome_time_s, 6.0);
  EXPECT_EQ(handlings.together().cause, "handling 2 of 3: slip");
}

}  // namespace
}  // namespace unbruised
