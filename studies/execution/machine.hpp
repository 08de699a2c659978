#pragma once

/// @file
/// What of the machine this process may use: cores and memory, by affinity, limits and control groups (containers,
/// batch systems).

#include <string>
#include <string_view>
#include <vector>

namespace unbruised::studies {

/// A limit of control groups and where it stands in either version of them.
struct GroupLimit {
  std::string_view controller;
  std::string_view file;      ///< version 2
  std::string_view old_file;  ///< version 1
};
inline constexpr GroupLimit kMemoryLimit{"memory", "memory.max", "memory.limit_in_bytes"};
inline constexpr GroupLimit kCoreLimit{"cpu", "cpu.max", "cpu.cfs_quota_us"};

/// Where a limit of the group of a process stands, and of the groups around it, by what its /proc/self/cgroup
/// says.
std::vector<std::string> limit_files(const std::string& proc_self_cgroup, const GroupLimit& limit);

/// Memory this process may have: the machine's, or less where a control group or RLIMIT_AS says so.
double machine_memory_bytes();

/// Cores that the control groups leave: quota over period, the least of all groups; infinite where none limits.
/// @param root stands before /proc and /sys (for tests)
double group_cores(const std::string& root);
/// Threads that have a core each, at least 1: those of the affinity mask, or fewer where a control group says so;
/// of a broken core the whole one, as a thread more than cores costs less than a core that nobody uses.
int usable_cores(const std::string& root = "");
/// The part of them that each of several processes on this machine has, at least 1: those that are bound to cores
/// have these, the others share what there is.
int usable_cores_of_each(int processes);

}  // namespace unbruised::studies
