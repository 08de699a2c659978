#pragma once

/// @file
/// Runs whole studies over a simulator in a folder of their own.

#include <atomic>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "studies/config/study.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/kinds/study_runner.hpp"
#include "studies/results/run_directory.hpp"
#include "tests/places.hpp"

namespace unbruised::studies::testing {

/// A folder that is empty at first and gone at the end.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("unbruised_" + name + "_" + std::to_string(::getpid()) + "_" + std::to_string(count()++))) {
    std::filesystem::remove_all(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  static int& count() {
    static int next = 0;
    return next;
  }
  std::filesystem::path path_;
};

/// The study of a text; messages fail the test.
inline Study study_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  const std::string root = std::string(UNBRUISED_SOURCE_DIR) + "/configs";
  StudyOrError read = read_study_text(text, "test.toml", sets, root, root);
  if (!read) {
    std::string all;
    for (const std::string& message : read.error().messages) all += message + "\n";
    throw std::runtime_error(all);
  }
  return *std::move(read);
}

struct RunOnce {
  int threads = 2;
  std::size_t concurrent_searches = 256;
  const std::atomic<bool>* stop = nullptr;
};

/// Runs (or continues) a study in a folder.
inline StudyReport run_in(const std::filesystem::path& folder, const Study& study, const Simulator& simulator,
                          const RunOnce& how = {}) {
  auto run = RunDirectory::open(
      {.directory = folder, .config_toml = study.resolved_toml(), .build = "test", .fresh = false});
  if (!run) throw std::runtime_error(run.error().message);
  auto report = run_study(study, **run, LaneExecutor(simulator, how.threads),
                          {.stop = how.stop, .progress = nullptr, .concurrent_searches = how.concurrent_searches});
  if (!report) throw std::runtime_error(report.error().message);
  return std::move(*report);
}

inline StudyReport run_fresh(const Study& study, const Simulator& simulator, const RunOnce& how = {}) {
  const TemporaryFolder folder("search");
  return run_in(folder.path(), study, simulator, how);
}

/// A table that has to be there.
inline const ResultTable& table_of(const StudyReport& report, const std::string& name) {
  const ResultTable* table = find_table(report.tables.found, name);
  if (table == nullptr) throw std::runtime_error("no table " + name);
  return *table;
}

/// A small lattice product between two fingers, for studies whose simulator is a formula that damages nothing.
inline const std::string kFormulaCell = R"(
[product]
kind = "lattice"
shape = "box"
size_m = [0.02, 0.02, 0.02]
cell_size_m = 0.01
mass_kg = 0.1
youngs_modulus_Pa = 1e6
[gripper]
use = "grippers/parallel_jaw.toml"
[limits]
damage = "not considered"
[simulation]
time_step_s = 1e-3
)";

}  // namespace unbruised::studies::testing
