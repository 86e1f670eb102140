#include "isobench/foundation/processes/process_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string>

#include "isobench/foundation/processes/child_process.h"
#include "isobench/foundation/testing/eventually.h"

namespace isobench {
namespace {

ChildProcess start(const std::string& script) { return ChildProcess({.words = {"sh", "-c", script}}); }

TEST(Processes, DescendantsAreFoundThroughGenerationsAndAllKilled) {
  const ChildProcess bystander_process = start("exec sleep 100");
  const int bystander = bystander_process.pid();
  // A shell, which starts a shell in a session of its own, which runs two programs.
  const ChildProcess family_process = start("setsid sh -c 'sleep 101 & sleep 102' & wait");
  const int family = family_process.pid();
  EXPECT_TRUE(eventually([family] { return descendants(family).size() >= 3; }));
  const std::vector<int> mine = descendants(getpid());
  EXPECT_NE(std::find(mine.begin(), mine.end(), bystander), mine.end());
  EXPECT_GE(mine.size(), 5U);
  const std::vector<int> of_family = descendants(family);
  kill_descendants(getpid(), {bystander});
  for (const int one : of_family) {
    // Gone, or dead and waiting for its parent to notice.
    EXPECT_TRUE(eventually([one] { return resident_bytes(one) == 0.0; })) << one;
  }
  EXPECT_GT(resident_bytes(bystander), 0.0);
  kill_descendants(getpid());
  EXPECT_EQ(resident_bytes(bystander), 0.0);
}

TEST(Processes, MemoryOfAProcessCountsThatOfItsChildren) {
  // The child of the shell keeps ten megabytes of text in a variable.
  const ChildProcess shell_process =
      start("sh -c 'x=$(head -c 10000000 /dev/zero | tr \"\\0\" x); sleep 100; echo ${#x}' & wait");
  const int shell = shell_process.pid();
  MemoryWatch watch(shell);
  EXPECT_TRUE(eventually([&watch] { return watch.look() > 1e7; }));
  EXPECT_LT(peak_resident_bytes(shell), 1e7);
  EXPECT_GE(peak_resident_bytes(shell), resident_bytes(shell));
  kill_descendants(getpid());
  EXPECT_GT(watch.look(), 1e7) << "a peak stays";
  EXPECT_EQ(resident_bytes(shell), 0.0);
}

TEST(Processes, SignalsHaveNames) {
  EXPECT_EQ(signal_name(SIGSEGV), "SIGSEGV (Segmentation fault)");
  EXPECT_EQ(signal_name(12345), "signal 12345");
}

}  // namespace
}  // namespace isobench
