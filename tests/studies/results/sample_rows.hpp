#pragma once

/// @file
/// Made-up rows with every kind of value in them, and a directory that goes away.

#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// A row whose values follow from its id; metric 4 stays NaN, metric 10 is negative.
inline ScenarioRow sample_row(std::uint64_t id) {
  ScenarioRow row;
  row.id = id;
  row.result.outcome = static_cast<Outcome>(id % 5);
  row.result.cause = id % 5 == 0 ? "" : "slip_max_m > limits.slip_m";
  if (id % 5 != 0) row.result.outcome_time_s = 0.1 * static_cast<double>(id);
  auto& metrics = row.result.metrics.values();
  for (std::size_t m = 0; m < metrics.size(); ++m) {
    if (m != 4) metrics[m] = static_cast<double>(id) + 0.01 * static_cast<double>(m);
  }
  metrics[10] = -1.0 / (1.0 + static_cast<double>(id));
  row.inputs = {0.5 + static_cast<double>(id), std::string(id % 2 == 0 ? "kiwi.toml" : "grüne Pflaume.toml")};
  return row;
}

inline std::vector<ScenarioRow> sample_rows(std::uint64_t count) {
  std::vector<ScenarioRow> rows;
  for (std::uint64_t id = 0; id < count; ++id) rows.push_back(sample_row(id));
  return rows;
}

/// The message of an error, empty on success: comparing it with "" shows what went wrong.
inline std::string message_of(const MaybeError& error) { return error ? error->message : std::string(); }

/// A fresh directory below the system's temporary one, removed at the end of its life.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "unbruised-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace unbruised::studies
