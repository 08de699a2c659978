/// @file
/// What it takes until the first step: the making of a model, its factor and the compliance of what may touch.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "benchmarks/cube512_scene.hpp"
#include "benchmarks/stopwatch.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr int kTurns = 10;

/// Prints the least processor time of some turns. @return was a model built?
bool build(const char* scene, const Scenario& scenario) {
  double least_s = HUGE_VAL;
  std::shared_ptr<const Model> model;
  for (int turn = 0; turn < kTurns; ++turn) {
    const double start_s = processor_s();
    std::string error;
    model = Model::build(scenario, error);
    if (!model) {
      std::fprintf(stderr, "%s: %s\n", scene, error.c_str());
      return false;
    }
    least_s = std::min(least_s, processor_s() - start_s);
  }
  std::printf("%-22s %9zu %10zu %10zu %9.1f\n", scene, model->particle_count(), model->contact_candidate_count(),
              model->factor_entry_count(), 1e3 * least_s);
  return true;
}

bool build_shipped(const std::string& root, const char* study_name) {
  const auto study = studies::read_study(root + "/" + study_name + ".toml", {}, root);
  return build(study_name, study->scenario(0));
}

}  // namespace
}  // namespace unbruised::benchmarks

int main(int argc, char** argv) {
  using namespace unbruised::benchmarks;
  const std::string root = argc > 1 ? argv[1] : "configs";
  std::printf("Models, least processor time of %d turns\n", kTurns);
  std::printf("%-22s %9s %10s %10s %9s\n", "scene", "particles", "candidates", "entries", "build ms");
  const bool sound = build("cube512", cube512_scene(1e-3)) && build_shipped(root, "kiwi_sweep") &&
                     build_shipped(root, "turn_and_place");
  return sound ? 0 : 1;
}
