/// @file
/// What keeping results costs a sweep: the shipped kiwi sweep is simulated once, and its rows are then taken
/// through a run directory (journal with group commits, results.h5 with checksums) as `unbruised run` does it. And
/// how long `unbruised check` would need to read, validate and group a sweep of 100,000 scenarios.

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "benchmarks/stopwatch.hpp"
#include "studies/config/study.hpp"
#include "studies/execution/batch_runner.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/kinds/study_results.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {
namespace {

constexpr int kThreads = 2;

std::map<std::uint64_t, ScenarioResult> simulate_all(const Study& study) {
  Batch batch;
  for (std::uint64_t id = 0; id < study.scenario_count(); ++id) batch.ids.push_back(id);
  batch.scenario = [&study](std::uint64_t id) { return study.scenario(id); };
  std::map<std::uint64_t, ScenarioResult> results;
  run_batch(LaneExecutor(core_simulator(), kThreads), batch,
            [&results](std::uint64_t id, const ScenarioResult& result) { results[id] = result; });
  return results;
}

bool write_all(const Study& study, const std::map<std::uint64_t, ScenarioResult>& results,
               const std::filesystem::path& directory) {
  auto run = RunDirectory::open({directory, study.resolved_toml(), build_line(), true});
  if (!run.has_value()) return false;
  for (const auto& [id, result] : results) {
    if ((*run)->append({id, result, grid_inputs(study, static_cast<std::size_t>(id)), std::nullopt}).has_value())
      return false;
  }
  ResultsContent content;
  content.meta = results_meta(study, {}, ResultsState::complete);
  content.inputs = input_columns(study);
  return !(*run)->finish(content).has_value();
}

std::size_t read_and_group(const std::string& text, const std::string& root) {
  const StudyOrError study = read_study_text(text, "large.toml", {}, "", root);
  if (!study) return 0;
  std::set<std::string> keys;
  for (std::size_t id = 0; id < study->scenario_count(); ++id) keys.insert(factor_key(study->scenario(id)));
  return study->scenario_count();
}

}  // namespace
}  // namespace unbruised::studies

int main(int argc, char** argv) {
  using namespace unbruised;
  using namespace unbruised::studies;
  const std::string root = argc > 1 ? argv[1] : "configs";
  const StudyOrError study = read_study(root + "/kiwi_sweep.toml", {}, root);
  if (!study) {
    std::fprintf(stderr, "usage: benchmark_results_cost [CONFIG_ROOT]; %s/kiwi_sweep.toml cannot be read\n",
                 root.c_str());
    return 2;
  }
  std::map<std::uint64_t, ScenarioResult> results;
  const double simulating_s = benchmarks::seconds_of([&] { results = simulate_all(*study); });
  const auto directory = std::filesystem::temp_directory_path() / "unbruised_benchmark_results_cost";
  benchmarks::Samples writing;
  for (int repeat = 0; repeat < 5; ++repeat) {
    std::filesystem::remove_all(directory);
    bool written = false;
    writing.add(benchmarks::seconds_of([&] { written = write_all(*study, results, directory); }));
    if (!written) {
      std::fprintf(stderr, "%s: cannot be written\n", directory.c_str());
      return 5;
    }
  }
  std::filesystem::remove_all(directory);
  std::printf(
      "kiwi_sweep as shipped: %zu scenarios simulated in %.1f s on %d threads, %.2f scenarios/s per core\n",
      results.size(), simulating_s, kThreads, static_cast<double>(results.size()) / simulating_s / kThreads);
  std::printf("journal + results.h5 of its rows: best %.4f s, median %.4f s = %.3f %% of the sweep\n",
              writing.best_s(), writing.median_s(), 100.0 * writing.median_s() / simulating_s);
  const std::string large =
      "[study]\nname = \"large\"\nkind = \"sweep\"\n[product]\nuse = \"products/kiwi_ripe.toml\"\n[gripper]\n"
      "use = \"grippers/parallel_jaw.toml\"\n[[vary]]\nkey = \"strategy.grip_force_N\"\nfrom = 0.6\nto = "
      "6.0\ncount = 100\n"
      "[[vary]]\nkey = \"strategy.approach_speed_m_s\"\nfrom = 0.02\nto = 0.25\ncount = 100\n"
      "[[vary]]\nkey = \"product.youngs_modulus_Pa\"\nfrom = 2e5\nto = 4e5\ncount = 10\n";
  std::size_t count = 0;
  const double reading_s = benchmarks::seconds_of([&] { count = read_and_group(large, root); });
  std::printf("a study of %zu scenarios read, validated and grouped in %.3f s\n", count, reading_s);
  return 0;
}
