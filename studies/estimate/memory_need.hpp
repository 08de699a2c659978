#pragma once

/// @file
/// How much memory a study will take and how much there is, so that one too large is refused before it begins.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Where the limits of the memory group of a process stand, and of the groups around it, by what its
/// /proc/self/cgroup says (both versions of cgroups).
std::vector<std::string> memory_limit_files(const std::string& proc_self_cgroup);
/// Memory this process may have: the machine's, or less where a limit (cgroup, RLIMIT_AS) says so.
double machine_memory_bytes();

/// Memory of rows: while results.h5 is written they stand in memory about four times.
double estimated_rows_bytes(double row_count, std::size_t input_count);

/// Says that `needed_bytes` are more than there are, with both figures; nothing when they are not.
std::optional<std::string> too_much_memory(const std::string& study_name, double needed_bytes);

/// The same for a study as it will be run, without building a model that does not fit: of large lattices the
/// particles are counted by their volume first.
std::optional<std::string> too_much_memory(const Study& study, int threads);

}  // namespace unbruised::studies
