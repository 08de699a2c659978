/// @file
/// What it costs that a product may turn, touch with its whole surface, or relax: the kiwi of `kiwi_first`
/// gripped, lifted, carried and put down, upright, tilted on its way, upright with its whole surface, upright
/// with two branches of relaxation, and all but the last by modes, on coarser and finer cells; all lanes busy, by
/// turns on one thread.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/part_times.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr int kTurns = 3;
/// The shipped ripe kiwi has cells of 6.25 mm, `kiwi_window` of 5.
constexpr double kCells_m[] = {8.33e-3, 6.25e-3, 5e-3};
/// The limits that turning and relaxing scenes and those by modes are held to, against the upright one on the same
/// cells.
constexpr double kLargestTurning = 1.3, kLargestRelaxing = 1.1, kLargestByModes = 0.5;

struct Scene {
  const char* name;
  std::vector<std::string> sets;
  double largest_ratio = kLargestTurning;
};

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all{
      {"upright", {}},
      {"tilted", {"strategy.tilt_rad=[0.0, 0.8, 0.0]"}},
      {"whole surface", {"simulation.contact_set=\"whole surface\""}},
      {"whole surface, tilted", {"simulation.contact_set=\"whole surface\"", "strategy.tilt_rad=[0.0, 0.8, 0.0]"}},
      {"relaxing, two branches",
       {"product.prony_modulus=[0.15, 0.15]", "product.prony_time_s=[0.5, 5.0]"},
       kLargestRelaxing},
      {"by modes", {"simulation.body=modes"}, kLargestByModes},
      {"by modes, tilted", {"simulation.body=modes", "strategy.tilt_rad=[0.0, 0.8, 0.0]"}, kLargestByModes},
      {"by modes, whole surface",
       {"simulation.body=modes", "simulation.contact_set=\"whole surface\""},
       kLargestByModes},
  };
  return all;
}

/// Microseconds of a lane and step.
struct Cost {
  double all = HUGE_VAL;
  double right_hand_side = 0, solve = 0, contact = 0, update = 0;
  double steps = 0;  ///< of a lane
};

void run_once(const std::shared_ptr<const Model>& model, const Scenario& scenario, Cost& least) {
  LaneSimulation simulation(model);
  simulation.enable_timing();
  for (int lane = 0; lane < lane_count(); ++lane) simulation.load(lane, scenario);
  while (simulation.busy_count() > 0) simulation.step();
  const LaneSimulation::PartTimes part = simulation.part_times();
  const double us = 1e6 / static_cast<double>(part.lane_steps);
  if (us * total_s(part) >= least.all) return;
  least = {us * total_s(part),
           us * part.right_hand_side_s,
           us * part.solve_s,
           us * part.contact_s,
           us * part.update_s + us * part.plasticity_s,
           static_cast<double>(part.lane_steps) / lane_count()};
}

/// @return false where a scene cannot be read or built
bool measure(const std::string& root, double cell_m) {
  std::vector<std::shared_ptr<const Model>> models;
  std::vector<Scenario> scenarios;
  for (const Scene& scene : scenes()) {
    std::vector<std::string> sets = scene.sets;
    sets.push_back("product.cell_size_m=" + std::to_string(cell_m));
    sets.emplace_back("simulation.levels=off");
    const studies::StudyOrError study = studies::read_study(root + "/kiwi_first.toml", sets, root);
    if (!study) {
      for (const std::string& line : study.error().messages) std::fprintf(stderr, "%s\n", line.c_str());
      return false;
    }
    scenarios.push_back(study->scenario(study->scenario_count() / 2));
    std::string error;
    models.push_back(Model::build(scenarios.back(), error));
    if (!models.back()) {
      std::fprintf(stderr, "%s cannot be built: %s\n", scene.name, error.c_str());
      return false;
    }
  }
  std::vector<Cost> costs(scenes().size());
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t s = 0; s < scenes().size(); ++s) run_once(models[s], scenarios[s], costs[s]);
  }
  for (std::size_t s = 0; s < scenes().size(); ++s) {
    const Cost& cost = costs[s];
    const double ratio = cost.all / costs.front().all;
    std::printf("%8.2f %9zu %9zu  %-24s %7.0f %9.1f %7.2f%s %8.1f %8.1f %8.1f %8.1f\n", 1e3 * cell_m,
                models[s]->particle_count(), models[s]->contact_candidate_count(), scenes()[s].name, cost.steps,
                cost.all, ratio, ratio > scenes()[s].largest_ratio ? "*" : " ", cost.right_hand_side, cost.solve,
                cost.contact, cost.update);
  }
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main(int argc, char** argv) {
  using namespace unbruised::benchmarks;
  const std::string root = argc > 1 ? argv[1] : "configs";
  std::printf(
      "Products that turn or relax: kiwi_first's, %d lanes, least of %d turns; microseconds per lane and step\n",
      unbruised::lane_count(), kTurns);
  std::printf("%8s %9s %9s  %-24s %7s %9s %8s %8s %8s %8s %8s\n", "cells mm", "particles", "may touch", "scene",
              "steps", "total", "ratio", "rhs", "solve", "contact", "update");
  for (const double cell_m : kCells_m) {
    if (!measure(root, cell_m)) return EXIT_FAILURE;
  }
  std::printf("*: more than %.1f times the upright one, of what relaxes %.1f, by modes %.1f times\n",
              kLargestTurning, kLargestRelaxing, kLargestByModes);
  return EXIT_SUCCESS;
}
