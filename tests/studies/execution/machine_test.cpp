#include "studies/execution/machine.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace unbruised::studies {
namespace {

using Files = std::vector<std::string>;

TEST(Machine, LooksAtTheGroupThatTheProcessIsInAndAtThoseAroundIt) {
  EXPECT_EQ(limit_files("0::/user.slice/job-7.scope\n", kMemoryLimit),
            (Files{"/sys/fs/cgroup/user.slice/job-7.scope/memory.max", "/sys/fs/cgroup/user.slice/memory.max",
                   "/sys/fs/cgroup/memory.max"}));
  EXPECT_EQ(limit_files("0::/\n", kCoreLimit), (Files{"/sys/fs/cgroup/cpu.max"}));
  EXPECT_EQ(limit_files("9:cpu,cpuacct:/a\n7:memory:/docker/x\n", kMemoryLimit),
            (Files{"/sys/fs/cgroup/memory/docker/x/memory.limit_in_bytes",
                   "/sys/fs/cgroup/memory/docker/memory.limit_in_bytes",
                   "/sys/fs/cgroup/memory/memory.limit_in_bytes"}));
  EXPECT_EQ(limit_files("9:cpu,cpuacct:/a\n7:memory:/docker/x\n", kCoreLimit),
            (Files{"/sys/fs/cgroup/cpu/a/cpu.cfs_quota_us", "/sys/fs/cgroup/cpu/cpu.cfs_quota_us"}));
  EXPECT_EQ(limit_files("no line of this kind", kMemoryLimit), Files{});
}

TEST(Machine, HasSomeMemoryAndACore) {
  EXPECT_GT(machine_memory_bytes(), 1e6);
  EXPECT_GE(usable_cores(), 1);
}

/// A tree of control groups below a folder of its own.
class FakeGroups : public ::testing::Test {
 protected:
  FakeGroups() { write("/proc/self/cgroup", "0::/\n"); }
  ~FakeGroups() override { std::filesystem::remove_all(root_); }
  FakeGroups(const FakeGroups&) = delete;
  FakeGroups& operator=(const FakeGroups&) = delete;

  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(root_ + path).parent_path());
    std::ofstream(root_ + path) << text;
  }

  const std::string root_ =
      (std::filesystem::temp_directory_path() / ("unbruised_groups_" + std::to_string(::getpid()))).string();
};

TEST_F(FakeGroups, OfACoreAndAHalfLeaveThatMuch) {
  write("/sys/fs/cgroup/cpu.max", "150000 100000\n");
  EXPECT_EQ(group_cores(root_), 1.5);
  EXPECT_LE(usable_cores(root_), 2);
}

TEST_F(FakeGroups, OfOneCoreStartOneThreadHoweverManyTheMachineHas) {
  write("/sys/fs/cgroup/cpu.max", "100000 100000\n");
  EXPECT_EQ(usable_cores(root_), 1);
  write("/sys/fs/cgroup/cpu.max", "5000 100000\n");
  EXPECT_EQ(usable_cores(root_), 1);
}

TEST_F(FakeGroups, AroundTheOwnGroupLimitToo) {
  write("/proc/self/cgroup", "0::/slice/job\n");
  write("/sys/fs/cgroup/slice/job/cpu.max", "max 100000\n");
  write("/sys/fs/cgroup/slice/cpu.max", "100000 50000\n");
  write("/sys/fs/cgroup/cpu.max", "800000 100000\n");
  EXPECT_EQ(group_cores(root_), 2.0);
}

TEST_F(FakeGroups, WithoutALimitLeaveWhatTheAffinityMaskLeaves) {
  EXPECT_TRUE(std::isinf(group_cores(root_)));
  write("/sys/fs/cgroup/cpu.max", "max 100000\n");
  EXPECT_TRUE(std::isinf(group_cores(root_)));
  EXPECT_EQ(usable_cores(root_), usable_cores("/nowhere"));
}

TEST_F(FakeGroups, OfTheFirstVersionHaveQuotaAndPeriodInTwoFiles) {
  write("/proc/self/cgroup", "4:cpu,cpuacct:/job\n");
  write("/sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "-1\n");
  write("/sys/fs/cgroup/cpu/job/cpu.cfs_period_us", "100000\n");
  EXPECT_TRUE(std::isinf(group_cores(root_)));
  write("/sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "300000\n");
  EXPECT_EQ(group_cores(root_), 3.0);
}

TEST_F(FakeGroups, WithFilesThatSayNothingLimitNothing) {
  for (const char* text : {"", "nonsense", "0 100000", "-5 100000", "100000", "100000 0"}) {
    write("/sys/fs/cgroup/cpu.max", text);
    EXPECT_TRUE(std::isinf(group_cores(root_))) << text;
  }
}

}  // namespace
}  // namespace unbruised::studies
