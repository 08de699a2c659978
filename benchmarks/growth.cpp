/// @file
/// How the cost of a lane-step grows with the mesh: the cube of cube512 with more and more particles, all lanes
/// busy, against the entries of its factor.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/cube512_scene.hpp"
#include "benchmarks/part_times.hpp"
#include "benchmarks/stopwatch.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr int kParticlesAcross[] = {8, 10, 13, 16, 20};  // 512, 1,000, 2,197, 4,096, 8,000 particles
constexpr double kTimeStep_s = 1e-3;
/// Of the scene's second: closing, pressing and settling.
constexpr double kSimulated_s = 0.2;

Scenario cube(int across) {
  Scenario scene = cube512_scene(kTimeStep_s);
  std::get<LatticeParameters>(scene.product).cell_size_m = kCube512Side_m / (across - 1);
  scene.simulation.duration_s = kSimulated_s;
  return scene;
}

/// @return false where the model cannot be built
bool measure(int across, double& first_us) {
  const Scenario scene = cube(across);
  std::string error;
  const double start = processor_s();
  const std::shared_ptr<const Model> model = Model::build(scene, error);
  if (!model) {
    std::fprintf(stderr, "%d particles across: %s\n", across, error.c_str());
    return false;
  }
  const double built = processor_s();
  LaneSimulation simulation(model);
  simulation.enable_timing();
  for (int lane = 0; lane < lane_count(); ++lane) simulation.load(lane, scene);
  while (simulation.busy_count() > 0) simulation.step();
  const LaneSimulation::PartTimes part = simulation.part_times();
  const double us = 1e6 / static_cast<double>(part.lane_steps);
  const double all_us = us * total_s(part);
  if (first_us == 0.0) first_us = all_us;
  std::printf("%9zu %11zu %9zu %9.1f %8.2f %8.1f %8.1f %8.1f %10.3f %10.2f\n", model->particle_count(),
              model->factor_entry_count(), model->contact_candidate_count(), all_us, all_us / first_us,
              us * part.solve_s, us * part.contact_s, us * part.right_hand_side_s,
              1e3 * us * part.solve_s / static_cast<double>(model->factor_entry_count()), built - start);
  std::fflush(stdout);
  return true;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main() {
  std::printf("Cubes of 5 cm, dt %.0f ms, the first %.1f s, %d lanes busy; microseconds per lane and step\n",
              1e3 * unbruised::benchmarks::kTimeStep_s, unbruised::benchmarks::kSimulated_s,
              unbruised::lane_count());
  std::printf("%9s %11s %9s %9s %8s %8s %8s %8s %10s %10s\n", "particles", "nnz(L)", "may touch", "total", "ratio",
              "solve", "contact", "rhs", "ns/entry", "build s");
  double first_us = 0.0;
  for (const int across : unbruised::benchmarks::kParticlesAcross) {
    if (!unbruised::benchmarks::measure(across, first_us)) return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
