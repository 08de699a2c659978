// Steps so long that Gauss-Seidel takes hundreds of sweeps: patches of contacts answer as wholes there.

#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "benchmarks/cube512_scene.hpp"
#include "core/contact/contact_effort.hpp"
#include "core/simulation/lane_observer.hpp"
#include "core/simulation/simulation.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(LongSteps, FindTheForcesOfACubeThatLeavesItsSupport) {
  // Before, sweeps from the fortieth on followed the steepest slope that a layer might have, which throws a
  // contact that is about to open to a part of its force: they went round in circles, and the run ended at 0.22 s.
  const ScenarioResult ten_ms = run(benchmarks::cube512_scene(10e-3));
  ASSERT_EQ(ten_ms.outcome, Outcome::held) << ten_ms.cause;
  const ScenarioResult two_ms = run(benchmarks::cube512_scene(2e-3));
  ASSERT_EQ(two_ms.outcome, Outcome::held) << two_ms.cause;
  // The step's own error: 0.24 % of the compression and 1.9 % of the first peak were seen.
  const auto expect_near = [&](Metric metric, double relative) {
    EXPECT_NEAR(ten_ms.metrics[metric], two_ms.metrics[metric], relative * two_ms.metrics[metric]);
  };
  expect_near(Metric::compression_max_m, 0.005);
  expect_near(Metric::peak_finger_force_N, 0.03);
  EXPECT_EQ(ten_ms.metrics[Metric::slip_max_m], 0.0);
  // Momentum balances whatever the forces are; energy only with those that the layers answer with: -5.2e-3 seen.
  EXPECT_LT(std::abs(ten_ms.metrics[Metric::energy_balance_error]), 0.01);
}

TEST(LongSteps, FindTheForcesOfViscousLayersToo) {
  // A layer that relaxes has kinks where its viscous part meets the elastic one.
  Scenario scene = benchmarks::cube512_scene(10e-3);
  jaw_of(scene).pad_relaxation_time_s = 2e-3;
  scene.cell.support_relaxation_time_s = 2e-3;
  const ScenarioResult result = run(scene);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 0.02);
}

/// Sweeps of the steps in which the product is held.
class HeldSweeps : public LaneObserver {
 public:
  explicit HeldSweeps(std::vector<double>& sweeps) : sweeps_(sweeps) {}
  void start(const LaneStep& /*loaded*/) override {}
  bool observe(const LaneStep& step) override {
    if (step.cycle.phase(step.time_s) == CyclePhase::hold) sweeps_.push_back(step.contact_sweeps);
    return true;
  }
  void end(const LaneStep& /*last*/) override {}

 private:
  std::vector<double>& sweeps_;
};

/// Of an average one.
double held_sweeps(const Scenario& scene) {
  std::string error;
  LaneSimulation simulation(Model::build(scene, error));
  std::vector<double> sweeps;
  simulation.load(0, scene);
  simulation.watch(0, std::make_unique<HeldSweeps>(sweeps));
  while (simulation.busy_count() > 0) simulation.step();
  EXPECT_GT(sweeps.size(), 30U);
  return std::accumulate(sweeps.begin(), sweeps.end(), 0.0) / static_cast<double>(sweeps.size());
}

TEST(LongSteps, FindTheForcesOfWhatSticksAtOnce) {
  // 61.6 sweeps by themselves, 10.6 with patches that answer as wholes, 4.5 seen.
  EXPECT_LT(held_sweeps(benchmarks::cube512_scene(10e-3)), 6.0);
}

TEST(LongSteps, HaveTheSameBitsAloneAndInCompany) {
  // Lanes that are hard at different times: some let their patches answer as wholes while others do not.
  std::vector<Scenario> scenes;
  for (const double force_N : {2.5, 5.0, 8.0}) {
    for (const double step_speed : {0.02, 0.1}) {
      scenes.push_back(benchmarks::cube512_scene(10e-3, force_N));
      scenes.back().strategy.approach_speed_m_s = step_speed;
      scenes.back().simulation.duration_s = 0.4;
      // The law of a viscous layer has kinks: what was noted of it, and when, makes a difference. On elastic ones
      // forces of what sticks are found at once.
      if (force_N == 5.0) continue;
      jaw_of(scenes.back()).pad_relaxation_time_s = scenes.back().cell.support_relaxation_time_s = 2e-3;
    }
  }
  // Beside one whose support gives way on a force sensor.
  auto& sensor = scenes.emplace_back(scenes.front()).sensor;
  sensor.at = SensorMount::support;
  sensor.mass_kg = 1.0;
  sensor.element_stiffness_N_m = 1e5;
  sensor.inertia_kg_m2 = {1e-4, 2e-4, 3e-4};
  std::string error;
  const auto model = Model::build(scenes.front(), error);
  // One after the other: while some lift, others still stand on the support.
  constexpr int kStepsApart = 7;
  LaneSimulation together(model);
  std::vector<ScenarioResult> results(scenes.size());
  std::size_t loaded = 0;
  for (int step = 0; loaded < scenes.size() || together.busy_count() > 0; ++step) {
    if (step % kStepsApart == 0 && loaded < scenes.size()) {
      together.load(static_cast<int>(loaded), scenes[loaded]);
      ++loaded;
    }
    together.step();
    for (const auto& finished : together.finished()) {
      results[static_cast<std::size_t>(finished.lane)] = finished.result;
    }
  }
  for (std::size_t lane = 0; lane < scenes.size(); ++lane) {
    LaneSimulation alone(model);
    alone.load(3, scenes[lane]);
    ScenarioResult result;
    while (alone.busy_count() > 0) {
      alone.step();
      for (const auto& finished : alone.finished()) result = finished.result;
    }
    EXPECT_EQ(result.outcome, results[lane].outcome);
    for (const Metric metric : {Metric::compression_max_m, Metric::peak_finger_force_N, Metric::slip_max_m,
                                Metric::contact_iterations, Metric::energy_balance_error}) {
      const double one = result.metrics[metric], among = results[lane].metrics[metric];
      EXPECT_TRUE(one == among || (std::isnan(one) && std::isnan(among))) << lane << ": " << one << " " << among;
    }
  }
}

TEST(LongSteps, HoldAPlateOfThreeGramsThatSweepsFoundNoForcesFor) {
  // A cracker of 40 x 40 x 6 mm and 100 MPa between viscous pads; 1,000 sweeps ended without forces.
  Scenario scene = small_box();
  make_product(scene, {0.006, 0.04, 0.04}, 0.003, 0.003, 1e8).friction = 0.6;
  jaw_of(scene).pad_relaxation_time_s = 2e-3;
  scene.strategy.grip_force_N = 0.5;
  scene.simulation.duration_s = 0.25;
  ASSERT_GT(contact_coupling(scene), kLargestCoupling);
  const ScenarioResult result = run(scene);
  EXPECT_NE(result.outcome, Outcome::diverged) << result.cause;
  EXPECT_LT(std::abs(result.metrics[Metric::impulse_balance_error]), 1e-4);
}

}  // namespace
}  // namespace unbruised
