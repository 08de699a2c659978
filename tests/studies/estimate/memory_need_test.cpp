#include "studies/estimate/memory_need.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

using Files = std::vector<std::string>;

TEST(MemoryNeed, LooksAtTheGroupThatTheProcessIsInAndAtThoseAroundIt) {
  EXPECT_EQ(memory_limit_files("0::/user.slice/job-7.scope\n"),
            (Files{"/sys/fs/cgroup/user.slice/job-7.scope/memory.max", "/sys/fs/cgroup/user.slice/memory.max",
                   "/sys/fs/cgroup/memory.max"}));
  EXPECT_EQ(memory_limit_files("0::/\n"), (Files{"/sys/fs/cgroup/memory.max"}));
  EXPECT_EQ(memory_limit_files("9:cpu,cpuacct:/a\n7:memory:/docker/x\n"),
            (Files{"/sys/fs/cgroup/memory/docker/x/memory.limit_in_bytes",
                   "/sys/fs/cgroup/memory/docker/memory.limit_in_bytes",
                   "/sys/fs/cgroup/memory/memory.limit_in_bytes"}));
  EXPECT_EQ(memory_limit_files("no line of this kind"), Files{});
}

TEST(MemoryNeed, TheMachineHasSome) { EXPECT_GT(machine_memory_bytes(), 1e6); }

}  // namespace
}  // namespace unbruised::studies
