#include "isobench/foundation/processes/available_memory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

constexpr double gib = 1024.0 * 1024.0 * 1024.0;

TEST(AvailableMemory, IsThatOfTheMachineWithoutGroups) {
  const TestFolder folder;
  EXPECT_TRUE(std::isinf(available_memory(folder.path())));
  folder.write("proc/meminfo", "MemTotal:       16777216 kB\nMemAvailable:    8388608 kB\n");
  EXPECT_EQ(available_memory(folder.path()), 8.0 * gib);
}

TEST(AvailableMemory, IsWhatTheTightestGroupLeaves) {
  const TestFolder folder;
  folder.write("proc/meminfo", "MemAvailable:    8388608 kB\n");
  folder.write("proc/self/cgroup", "0::/jobs/mine\n");
  folder.write("sys/fs/cgroup/jobs/memory.max", "4294967296\n");
  folder.write("sys/fs/cgroup/jobs/memory.current", "3221225472\n");
  folder.write("sys/fs/cgroup/jobs/memory.stat", "anon 5\ninactive_file 1073741824\n");
  folder.write("sys/fs/cgroup/jobs/mine/memory.max", "max\n");
  folder.write("sys/fs/cgroup/jobs/mine/memory.current", "3221225472\n");
  EXPECT_EQ(available_memory(folder.path()), 2.0 * gib);
  folder.write("sys/fs/cgroup/jobs/mine/memory.max", "3221225473\n");
  EXPECT_EQ(available_memory(folder.path()), 1.0);
}

TEST(AvailableMemory, KnowsTheFirstVersionOfGroups) {
  const TestFolder folder;
  folder.write("proc/meminfo", "MemAvailable:    8388608 kB\n");
  folder.write("proc/self/cgroup", "5:cpuset:/\n4:cpu,memory:/job\n");
  folder.write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "1073741824\n");
  folder.write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "536870912\n");
  EXPECT_EQ(available_memory(folder.path()), 0.5 * gib);
}

TEST(AvailableMemory, OfThisProcessIsANumber) {
  EXPECT_GT(available_memory(), 1e6);
  EXPECT_LT(available_memory(), 1e15);
}

}  // namespace
}  // namespace isobench
