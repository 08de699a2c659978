/// @file
/// What step levels and modes are worth: scenarios of a study as shipped, each with steps of its own choice, by
/// every particle and by modes, against the shortest step throughout, by turns on one thread; and one scenario
/// alone, as a search that waits for its answer has it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "benchmarks/cube512_scene.hpp"
#include "benchmarks/part_times.hpp"
#include "benchmarks/stopwatch.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr int kTurns = 3;
/// Four times as many as are under way at once: phases of different scenarios may have spread by then.
constexpr std::size_t kCubes = 256;

struct Run {
  double processor_s = HUGE_VAL;  ///< least of all turns
  double steps = 0.0;             ///< of a scenario, on average
  double busy = 0.0;              ///< lanes of a step that had a scenario
  double simulated_s = 0.0;       ///< of a scenario, on average
  LaneSimulation::PartTimes part;
};

/// How scenarios are run.
struct Way {
  const char* name;
  LevelUse levels;
  ProductBody body;
};
constexpr Way kWays[] = {{"off", LevelUse::off, ProductBody::full},
                         {"auto", LevelUse::automatic, ProductBody::full},
                         {"modes", LevelUse::automatic, ProductBody::modes}};

Scenario in_this_way(Scenario scenario, const Way& way) {
  scenario.simulation.levels = way.levels;
  scenario.simulation.body = way.body;
  return scenario;
}

void run_once(const std::shared_ptr<const Model>& model, const std::vector<Scenario>& scenarios, const Way& way,
              Run& run) {
  const double start_s = benchmarks::processor_s();
  LevelSimulation simulation(model);
  simulation.enable_timing();
  std::size_t next = 0, left = scenarios.size();
  double steps = 0.0, calls = 0.0, simulated_s = 0.0;
  while (left > 0) {
    for (int place = 0; place < level_place_count() && next < scenarios.size(); ++place) {
      if (simulation.busy(place)) continue;
      simulation.load(place, in_this_way(scenarios[next++], way));
    }
    simulation.step();
    steps += simulation.stepped();
    calls += 1.0;
    left -= simulation.finished().size();
    for (const auto& finished : simulation.finished()) {
      simulated_s += finished.result.metrics[Metric::cycle_time_s];
    }
  }
  const double count = static_cast<double>(scenarios.size());
  run.processor_s = std::min(run.processor_s, (benchmarks::processor_s() - start_s) / count);
  run.steps = steps / count;
  run.busy = steps / (calls * lane_count());
  run.simulated_s = simulated_s / count;
  run.part = simulation.part_times();
}

/// @return false where a model cannot be built
bool compare(const char* name, const std::vector<Scenario>& scenarios) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const Way& way : kWays) {
    std::string error;
    models.push_back(Model::build(in_this_way(scenarios.front(), way), error));
    if (models.back()) continue;
    std::fprintf(stderr, "%s cannot be built: %s\n", name, error.c_str());
    return false;
  }
  std::vector<Run> runs(models.size());
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t i = 0; i < runs.size(); ++i) run_once(models[i], scenarios, kWays[i], runs[i]);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    const LaneSimulation::PartTimes& part = run.part;
    const double all_s = total_s(part);
    std::printf("%-18s %5zu %6s %7.0f %7.1f %14.1f %8.2f %9.2f %7.0f %7.0f %9.0f\n", name, scenarios.size(),
                kWays[i].name, run.steps, 100.0 * run.busy, 1e3 * run.processor_s,
                run.processor_s / runs.front().processor_s, run.processor_s / run.simulated_s,
                100.0 * part.solve_s / all_s, 100.0 * part.contact_s / all_s,
                100.0 * part.right_hand_side_s / all_s);
  }
  return true;
}

std::vector<Scenario> cubes(std::size_t count) {
  std::vector<Scenario> scenarios;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
    scenarios.push_back(cube512_scene(1e-3, (0.8 + 0.4 * part) * kCube512GripForce_N));
  }
  return scenarios;
}

/// The first `count` of equally spaced scenarios of a sweep.
std::vector<Scenario> of_sweep(const studies::Study& study, std::size_t count) {
  std::vector<Scenario> scenarios;
  const std::size_t all = study.scenario_count();
  for (std::size_t i = 0; i < count; ++i) scenarios.push_back(study.scenario(i * all / count));
  return scenarios;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main(int argc, char** argv) {
  using namespace unbruised::benchmarks;
  const std::string root = argc > 1 ? argv[1] : "configs";
  const unbruised::studies::StudyOrError study =
      unbruised::studies::read_study(root + "/kiwi_sweep.toml", {}, root);
  if (!study) return 1;
  std::printf("Step levels and modes, one thread, least of %d turns (processor time)\n", kTurns);
  std::printf("%-18s %5s %6s %7s %7s %14s %8s %9s %7s %7s %9s\n", "scene", "count", "levels", "steps", "busy %",
              "ms a scenario", "ratio", "s per s", "solve %", "touch %", "rhs %");
  bool sound = compare("cube512", cubes(kCubes)) && compare("cube512 alone", cubes(1));
  sound = sound && compare("kiwi_sweep", of_sweep(*study, 96)) && compare("kiwi_sweep alone", of_sweep(*study, 1));
  return sound ? 0 : 1;
}
