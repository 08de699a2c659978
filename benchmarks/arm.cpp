/// @file
/// What an arm adds to a scenario: the kiwi of `kiwi_first` gripped, lifted, carried and put down on coarser and
/// finer cells, by an arm that is asked whether it can follow and by one that slows the path down, each against
/// the same path without an arm: what a lane and step cost, and what is asked of the arm before the first one. All
/// lanes busy on one thread, by turns.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "benchmarks/stopwatch.hpp"
#include "studies/config/study.hpp"
#include "studies/execution/arm_run.hpp"
#include "studies/execution/simulator.hpp"

namespace unbruised::benchmarks {
namespace {

using studies::core_simulator;

constexpr int kTurns = 5;
constexpr double kCells_m[] = {8.33e-3, 6.25e-3, 5e-3};
/// The limit that an arm is held to, against the same scenario without.
constexpr double kLargestRatio = 1.05;

struct Scene {
  const char* name;
  std::vector<std::string> sets;
  bool has_arm;  ///< else the same path as with it
};

std::vector<std::string> with_arm(std::vector<std::string> more) {
  std::vector<std::string> sets = {"robot.urdf=robots/mid_size_arm.urdf",
                                   "robot.base_place_m=[-0.45, 0.15, 0.0]",
                                   "robot.tool_place_m=[0.0, 0.0, 0.15]",
                                   "robot.tool_rotation_rad=[0.0, 3.14159265, 0.0]",
                                   "robot.seed_posture_rad=[0.0, 0.4, 0.7, 0.0, 0.47, 0.0]",
                                   "robot.acceleration_rad_s2=[15.0, 15.0, 15.0, 20.0, 20.0, 20.0]",
                                   "robot.gripper_mass_kg=0.9"};
  sets.insert(sets.end(), more.begin(), more.end());
  return sets;
}

const std::vector<Scene>& scenes() {
  static const std::vector<std::string> calm = with_arm({}),
                                        hasty = with_arm({"robot.timing=fit",
                                                          "strategy.transfer_acceleration_m_s2=20.0",
                                                          "strategy.speed_m_s=2.0"});
  static const std::vector<Scene> all{{"no arm", calm, false},
                                      {"arm", calm, true},
                                      {"no arm, slowed path", hasty, false},
                                      {"arm, slows it down", hasty, true}};
  return all;
}

struct Cost {
  double step_us = HUGE_VAL;  ///< of a lane and step
  double load_ms = 0.0;       ///< of a scenario: before its first step
  double steps = 0.0;         ///< of a scenario

  [[nodiscard]] double all_us() const { return step_us + 1e3 * load_ms / steps; }
};

void run_once(const studies::SharedModel& model, const Scenario& scenario, Cost& least) {
  const int lanes = core_simulator().lane_count();
  const double start_s = processor_s();
  const auto engine = model.make_lanes();
  for (int lane = 0; lane < lanes; ++lane) engine->load(lane, scenario);
  const double loaded_s = processor_s();
  double lane_steps = 0.0;
  for (int ended = 0; ended < lanes; ended += static_cast<int>(engine->finished().size())) {
    engine->step();
    lane_steps += engine->stepped();
  }
  const double us = 1e6 * (processor_s() - loaded_s) / lane_steps;
  if (us < least.step_us) least = {us, 1e3 * (loaded_s - start_s) / lanes, lane_steps / lanes};
}

/// @return false where a scene cannot be read or built
bool measure(const std::string& root, double cell_m) {
  std::vector<Scenario> scenarios;
  for (const Scene& scene : scenes()) {
    std::vector<std::string> sets = scene.sets;
    sets.push_back("product.cell_size_m=" + std::to_string(cell_m));
    const studies::StudyOrError study = studies::read_study(root + "/kiwi_first.toml", sets, root);
    if (!study) {
      for (const std::string& line : study.error().messages) std::fprintf(stderr, "%s\n", line.c_str());
      return false;
    }
    scenarios.push_back(study->scenario(study->scenario_count() / 2));
    if (scene.has_arm) continue;
    scenarios.back() = studies::ArmRun(scenarios.back()).scenario();
    scenarios.back().robot = {};
  }
  const studies::ModelOrReason model = core_simulator().build(scenarios.front());
  if (!model) {
    std::fprintf(stderr, "cannot be built: %s\n", model.error().c_str());
    return false;
  }
  std::vector<Cost> costs(scenes().size());
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t s = 0; s < scenes().size(); ++s) run_once(**model, scenarios[s], costs[s]);
  }
  for (std::size_t s = 0; s < scenes().size(); ++s) {
    const Cost &cost = costs[s], &without = costs[s - s % 2];
    const double all = cost.all_us() / without.all_us();
    std::printf("%8.2f  %-20s %7.0f %9.2f %7.3f %9.2f %7.3f%s\n", 1e3 * cell_m, scenes()[s].name, cost.steps,
                cost.step_us, cost.step_us / without.step_us, cost.load_ms, all, all > kLargestRatio ? "*" : "");
  }
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main(int argc, char** argv) {
  using namespace unbruised::benchmarks;
  const std::string root = argc > 1 ? argv[1] : "configs";
  std::printf("An arm that follows: kiwi_first's, %d lanes, least of %d turns, processor time\n",
              core_simulator().lane_count(), kTurns);
  std::printf("%8s  %-20s %7s %9s %7s %9s %7s\n", "cells mm", "scene", "steps", "us/step", "ratio", "load ms",
              "with it");
  for (const double cell_m : kCells_m) {
    if (!measure(root, cell_m)) return EXIT_FAILURE;
  }
  std::printf("*: more than %.2f times the same without an arm\n", kLargestRatio);
  return EXIT_SUCCESS;
}
