/// @file
/// What lockstep lanes are worth to a search: the shipped kiwi_optimize on coarse cells, 16 searches at once,
/// against the same searches one after the other, where each scenario has a lane and a core to itself. One thread
/// both times; the digests must be equal.

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/findings/summary.hpp"
#include "studies/kinds/study_runner.hpp"
#include "studies/results/run_directory.hpp"

namespace unbruised::studies {
namespace {

StudyReport run_with(const Study& study, std::size_t concurrent_searches) {
  const auto directory = std::filesystem::temp_directory_path() / "unbruised_benchmark_multistart";
  std::filesystem::remove_all(directory);
  auto run = RunDirectory::open({directory, study.resolved_toml(), build_line(), true});
  auto report = run_study(study, **run, LaneExecutor(core_simulator(), 1),
                          {.stop = nullptr, .progress = nullptr, .concurrent_searches = concurrent_searches});
  std::filesystem::remove_all(directory);
  return report ? std::move(*report) : StudyReport{};
}

void print(const char* how, const StudyReport& report) {
  std::printf("%-12s%8.2f s to the answer, lanes %5.1f %% busy\n", how, report.search_seconds,
              100.0 * report.lane_use.occupancy());
}

}  // namespace
}  // namespace unbruised::studies

int main(int argc, char** argv) {
  using namespace unbruised::studies;
  const std::string root = argc > 1 ? argv[1] : "configs";
  const std::vector<std::string> sets = {"product.cell_size_m=0.00833", "simulation.time_step_s=1.5e-3",
                                         "cell.transfer_m=[0.0,0.1]", "search.budget=320"};
  const StudyOrError study = read_study(root + "/kiwi_optimize.toml", sets, root);
  if (!study) {
    std::fprintf(stderr, "usage: benchmark_multistart [CONFIG_ROOT]; %s/kiwi_optimize.toml cannot be read\n",
                 root.c_str());
    return 2;
  }
  const StudyReport together = run_with(*study, 256);
  const StudyReport one_by_one = run_with(*study, 1);
  const std::string digest = rows_digest(together.tables.rows);
  const bool same = digest == rows_digest(one_by_one.tables.rows);
  std::printf("kiwi_optimize on 8.33 mm cells, %d searches, %zu scenarios, one thread\n",
              static_cast<int>(study->search().starts), together.tables.rows.size());
  print("together", together);
  print("one by one", one_by_one);
  std::printf("together is %.1f x sooner; digest %s, %s\n", one_by_one.search_seconds / together.search_seconds,
              digest.c_str(), same ? "same bits" : "DIFFERENT BITS");
  return same ? 0 : 1;
}
