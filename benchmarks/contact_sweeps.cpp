/// @file
/// How many sweeps the contact solve takes in a step, by time step and phase: of cube512 and of the kiwi of
/// `kiwi_first`. Counts, which no other process can disturb.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/cube512_scene.hpp"
#include "core/simulation/lane_observer.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr double kTimeSteps_s[] = {0.5e-3, 1e-3, 2e-3, 5e-3, 10e-3};
constexpr std::array kPhases = {CyclePhase::grip,     CyclePhase::lift,  CyclePhase::hold,
                                CyclePhase::transfer, CyclePhase::lower, CyclePhase::release};

/// Of the steps of some phase that swept at all.
struct Count {
  int steps = 0;
  double sweeps = 0, most = 0;

  void add(double step) {
    if (step == 0.0) return;
    ++steps;
    sweeps += step;
    most = std::max(most, step);
  }
};
using Counts = std::array<Count, kCyclePhaseWords.size()>;

class SweepCounter : public LaneObserver {
 public:
  explicit SweepCounter(Counts& counts) : counts_(counts) {}
  void start(const LaneStep& /*loaded*/) override {}
  bool observe(const LaneStep& step) override {
    counts_[static_cast<std::size_t>(step.cycle.phase(step.time_s))].add(step.contact_sweeps);
    return true;
  }
  void end(const LaneStep& /*last*/) override {}

 private:
  Counts& counts_;
};

/// @return false where the scene cannot be built
bool count(const char* name, const Scenario& scenario) {
  std::string error;
  const auto model = Model::build(scenario, error);
  if (!model) {
    std::fprintf(stderr, "%s cannot be built: %s\n", name, error.c_str());
    return false;
  }
  Counts counts;
  ScenarioResult result;
  LaneSimulation simulation(model);
  simulation.load(0, scenario);
  simulation.watch(0, std::make_unique<SweepCounter>(counts));
  while (simulation.busy_count() > 0) {
    simulation.step();
    for (const auto& finished : simulation.finished()) result = finished.result;
  }
  Count all;
  for (const Count& phase : counts) {
    all.steps += phase.steps;
    all.sweeps += phase.sweeps;
    all.most = std::max(all.most, phase.most);
  }
  std::printf("%-8s %6.1f %9s %6d %7.2f /%4.0f", name, 1e3 * scenario.simulation.time_step_s,
              std::string(outcome_word(result.outcome)).c_str(), all.steps, all.sweeps / std::max(1, all.steps),
              all.most);
  for (const CyclePhase phase : kPhases) {
    const Count& of = counts[static_cast<std::size_t>(phase)];
    if (of.steps > 0) {
      std::printf(" %7.2f /%4.0f", of.sweeps / of.steps, of.most);
    } else {
      std::printf(" %13s", "-");
    }
  }
  std::printf("\n");
  std::fflush(stdout);
  return true;
}

int run(const std::string& root) {
  const studies::StudyOrError study =
      studies::read_study(root + "/kiwi_first.toml", {"simulation.levels=off"}, root);
  if (!study) {
    for (const std::string& line : study.error().messages) std::fprintf(stderr, "%s\n", line.c_str());
    return EXIT_FAILURE;
  }
  std::printf("Contact sweeps per step that has any, mean / most\n%-8s %6s %9s %6s %13s", "scene", "dt ms",
              "outcome", "steps", "all");
  for (const CyclePhase phase : kPhases) {
    std::printf(" %13s", std::string(kCyclePhaseWords[static_cast<std::size_t>(phase)]).c_str());
  }
  std::printf("\n");
  for (const double dt : kTimeSteps_s) {
    if (!count("cube512", cube512_scene(dt))) return EXIT_FAILURE;
  }
  for (const double dt : kTimeSteps_s) {
    Scenario kiwi = study->scenario(study->scenario_count() / 2);
    kiwi.simulation.time_step_s = dt;
    if (!count("kiwi", kiwi)) return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main(int argc, char** argv) { return unbruised::benchmarks::run(argc > 1 ? argv[1] : "configs"); }
