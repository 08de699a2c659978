#include "studies/execution/machine.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

double number_in(const std::string& path) {
  std::ifstream file(path);
  double number = 0.0;
  return file >> number && number > 0.0 ? number : kNoLimit;
}

std::string text_in(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// A file in a group's folder and in those of the groups around it.
void add_up_to_root(const std::string& root, std::string group, std::string_view file,
                    std::vector<std::string>& files) {
  while (true) {
    while (!group.empty() && group.back() == '/') group.pop_back();
    files.push_back(joined({root, group, "/", file}));
    const std::size_t slash = group.rfind('/');
    if (slash == std::string::npos) return;
    group.resize(slash);
  }
}

/// "200000 100000", quota and period; or "max 100000": no limit.
double cores_of_new_group(const std::string& path) {
  std::ifstream file(path);
  double quota_us = 0.0;
  double period_us = 0.0;
  return file >> quota_us >> period_us && quota_us > 0.0 && period_us > 0.0 ? quota_us / period_us : kNoLimit;
}

/// The quota's file says -1 where there is no limit; the period stands beside it.
double cores_of_old_group(const std::string& path) {
  const std::size_t name = path.rfind('/') + 1;
  return number_in(path) / number_in(path.substr(0, name) + "cpu.cfs_period_us");
}

int cores_of_affinity() {
  cpu_set_t mine;
  CPU_ZERO(&mine);
  // What taskset, a batch system or a container leaves of the machine.
  if (::sched_getaffinity(0, sizeof mine, &mine) == 0 && CPU_COUNT(&mine) > 0) return CPU_COUNT(&mine);
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace

std::vector<std::string> limit_files(const std::string& proc_self_cgroup, const GroupLimit& limit) {
  std::vector<std::string> files;
  std::istringstream lines(proc_self_cgroup);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = joined({",", line.substr(first + 1, second - first - 1), ","});
    const std::string group = line.substr(second + 1);
    if (controllers == ",,") add_up_to_root("/sys/fs/cgroup", group, limit.file, files);
    if (controllers.find(joined({",", limit.controller, ","})) != std::string::npos) {
      add_up_to_root(joined({"/sys/fs/cgroup/", limit.controller}), group, limit.old_file, files);
    }
  }
  return files;
}

double machine_memory_bytes() {
  double bytes = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  for (const std::string& path : limit_files(text_in("/proc/self/cgroup"), kMemoryLimit)) {
    bytes = std::min(bytes, number_in(path));
  }
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  }
  return bytes;
}

double group_cores(const std::string& root) {
  double cores = kNoLimit;
  for (const std::string& path : limit_files(text_in(root + "/proc/self/cgroup"), kCoreLimit)) {
    const double left =
        path.ends_with(kCoreLimit.file) ? cores_of_new_group(root + path) : cores_of_old_group(root + path);
    if (left > 0.0) cores = std::min(cores, left);  // neither zero nor "not a number"
  }
  return cores;
}

int usable_cores(const std::string& root) {
  const int mine = cores_of_affinity();
  const double left = std::ceil(group_cores(root));
  return left < mine ? std::max(1, static_cast<int>(left)) : mine;
}

int usable_cores_of_each(int processes) {
  const double all = static_cast<double>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)));
  const double bound_to = cores_of_affinity();
  const int usable = usable_cores();
  return std::clamp(static_cast<int>(usable * (all / bound_to) / processes), 1, usable);
}

}  // namespace unbruised::studies
