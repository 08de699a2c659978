// Scenarios that take steps of several lengths: moved from lane to lane they go on as if nothing had happened, and
// what they show is what the shortest step shows.

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include "benchmarks/cube512_scene.hpp"
#include "core/lanes/lane.hpp"
#include "core/simulation/parked_scenario.hpp"
#include "core/simulation/step_levels.hpp"
#include "tests/core/frame/held_scenes.hpp"
#include "tests/core/frame/rolling_scenes.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A box that yields where the pads press.
Scenario yielding_box() {
  Scenario scenario = small_box();
  lattice_of(scenario).yield_stress_Pa = 600.0;
  lattice_of(scenario).tangent_modulus_Pa = 4e4;
  return scenario;
}

Scenario soft_pads() {
  Scenario scenario = small_box();
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad.kind = PadKind::lattice;
  jaw.pad.cell_size_m = 0.005;
  jaw.pad_thickness_m = 0.01;
  jaw.pad_modulus_Pa = 2e5;
  jaw.pad_poisson_ratio = 0.45;
  jaw.pad_relaxation_time_s = 1e-3;
  return scenario;
}

Scenario creeping_box() {
  Scenario scenario = yielding_box();
  lattice_of(scenario).prony_modulus = {0.2, 0.3};
  lattice_of(scenario).prony_time_s = {0.05, 1.0};
  return scenario;
}

Scenario measured_by_wrist() {
  Scenario scenario = small_box();
  scenario.sensor.at = SensorMount::wrist;
  scenario.sensor.mass_kg = 0.3;
  scenario.sensor.position_m = {0.0, 0.0, 0.05};
  return scenario;
}

Scenario locked() {
  Scenario scenario = small_box();
  jaw_of(scenario).hold = HoldMode::position;
  jaw_of(scenario).lock_stiffness_N_m = 1e4;
  return scenario;
}

Scenario shaped() {
  Scenario scenario = small_box();
  jaw_of(scenario).pad.shape = PadShape::cylinder;
  jaw_of(scenario).pad.radius_m = 0.03;
  return scenario;
}

Scenario falling_box() {
  Scenario scenario = turned_box({0.02, 0.03, 0.02}, {0.3, 0.2, 0.0});
  scenario.simulation.duration_s = 0.3;
  return scenario;
}

Scenario network() {
  Scenario scenario = oscillator(0.1, 1e3, 1e-3, 300);
  network_of(scenario).particle[1].initial_velocity_m_s = {0.1, 0.0, 0.0};
  network_of(scenario).spring[0].yield_force_N = 0.2;
  return scenario;
}

/// One scenario of the same factor key that is somewhere else when it meets the other.
Scenario neighbour_of(Scenario scenario) {
  scenario.strategy.grip_force_N *= 1.5;
  return scenario;
}

ScenarioResult run_in_one_lane(const std::shared_ptr<const Model>& model, const Scenario& scenario,
                               Trace* trace = nullptr) {
  LaneSimulation lanes(model);
  lanes.load(0, scenario);
  lanes.record(0, trace);
  while (lanes.busy(0)) lanes.step();
  return lanes.finished().front().result;
}

/// Two simulations in turns, another lane each time, beside neighbours that come and go.
ScenarioResult run_from_lane_to_lane(const std::shared_ptr<const Model>& model, const Scenario& scenario,
                                     Trace* trace) {
  LaneSimulation here(model), there(model);
  std::array<LaneSimulation*, 2> both = {&here, &there};
  for (LaneSimulation* lanes : both) lanes->load(2, neighbour_of(scenario));
  for (int step = 0; step < 40; ++step) there.step();
  int lane = 0;
  here.load(lane, scenario);
  here.record(lane, trace);
  for (int step = 1;; ++step) {
    LaneSimulation& lanes = *both.front();
    lanes.step();
    if (!lanes.busy(lane)) break;
    if (step % 3 != 0) continue;
    const std::unique_ptr<ParkedScenario> parked = lanes.take(lane);
    EXPECT_FALSE(lanes.busy(lane));
    lane = (lane + 5) % kLanes;
    if (lane == 2) lane = 3;
    std::swap(both[0], both[1]);
    both.front()->put(lane, *parked);
    if (!both.front()->busy(2)) both.front()->load(2, neighbour_of(scenario));
  }
  for (const auto& finished : both.front()->finished()) {
    if (finished.lane == lane) return finished.result;
  }
  ADD_FAILURE() << "no result";
  return {};
}

void expect_same_trace(const Trace& a, const Trace& b, const char* where) {
  EXPECT_EQ(a.time_s, b.time_s) << where;
  ASSERT_EQ(a.signals.size(), b.signals.size()) << where;
  for (std::size_t i = 0; i < a.signals.size(); ++i) {
    const std::vector<double>&x = a.signals[i].values, &y = b.signals[i].values;
    EXPECT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end(), same_bits))
        << where << ": " << a.signals[i].name;
  }
  ASSERT_EQ(a.events.size(), b.events.size()) << where;
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    EXPECT_EQ(a.events[i].time_s, b.events[i].time_s) << where;
    EXPECT_EQ(a.events[i].kind, b.events[i].kind) << where;
  }
}

TEST(LaneMoves, ChangeNoBit) {
  const std::vector<std::pair<const char*, std::function<Scenario()>>> scenes = {
      {"yielding box", yielding_box},
      {"slipping box", slipping_box},
      {"box that creeps and yields", creeping_box},
      {"pads that are bodies", soft_pads},
      {"wrist sensor", measured_by_wrist},
      {"locked fingers", locked},
      {"shaped pads", shaped},
      {"falling box", falling_box},
      {"tilted block",
       [] {
         return tilted_block({0.3, 0.0, 0.0}, 2.0, 1e-3);
       }},
      {"network that yields", network}};
  for (const auto& [name, scene] : scenes) {
    const Scenario scenario = scene();
    const auto model = build(scenario);
    ASSERT_NE(model, nullptr) << name;
    Trace trace, moved;
    const ScenarioResult alone = run_in_one_lane(model, scenario, &trace);
    EXPECT_GT(alone.metrics[Metric::step_count], 100.0) << name;
    expect_same_bits(run_from_lane_to_lane(model, scenario, &moved), alone, name);
    expect_same_trace(moved, trace, name);
  }
}

TEST(StepLevels, OffIsTheShortestStepThroughout) {
  const Scenario scenario = yielding_box();  // small_box asks for it
  const auto model = build(scenario);
  expect_same_bits(simulate(model, scenario, nullptr), run_in_one_lane(model, scenario), "off");
}

/// Boxes that differ in force and speed, so that they want other steps at other times.
std::vector<Scenario> many_boxes() {
  std::vector<Scenario> scenarios;
  for (int i = 0; i < level_place_count(); ++i) {
    Scenario scenario = yielding_box();
    scenario.simulation.time_step_s = 5e-4;
    scenario.simulation.levels = LevelUse::automatic;
    scenario.strategy.grip_force_N = 0.25 + 0.02 * (i % 8);
    scenario.strategy.approach_speed_m_s = 0.02 + 0.01 * (i / 8);
    scenarios.push_back(scenario);
  }
  return scenarios;
}

TEST(StepLevels, GiveTheSameBitsAloneAndInCompany) {
  const std::vector<Scenario> scenarios = many_boxes();
  const std::vector<ScenarioResult> together = run_side_by_side(scenarios);
  const auto model = build(scenarios.front());
  for (const std::size_t i : {std::size_t{0}, std::size_t{13}, scenarios.size() - 1}) {
    expect_same_bits(simulate(model, scenarios[i], nullptr), together[i], "box " + std::to_string(i));
  }
}

/// Two threads take steps until all are done. @return how many batches stepped in a call, on average
double run_on_two_threads(LevelSimulation& simulation, std::vector<ScenarioResult>& results) {
  std::mutex mutex;
  const LevelSimulation::TwoThreads threads = {
      .both =
          [](const std::function<void()>& first, const std::function<void()>& second) {
            const std::jthread other(first);
            second();
          },
      .alone =
          [&mutex](const std::function<void()>& act) {
            const std::lock_guard lock(mutex);
            act();
          }};
  double calls = 0.0, batches = 0.0;
  for (std::size_t left = results.size(); left > 0; left -= simulation.finished().size()) {
    simulation.step(threads);
    calls += 1.0;
    batches += simulation.stepped_batches();
    for (const auto& finished : simulation.finished()) {
      results[static_cast<std::size_t>(finished.place)] = finished.result;
    }
  }
  return batches / calls;
}

TEST(StepLevels, GiveTheSameBitsWhereTwoBatchesStepAtOnce) {
  const std::vector<Scenario> scenarios = many_boxes();
  const auto model = build(scenarios.front());
  // Too few to fill a batch, and more than all batches have lanes for.
  for (const std::size_t apart : {std::size_t{5}, std::size_t{1}}) {
    LevelSimulation simulation(model);
    const std::size_t count = scenarios.size() / apart;
    for (std::size_t i = 0; i < count; ++i) simulation.load(static_cast<int>(i), scenarios[apart * i]);
    std::vector<ScenarioResult> results(count);
    EXPECT_GT(run_on_two_threads(simulation, results), 1.25) << count;
    for (std::size_t i = 0; i < count; i += count / 12) {
      expect_same_bits(simulate(model, scenarios[apart * i], nullptr), results[i],
                       "box " + std::to_string(apart * i));
    }
  }
}

/// What became of scenarios that were loaded wherever there was a place.
struct Filling {
  double busy = 0.0;     ///< share of the lanes that stepped
  double at_once = 0.0;  ///< how many ended in a call in which some did
};

Filling run_refilled(const std::vector<Scenario>& scenarios) {
  LevelSimulation simulation(build(scenarios.front()));
  std::size_t next = 0, finished = 0;
  double busy = 0.0, lanes = 0.0, calls_with_ends = 0.0;
  while (finished < scenarios.size()) {
    for (int place = 0; place < level_place_count() && next < scenarios.size(); ++place) {
      if (!simulation.busy(place)) simulation.load(place, scenarios[next++]);
    }
    simulation.step();
    finished += simulation.finished().size();
    busy += simulation.stepped();
    lanes += kLanes;
    if (!simulation.finished().empty()) ++calls_with_ends;
  }
  const Filling filling{busy / lanes, static_cast<double>(finished) / calls_with_ends};
  std::cout << "[ measured ] " << filling.at_once << " end at once, lanes " << 100.0 * filling.busy << " % busy\n";
  return filling;
}

// A batch costs nearly the same however few of its lanes are busy.
TEST(StepLevels, AlikeScenariosTakeTheirLongStepsTogether) {
  std::vector<Scenario> scenarios = many_boxes();
  for (Scenario& scenario : scenarios) scenario.strategy.approach_speed_m_s = 0.05;
  EXPECT_GT(run_refilled(scenarios).busy, 0.8);
}

// A batch sweeps its contacts as long as the slowest of its lanes: those that begin together should end together,
// however many came before (1.4 at once where each begins as soon as there is a place, 3.2 together).
TEST(StepLevels, AlikeScenariosStayInLikePhases) {
  std::vector<Scenario> scenarios(320, many_boxes().back());
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    scenarios[i].strategy.grip_force_N += 1e-3 * static_cast<double>(i % 10);
  }
  const Filling filling = run_refilled(scenarios);
  EXPECT_GT(filling.at_once, 2.5);
  EXPECT_GT(filling.busy, 0.9);
}

TEST(StepLevels, AreAsLongAsTheirPhasesAllow) {
  struct Row {
    double step_s;
    int medium, longest;
  };
  // At most 1.5 ms while the product is pressed, 6 ms while it is carried.
  for (const auto& [step_s, medium, longest] :
       {Row{5e-4, 2, 8}, Row{7e-4, 2, 8}, Row{1e-3, 1, 6}, Row{2e-3, 1, 3}, Row{7e-3, 1, 1}}) {
    Scenario scenario = small_box();
    scenario.simulation.levels = LevelUse::automatic;
    scenario.simulation.time_step_s = step_s;
    const StepLevels levels = step_levels(scenario);
    EXPECT_EQ(levels.medium, medium) << step_s;
    EXPECT_EQ(levels.longest, longest) << step_s;
    EXPECT_EQ(levels.any(), longest > 1) << step_s;
  }
}

// Its contacts would be too hard for sweeps at 6 ms: what sticks is found at once, in the first long step
// too. Its fingers go as fast as the force of their drives makes them.
TEST(StepLevels, ShowWhatTheShortestStepShowsOfAFlatProductToo) {
  Scenario scenario = benchmarks::cube512_scene(1e-3);
  scenario.simulation.levels = LevelUse::automatic;
  const ScenarioResult levels = run_side_by_side({scenario}).front();
  scenario.simulation.levels = LevelUse::off;
  const ScenarioResult uniform = run_side_by_side({scenario}).front();
  const Metrics &a = levels.metrics, &b = uniform.metrics;
  EXPECT_EQ(levels.outcome, uniform.outcome);
  const auto near = [&](Metric metric, double share, double absolute = 0.0) {
    EXPECT_NEAR(a[metric], b[metric], share * std::abs(b[metric]) + absolute) << static_cast<int>(metric);
  };
  near(Metric::peak_finger_force_N, 0.005);
  near(Metric::compression_max_m, 0.005);
  near(Metric::slip_max_m, 0.01, 1e-6);
  EXPECT_LT(std::abs(a[Metric::energy_balance_error]), 2.0 * std::abs(b[Metric::energy_balance_error]));
  near(Metric::first_contact_time_s, 0.0, 1e-4);
  EXPECT_LT(a[Metric::step_count], 0.35 * b[Metric::step_count]);
  EXPECT_LT(a[Metric::contact_iterations], 0.5 * b[Metric::contact_iterations]);
  std::cout << "[ measured ] steps " << a[Metric::step_count] / b[Metric::step_count] << ", sweeps "
            << a[Metric::contact_iterations] / b[Metric::contact_iterations] << " of the uniform ones\n";
}

// It swings for good, at 80 Hz: forces at their peaks are not those of short steps, but it is held as well.
TEST(StepLevels, HoldABlockThatNothingDamps) {
  Scenario scenario = small_box();
  LatticeParameters& block = lattice_of(scenario);
  block.size_m = {0.04, 0.04, 0.04};
  block.cell_size_m = 0.02;
  block.youngs_modulus_Pa = 1e6;
  block.density_kg_m3 = 1562.5;
  block.relaxation_time_s = 0.0;
  block.friction = 0.6;
  scenario.strategy.grip_force_N = 3.0;
  const ScenarioResult uniform = run_side_by_side({scenario}).front();
  scenario.simulation.levels = LevelUse::automatic;
  const ScenarioResult levels = run_side_by_side({scenario}).front();
  EXPECT_EQ(uniform.outcome, Outcome::held);
  EXPECT_EQ(levels.outcome, Outcome::held);
  EXPECT_NEAR(levels.metrics[Metric::slip_max_m], uniform.metrics[Metric::slip_max_m], 1e-6);
  EXPECT_NEAR(levels.metrics[Metric::peak_finger_force_N], uniform.metrics[Metric::peak_finger_force_N],
              0.05 * uniform.metrics[Metric::peak_finger_force_N]);
}

// The margins of the issue that asked for levels: force 0.5 %, slip 1 um + 1 %, yield ratio 0.5 %, set 1 %, times
// 0.1 ms.
TEST(StepLevels, ShowWhatTheShortestStepShows) {
  std::vector<Scenario> scenarios = many_boxes();
  const std::vector<ScenarioResult> levels = run_side_by_side(scenarios);
  for (Scenario& scenario : scenarios) scenario.simulation.levels = LevelUse::off;
  const std::vector<ScenarioResult> uniform = run_side_by_side(scenarios);
  double steps = 0.0, uniform_steps = 0.0;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const Metrics &a = levels[i].metrics, &b = uniform[i].metrics;
    EXPECT_EQ(levels[i].outcome, uniform[i].outcome) << i;
    const auto near = [&](Metric metric, double share, double absolute = 0.0) {
      EXPECT_NEAR(a[metric], b[metric], share * std::abs(b[metric]) + absolute) << i;
    };
    near(Metric::peak_finger_force_N, 0.005);
    near(Metric::slip_max_m, 0.01, 1e-6);
    near(Metric::contact_yield_ratio_max, 0.005);
    near(Metric::permanent_set_max_m, 0.01);
    near(Metric::cycle_time_s, 0.0, 1e-4);
    EXPECT_LT(std::abs(a[Metric::energy_balance_error]), 0.01) << i;
    EXPECT_LT(a[Metric::impulse_balance_error], 1e-9) << i;
    steps += a[Metric::step_count];
    uniform_steps += b[Metric::step_count];
  }
  EXPECT_LT(steps, 0.5 * uniform_steps);
  std::cout << "[ measured ] steps " << steps / uniform_steps << " of the uniform ones\n";
}

}  // namespace
}  // namespace unbruised
