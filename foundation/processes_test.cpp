#include "isobench/foundation/processes.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

namespace isobench {
namespace {

int start(const std::string& script) {
  const int pid = fork();
  if (pid == 0) {
    execl("/bin/sh", "sh", "-c", script.c_str(), nullptr);
    _exit(127);
  }
  return pid;
}

template <class Condition>
bool eventually(const Condition& condition) {
  for (int tries = 0; tries < 2000; ++tries) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST(Processes, DescendantsAreFoundThroughGenerationsAndAllKilled) {
  const int bystander = start("exec sleep 100");
  // A shell, a shell in a session of its own, and two programs of that one.
  const int family = start("setsid sh -c 'sleep 101 & sleep 102' & wait");
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
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
}

TEST(Processes, MemoryOfAProcessCountsThatOfItsChildren) {
  // The shell's child keeps ten megabytes of text in a variable.
  const int shell = start("sh -c 'x=$(head -c 10000000 /dev/zero | tr \"\\0\" x); sleep 100; echo ${#x}' & wait");
  MemoryWatch watch(shell);
  EXPECT_TRUE(eventually([&watch] { return watch.look() > 1e7; }));
  EXPECT_LT(peak_resident_bytes(shell), 1e7);
  EXPECT_GE(peak_resident_bytes(shell), resident_bytes(shell));
  kill_descendants(getpid());
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
  EXPECT_GT(watch.look(), 1e7) << "a peak stays";
  EXPECT_EQ(resident_bytes(shell), 0.0);
}

TEST(Processes, SignalsHaveNames) {
  EXPECT_EQ(signal_name(SIGSEGV), "SIGSEGV (Segmentation fault)");
  EXPECT_EQ(signal_name(12345), "signal 12345");
}

}  // namespace
}  // namespace isobench
