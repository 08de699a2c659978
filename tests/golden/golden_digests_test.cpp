/// @file
/// The committed digests of this numeric build (digests.txt): a commit that moves any number of the simulator or
/// of a search fails here until the line is renewed and CHANGELOG.md says why and by how much.

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "benchmarks/cube512_scene.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/findings/summary.hpp"
#include "studies/results/digest.hpp"
#include "tests/places.hpp"
#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

const std::string kFolder = std::string(UNBRUISED_SOURCE_DIR) + "/tests/golden";

/// The committed digests of one numeric build by the name of the case; empty: none were made on such a machine.
std::map<std::string, std::string> committed_digests(const std::string& build) {
  std::ifstream file(kFolder + "/digests.txt");
  std::map<std::string, std::string> digests;
  bool ours = false;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      ours = line == "[" + build + "]";
    } else if (ours) {
      std::istringstream words(line);
      std::string name, equals, digest;
      words >> name >> equals >> digest;
      digests[name] = digest;
    }
  }
  return digests;
}

void expect_golden(const std::string& name, const std::string& digest) {
  const std::string build = numeric_build();
  const std::map<std::string, std::string> committed = committed_digests(build);
  const std::string line = name + " = " + digest;
  if (committed.empty()) {
    GTEST_SKIP() << "no golden digests were committed for the numeric build [" << build << "]; here: " << line;
  }
  const auto found = committed.find(name);
  EXPECT_TRUE(found != committed.end() && found->second == digest)
      << "The numbers of `" << name << "` changed: the committed digest is "
      << (found != committed.end() ? found->second : "missing") << ".\nIf that is meant, put the line\n  " << line
      << "\nunder [" << build
      << "] in tests/golden/digests.txt, and say in CHANGELOG.md, under \"Numbers changed\", "
      << "which numbers moved, why and by how much.";
}

std::string digest_of(const Study& study) {
  const StudyReport report = run_fresh(study, core_simulator());
  return rows_digest(report.tables.rows);
}

Study study_at(const std::string& path) {
  const std::string root = std::string(UNBRUISED_SOURCE_DIR) + "/configs";
  StudyOrError read = read_study(path, {}, root);
  if (!read) throw std::runtime_error(read.error().messages.front());
  return *std::move(read);
}

void expect_golden_cube(const std::string& name, const Scenario& scene) {
  std::string error;
  const auto model = Model::build(scene, error);
  ASSERT_NE(model, nullptr) << error;
  expect_golden(name, digest_text(result_digest(simulate(model, scene, nullptr))));
}

TEST(GoldenDigests, Cube512ForASecond) { expect_golden_cube("cube512", benchmarks::cube512_scene(1e-3)); }

TEST(GoldenDigests, Cube512ByModes) {
  Scenario scene = benchmarks::cube512_scene(1e-3);
  scene.simulation.body = ProductBody::modes;
  expect_golden_cube("cube512_modes", scene);
}

/// The files are named like the cases.
class GoldenStudies : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenStudies, KeepTheirDigests) {
  const std::string name = GetParam();
  expect_golden(name, digest_of(study_at(kFolder + "/studies/" + name + ".toml")));
}

INSTANTIATE_TEST_SUITE_P(Kinds, GoldenStudies,
                         ::testing::Values("sweep", "viscous_layers", "window", "sample", "optimize", "robust",
                                           "pareto", "compare", "sensitivity", "calibrate"),
                         [](const auto& tested) { return std::string(tested.param); });

/// Every network that ships.
class GoldenNetworks : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenNetworks, KeepTheirDigests) {
  const std::string name = GetParam();
  expect_golden("network_" + name,
                digest_of(study_at(std::string(UNBRUISED_SOURCE_DIR) + "/configs/networks/" + name + ".toml")));
}

INSTANTIATE_TEST_SUITE_P(Shipped, GoldenNetworks,
                         ::testing::Values("bathe_2dof", "elastic_bar_wall", "plastic_spring"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(GoldenDigests, EveryNetworkThatShipsHasOne) {
  std::size_t networks = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(UNBRUISED_SOURCE_DIR) + "/configs/networks")) {
    if (entry.path().extension() == ".toml") ++networks;
  }
  EXPECT_EQ(networks, 3U) << "a new network joins the list of GoldenNetworks";
}

TEST(GoldenDigests, TheLabelOfTheBuildNamesWhatTheBitsDependOn) {
  const std::string build = numeric_build();
  for (const std::string& part : {compiler_text(), instruction_set(), std::string("CHOLMOD"), std::string("-O")}) {
    EXPECT_NE(build.find(part), std::string::npos) << build;
  }
#if defined(__GLIBC__)
  EXPECT_NE(build.find("glibc"), std::string::npos) << build;
#endif
  EXPECT_NE(build_line().find(build), std::string::npos) << build_line();
}

}  // namespace
}  // namespace unbruised::studies::testing
