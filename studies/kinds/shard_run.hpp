#pragma once

/// @file
/// A part of a study, run by one process of several, on this machine or on others that see the same run
/// directory. What it consists of is known beforehand: scenarios, of a window study combinations.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/execution/executor.hpp"
#include "studies/execution/progress.hpp"
#include "studies/results/expected.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {

/// The part `number` of `count`, from 1.
struct Shard {
  std::uint64_t number = 1, count = 1;
};

/// "3/8"; nothing where it is no part.
std::optional<Shard> shard_of(std::string_view text);

/// The scenarios (combinations) of a part, ascending. Parts are equal to one of them, and go along the factor
/// groups, so that few of them factor the same matrix.
std::vector<std::uint64_t> shard_ids(const ScenarioSet& set, const Shard& shard);

/// What parts consist of and the journals of the directory do not have whole, ascending. Errors: damaged when
/// they hold another study's rows.
Expected<std::vector<std::uint64_t>> missing_ids(const Study& study, RunDirectory& run);
/// The word for `count` of what the parts of a study consist of.
std::string units_of(const Study& study, std::size_t count);
/// "0 to 3, 7, 9 to 12"; a dozen ranges at most.
std::string id_ranges(const std::vector<std::uint64_t>& ids);

struct ShardReport {
  std::size_t count = 0;    ///< scenarios (combinations) of the part
  std::size_t run_now = 0;  ///< scenarios that no journal had when it began
  bool interrupted = false;
  double seconds = 0.0;
};

/// Runs what no journal has of a part. Errors: those of the run directory.
Expected<ShardReport> run_shard(const Study& study, RunDirectory& run, const Executor& executor,
                                const Shard& shard, const std::atomic<bool>* stop, Progress* progress);

}  // namespace unbruised::studies
