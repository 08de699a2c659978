/// @file
/// How the cost of a lane-step grows with the mesh: the cube of cube512 with more and more particles, all lanes
/// busy, and of a block that grows behind the same faces; by every particle and by modes.

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
constexpr int kParticlesLong[] = {10, 20, 40, 80};  // of blocks with faces of 10 x 10: 1,000 to 8,000 particles
constexpr double kTimeStep_s = 1e-3;
/// Of the scene's second: closing, pressing and settling.
constexpr double kSimulated_s = 0.2;

Scenario cube(int across) {
  Scenario scene = cube512_scene(kTimeStep_s);
  std::get<LatticeParameters>(scene.product).cell_size_m = kCube512Side_m / (across - 1);
  scene.simulation.duration_s = kSimulated_s;
  return scene;
}

/// Longer along the way that the pads close; they meet the same faces, and nothing else is met.
Scenario block(int length) {
  Scenario scene = cube(10);
  auto& product = std::get<LatticeParameters>(scene.product);
  product.size_m[0] = product.cell_size_m * (length - 1);
  scene.cell.support = false;
  scene.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  return scene;
}

Scenario by_modes(Scenario scene) {
  scene.simulation.body = ProductBody::modes;
  return scene;
}

/// @return false where the model cannot be built
bool measure(const char* name, const Scenario& scene, double& first_us) {
  std::string error;
  const double start = processor_s();
  const std::shared_ptr<const Model> model = Model::build(scene, error);
  if (!model) {
    std::fprintf(stderr, "%s: %s\n", name, error.c_str());
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
  std::printf("%-6s %9zu %11zu %9zu %9.1f %8.2f %8.1f %8.1f %8.1f %10.2f\n", name, model->particle_count(),
              model->factor_entry_count(), model->contact_candidate_count(), all_us, all_us / first_us,
              us * part.solve_s, us * part.contact_s, us * part.right_hand_side_s, built - start);
  std::fflush(stdout);
  return true;
}

template <std::size_t n>
bool measure_all(const char* title, Scenario (*scene)(int), const int (&sizes)[n]) {
  std::printf("%s\n%-6s %9s %11s %9s %9s %8s %8s %8s %8s %10s\n", title, "body", "particles", "nnz(L)",
              "may touch", "total", "ratio", "solve", "contact", "rhs", "build s");
  double first_us = 0.0, first_modes_us = 0.0;
  for (const int size : sizes) {
    if (!measure("full", scene(size), first_us)) return false;
    if (!measure("modes", by_modes(scene(size)), first_modes_us)) return false;
  }
  return true;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main() {
  using namespace unbruised::benchmarks;
  std::printf("dt %.0f ms, the first %.1f s, %d lanes busy; microseconds per lane and step\n", 1e3 * kTimeStep_s,
              kSimulated_s, unbruised::lane_count());
  const bool done = measure_all("Cubes of 5 cm", cube, kParticlesAcross) &&
                    measure_all("Blocks whose faces under the pads stay the same", block, kParticlesLong);
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
