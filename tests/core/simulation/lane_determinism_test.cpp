// A scenario's bits never depend on its lane, on its neighbours, or on when it was loaded.

#include <gtest/gtest.h>

#include "tests/core/frame/rolling_scenes.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A box that yields where the pads press, slips a little, and is set down again.
Scenario yielding_box() {
  Scenario scenario = small_box();
  lattice_of(scenario).yield_stress_Pa = 600.0;
  lattice_of(scenario).tangent_modulus_Pa = 4e4;
  return scenario;
}

Scenario with_force(Scenario scenario, double force_N) {
  scenario.strategy.grip_force_N = force_N;
  return scenario;
}

/// Neighbours that differ in everything a lane may differ in: stronger flow, no flow, slipping, nothing grasped,
/// no gripper and no weight at all, and numbers that stop being finite.
std::vector<Scenario> neighbours() {
  std::vector<Scenario> all;
  all.push_back(with_force(yielding_box(), 0.6));
  all.push_back(with_force(yielding_box(), 0.02));
  Scenario elastic = with_force(yielding_box(), 0.5);
  lattice_of(elastic).yield_stress_Pa.reset();
  lattice_of(elastic).tangent_modulus_Pa.reset();
  lattice_of(elastic).friction = 0.05;
  jaw_of(elastic).coupling = FingerCoupling::independent;
  jaw_of(elastic).pad_relaxation_time_s = 2e-3;
  all.push_back(elastic);
  Scenario diverging = yielding_box();
  lattice_of(diverging).initial_velocity_m_s = {0.0, 1e200, 1e200};
  diverging.simulation.max_rotation_rad = 1e300;
  diverging.simulation.max_strain = 1e300;
  all.push_back(diverging);
  Scenario infinite = yielding_box();
  infinite.cell.gravity_m_s2 = {0.0, 1e308, -1e308};
  infinite.simulation.max_rotation_rad = 1e300;
  infinite.simulation.max_strain = 1e300;
  all.push_back(infinite);
  Scenario missing = yielding_box();
  missing.cell.approach_gap_m = 0.03;
  missing.strategy.ramp_from_start = true;
  all.push_back(missing);
  Scenario free = yielding_box();
  free.gripper = NoGripper{};
  free.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  free.simulation.duration_s = 0.3;
  all.push_back(free);
  Scenario rough = with_force(yielding_box(), 0.9);
  rough.strategy.profile = ProfileKind::trapezoid;
  rough.strategy.lift_acceleration_m_s2 = 8.0;
  all.push_back(rough);
  return all;
}

class LaneDeterminism : public ::testing::Test {
 protected:
  void SetUp() override {
    scenario = yielding_box();
    model = build(scenario);
    ASSERT_NE(model, nullptr);
    alone = simulate(model, scenario, nullptr);
    // Worth testing: flow, several plastic rounds, contact sweeps, a whole cycle.
    ASSERT_EQ(alone.outcome, Outcome::held) << alone.cause;
    ASSERT_GT(alone.metrics[Metric::plastic_strain_max], 1e-3);
    ASSERT_GT(alone.metrics[Metric::plasticity_iterations], 10.0);
  }

  /// Runs until `lane` ends. @return its result
  static ScenarioResult run_until_done(LaneSimulation& simulation, int lane) {
    while (simulation.busy(lane)) {
      simulation.step();
      for (const auto& finished : simulation.finished()) {
        if (finished.lane == lane) return finished.result;
      }
    }
    ADD_FAILURE() << "lane " << lane << " never finished";
    return {};
  }

  Scenario scenario;
  std::shared_ptr<const Model> model;
  ScenarioResult alone;
};

TEST_F(LaneDeterminism, EveryLanePositionGivesTheSameBits) {
  LaneSimulation simulation(model);
  for (int lane = 0; lane < lane_count(); ++lane) simulation.load(lane, scenario);
  int seen = 0;
  while (simulation.busy_count() > 0) {
    simulation.step();
    for (const auto& finished : simulation.finished()) {
      expect_same_bits(finished.result, alone, "lane " + std::to_string(finished.lane));
      ++seen;
    }
  }
  EXPECT_EQ(seen, lane_count());
  for (int lane : {1, 7, lane_count() - 1}) {
    LaneSimulation single(model);
    single.load(lane, scenario);
    expect_same_bits(run_until_done(single, lane), alone, "alone in lane " + std::to_string(lane));
  }
}

TEST_F(LaneDeterminism, NoNeighbourChangesABit) {
  const std::vector<Scenario> others = neighbours();
  for (std::size_t k = 0; k < others.size(); ++k) {
    ASSERT_EQ(factor_key(others[k]), factor_key(scenario)) << k;
    LaneSimulation simulation(model);
    for (int lane = 0; lane < lane_count(); ++lane) simulation.load(lane, lane == 5 ? scenario : others[k]);
    expect_same_bits(run_until_done(simulation, 5), alone, "among neighbours of kind " + std::to_string(k));
  }
}

TEST_F(LaneDeterminism, EveryNeighbourAlsoRunsAsItDoesAlone) {
  const std::vector<Scenario> others = neighbours();
  std::vector<ScenarioResult> single;
  for (const Scenario& other : others) single.push_back(simulate(model, other, nullptr));
  LaneSimulation simulation(model);
  for (std::size_t k = 0; k < others.size(); ++k) simulation.load(static_cast<int>(2 * k), others[k]);
  while (simulation.busy_count() > 0) {
    simulation.step();
    for (const auto& finished : simulation.finished()) {
      const auto k = static_cast<std::size_t>(finished.lane) / 2;
      expect_same_bits(finished.result, single[k], "kind " + std::to_string(k) + " in the mix");
    }
  }
  EXPECT_EQ(single[3].outcome, Outcome::diverged) << single[3].cause;
  EXPECT_EQ(single[4].outcome, Outcome::diverged) << single[4].cause;
}

TEST_F(LaneDeterminism, BothHalvesOfALaneValueRoundAlike) {
  // A compiler that fuses a * b + c * d one way in the first register and the other way in the second fails here.
  const Scenario rough = neighbours().back();
  const ScenarioResult first = simulate(model, rough, nullptr);
  ASSERT_GT(first.metrics[Metric::slip_max_m], 0.0);
  for (int lane = 1; lane < lane_count(); ++lane) {
    LaneSimulation simulation(model);
    simulation.load(lane, rough);
    expect_same_bits(run_until_done(simulation, lane), first, "lane " + std::to_string(lane));
  }
}

TEST_F(LaneDeterminism, LoadingIntoARunningBatchGivesTheSameBits) {
  const std::vector<Scenario> others = neighbours();
  LaneSimulation simulation(model);
  for (int lane = 0; lane < lane_count(); ++lane) {
    simulation.load(lane, others[static_cast<std::size_t>(lane) % others.size()]);
  }
  // Every lane that becomes free takes the scenario, whatever ran in it before: also after one that diverged.
  std::vector<int> refilled(static_cast<std::size_t>(lane_count()), 0);
  int seen = 0;
  while (simulation.busy_count() > 0) {
    simulation.step();
    for (const auto& finished : std::vector<LaneSimulation::Finished>(simulation.finished())) {
      int& times = refilled[static_cast<std::size_t>(finished.lane)];
      if (times > 0) {
        expect_same_bits(finished.result, alone,
                         "refill " + std::to_string(times) + " of lane " + std::to_string(finished.lane));
        ++seen;
      }
      if (++times <= 2) simulation.load(finished.lane, scenario);
    }
  }
  EXPECT_EQ(seen, 2 * lane_count());
}

TEST_F(LaneDeterminism, RecordingATraceChangesNothing) {
  Trace trace;
  expect_same_bits(simulate(model, scenario, &trace), alone, "with a trace");
  EXPECT_EQ(trace.time_s.size(), static_cast<std::size_t>(alone.metrics[Metric::step_count]) + 1);
}

TEST_F(LaneDeterminism, TheSameModelBuiltTwiceGivesTheSameBits) {
  expect_same_bits(simulate(build(scenario), scenario, nullptr), alone, "second model");
}

/// Places of a whole surface sleep and wake as any lane asks for it.
TEST(LaneDeterminismOfPlaces, NoNeighbourChangesABitOfWhatTumbles) {
  Scenario scenario = thrown_box(1e-3, 0.3);
  lay_support(scenario.cell, 4e7, 0.6);  // foam that recovers more slowly than the box leaves it
  scenario.cell.support_relaxation_time_s = 5e-3;
  const auto model = build(scenario);
  const ScenarioResult alone = simulate(model, scenario, nullptr);
  ASSERT_GT(alone.metrics[Metric::contact_iterations], 10.0);
  for (const double height_m : {0.0098, 0.0102, 0.011, 0.03}) {
    Scenario other = scenario;
    lattice_of(other).initial_height_m = height_m;
    ASSERT_EQ(factor_key(other), factor_key(scenario));
    LaneSimulation simulation(model);
    for (int lane = 0; lane < lane_count(); ++lane) simulation.load(lane, lane == 5 ? scenario : other);
    bool done = false;
    while (!done) {
      simulation.step();
      for (const auto& finished : simulation.finished()) {
        if (finished.lane != 5) continue;
        expect_same_bits(finished.result, alone, "beside one from " + std::to_string(height_m));
        done = true;
      }
    }
  }
}

}  // namespace
}  // namespace unbruised
