// The contact state register of the studies that ship: its events, played again, give the counts of every row of
// the trace.

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "studies/config/study.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "tests/core/contact/contact_counts.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

fs::path config_root() { return fs::path(UNBRUISED_SOURCE_DIR) / "configs"; }

std::vector<fs::path> shipped_studies() {
  std::vector<fs::path> studies;
  for (const auto& entry : fs::recursive_directory_iterator(config_root())) {
    const std::string folder = entry.path().parent_path().filename().string();
    const bool is_part = folder == "products" || folder == "grippers" || folder == "strategies";
    if (entry.path().extension() == ".toml" && !is_part) studies.push_back(entry.path());
  }
  std::sort(studies.begin(), studies.end());
  return studies;
}

/// Its first scenario in coarse cells, as far as `steps` steps; some hundred rows of it.
unbruised::testing::Recount recount_of(const fs::path& path, std::size_t steps) {
  const StudyOrError read = read_study(path, {}, config_root());
  if (!read) {
    ADD_FAILURE() << read.error().messages.front();
    return {};
  }
  Scenario scenario = read->scenario(0);
  if (auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
    lattice->cell_size_m = std::min(2.0 * lattice->cell_size_m,
                                    0.5 * *std::min_element(lattice->size_m.begin(), lattice->size_m.end()));
  }
  const double step_s = scenario.simulation.time_step_s;
  scenario.simulation.trace_interval_s = 5.0 * step_s;
  LaneSimulation simulation(unbruised::testing::build(scenario));
  simulation.load(0, scenario);
  Trace trace;
  simulation.record(0, &trace);
  for (std::size_t step = 0; step < steps && simulation.busy(0); ++step) simulation.step();
  const auto found = unbruised::testing::recount(trace, scenario.simulation.theta, step_s);
  EXPECT_EQ(found.closed_differs, 0u) << path;
  EXPECT_EQ(found.sliding_differs, 0u) << path;
  EXPECT_EQ(found.impossible, 0u) << path;
  std::printf("[ measured ] %s: %zu events, %zu rows\n", path.filename().c_str(), found.events, found.rows);
  return found;
}

TEST(ShippedContacts, AddUpInAFewStudies) {
  for (const char* name : {"kiwi_first.toml", "drop_attitude.toml", "lift_limit.toml"}) {
    EXPECT_GT(recount_of(config_root() / name, 1200).events, 0u) << name;
  }
}

TEST(HeavyShippedContacts, AddUpInAllStudies) {
  const std::vector<fs::path> studies = shipped_studies();
  ASSERT_GT(studies.size(), 20u);
  std::size_t events = 0;
  for (const fs::path& path : studies) events += recount_of(path, 6000).events;
  EXPECT_GT(events, 1000u);
}

}  // namespace
}  // namespace unbruised::studies
