#include "isobench/foundation/processes/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <set>

#include "isobench/foundation/error.h"
#include "isobench/foundation/files/whole_files.h"
#include "isobench/foundation/processes/run_command.h"
#include "isobench/foundation/testing/eventually.h"
#include "isobench/foundation/testing/test_folder.h"
#include "isobench/foundation/testing/test_variable.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

const ChildOutput as_text{ChildOutput::To::text, {}};

ChildOptions shell(const std::string& script) { return {.words = {"sh", "-c", script}}; }

bool runs(int pid) { return resident_bytes(pid) > 0.0; }

/// The number that a script writes to a file, once it is there.
int number_in(const fs::path& file) {
  EXPECT_TRUE(eventually([&file] { return read_text_or_empty(file).ends_with('\n'); })) << file;
  return std::stoi(read_text(file));
}

fs::path executable(const TestFolder& folder, const std::string& name, const std::string& content) {
  fs::path path = folder.write(name, content);
  fs::permissions(path, fs::perms::owner_all);
  return path;
}

std::string error_of(const ChildOptions& options) {
  try {
    ChildProcess(options).wait();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ChildProcess, ItsEndIsKnown) {
  EXPECT_TRUE(ChildProcess(shell("exit 0")).wait().succeeded());
  ChildProcess child(shell("exit 7"));
  EXPECT_EQ(child.wait().code, 7);
  EXPECT_EQ(child.poll()->code, 7);
  EXPECT_EQ(child.pid(), -1);
  EXPECT_EQ(to_string(child.wait()), "ended with exit code 7");
  const ChildExit killed = ChildProcess(shell("kill -SEGV $$")).wait();
  EXPECT_EQ(killed.signal, SIGSEGV);
  EXPECT_FALSE(killed.succeeded());
  EXPECT_EQ(to_string(killed), "ended by SIGSEGV (Segmentation fault)");
}

TEST(ChildProcess, WordsReachTheProgramAsTheyAre) {
  const CommandOutput output = run_command({"printf", "%s|", "a b", "$HOME *", "'\"", ""});
  EXPECT_EQ(output.out, "a b|$HOME *|'\"||");
  EXPECT_EQ(run_command({"cat"}).out, "") << "there is nothing to read";
}

TEST(ChildProcess, BothStreamsAreReadHoweverLongTheyAre) {
  const CommandOutput output =
      run_command({"sh", "-c", "head -c 300000 /dev/zero; head -c 200000 /dev/zero >&2; echo out; echo err >&2"});
  EXPECT_EQ(output.out.size(), 300004U);
  EXPECT_EQ(output.err.size(), 200004U);
  EXPECT_TRUE(output.out.ends_with("out\n"));
  EXPECT_TRUE(output.err.ends_with("err\n"));
}

TEST(ChildProcess, StreamsGoToFiles) {
  const TestFolder folder;
  const fs::path log = folder.write("log.txt", "before\n");
  ChildOptions options = shell("echo out; echo err >&2");
  options.out = {ChildOutput::To::end_of_file, log};
  ChildProcess(options).wait();
  EXPECT_EQ(read_text(log), "before\nout\nerr\n");
  options.out = {ChildOutput::To::new_file, log};
  ChildProcess(options).wait();
  EXPECT_EQ(read_text(log), "out\nerr\n");
  options.err = ChildOutput{ChildOutput::To::new_file, folder.path() / "err.txt"};
  ChildProcess(options).wait();
  EXPECT_EQ(read_text(log), "out\n");
  EXPECT_EQ(read_text(folder.path() / "err.txt"), "err\n");
  options.out.file = folder.path() / "none" / "log.txt";
  EXPECT_NE(error_of(options).find("none/log.txt: cannot be opened: No such file"), std::string::npos);
}

TEST(ChildProcess, RunsInItsFolderWithItsVariables) {
  const TestFolder folder;
  const TestVariable kept("ISOBENCH_TEST_KEPT", "kept");
  const TestVariable replaced("ISOBENCH_TEST_REPLACED", "old");
  ChildOptions options = shell("pwd -P; echo $ISOBENCH_TEST_KEPT $ISOBENCH_TEST_REPLACED $ISOBENCH_TEST_ADDED");
  options.folder = folder.path();
  options.environment = {{"ISOBENCH_TEST_REPLACED", "new"}, {"ISOBENCH_TEST_ADDED", "a=b"}};
  options.out = as_text;
  ChildProcess child(options);
  child.wait();
  EXPECT_EQ(child.out(), fs::canonical(folder.path()).string() + "\nkept new a=b\n");
}

TEST(ChildProcess, ProgramsThatCannotBeStartedAreNamedWithTheReason) {
  const TestFolder folder;
  EXPECT_EQ(error_of({.words = {"no-such-program-here"}}),
            "there is no program 'no-such-program-here' in PATH; install it, or give its path");
  EXPECT_EQ(error_of({.words = {"no/such/program"}}), "there is no program 'no/such/program', or it is not executable");
  const std::string text = folder.write("text", "hello\n").string();
  EXPECT_EQ(error_of({.words = {text}}), "there is no program '" + text + "', or it is not executable");
  const std::string other = executable(folder, "other", "#!/no/such/interpreter\n").string();
  EXPECT_EQ(error_of({.words = {other}, .out = as_text}), other + " cannot be started: No such file or directory");
  ChildOptions nowhere = shell("exit 0");
  nowhere.folder = folder.path() / "none";
  EXPECT_NE(error_of(nowhere).find("sh cannot be started: No such file or directory"), std::string::npos);
}

TEST(ChildProcess, ProgramsAreFoundInThePath) {
  const TestFolder folder;
  folder.write("first/tool", "not executable");
  const fs::path tool = executable(folder, "second/tool", "#!/bin/sh\necho found\n");
  const TestVariable path("PATH", ":" + (folder.path() / "first").string() + ":" + tool.parent_path().string());
  EXPECT_EQ(find_program("tool"), tool);
  EXPECT_EQ(run_command({"tool"}).out, "found\n");
  EXPECT_TRUE(has_program("tool"));
  EXPECT_FALSE(has_program("sh"));
  EXPECT_FALSE(has_program("second"));
}

TEST(ChildProcess, ThePipeBringsWhatWasWrittenAndNeverBlocksTheChild) {
  ChildOptions options = shell("echo 0.5 half >&3; read line || echo 1 whole >&3");
  options.pipe = true;
  ChildProcess child(options);
  EXPECT_TRUE(child.wait().succeeded());
  EXPECT_EQ(child.take_from_pipe(), "0.5 half\n1 whole\n");
  EXPECT_EQ(child.take_from_pipe(), "");
  options = shell("head -c 1000000 /dev/zero >&3; exit 5");
  options.pipe = true;
  options.err = ChildOutput{ChildOutput::To::new_file, "/dev/null"};  // head complains
  EXPECT_EQ(ChildProcess(options).wait().code, 5) << "nobody reads, and yet it ends";
  EXPECT_EQ(ChildProcess(shell("exit 6")).take_from_pipe(), "") << "no pipe was asked for";
}

/// The files that a program keeps open while it sleeps. Before that, its start has its libraries open for a moment.
std::set<std::string> open_files(const ChildProcess& child) {
  const std::string folder = "/proc/" + std::to_string(child.pid());
  EXPECT_TRUE(eventually([&folder] {
    const std::string stat = read_text(folder + "/stat");
    return stat.substr(stat.rfind(')') + 2, 1) == "S";
  }));
  std::set<std::string> numbers;
  for (const auto& entry : fs::directory_iterator(folder + "/fd")) {
    numbers.insert(entry.path().filename().string());
  }
  return numbers;
}

TEST(ChildProcess, InheritsOnlyWhatTheOptionsAskFor) {
  const TestFolder folder;
  ChildOptions options{.words = {"sleep", "100"}};
  const ChildProcess plain(options);
  const std::set<std::string> usual = open_files(plain);
  options.out = as_text;
  options.err = ChildOutput{ChildOutput::To::new_file, folder.path() / "err.txt"};
  options.pipe = true;
  const ChildProcess full(options);
  std::set<std::string> with_pipe = usual;
  with_pipe.insert(std::to_string(ChildProcess::pipe_number));
  EXPECT_EQ(open_files(full), with_pipe);
  // This process now holds the other ends of the pipes; another child must not get them.
  EXPECT_EQ(open_files(ChildProcess({.words = {"sleep", "100"}})), usual);
}

TEST(ChildProcess, SigpipeEndsItEvenIfThisProcessIgnoresIt) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(ChildProcess(shell("kill -PIPE $$; exit 3")).wait().signal, SIGPIPE);
  std::signal(SIGPIPE, before);
}

TEST(ChildProcess, LeadsAGroupIfAskedToWhichEndsWithIt) {
  const TestFolder folder;
  const std::string left = (folder.path() / "left").string();
  ChildOptions options = shell("sleep 100 & echo $! >" + left + "; read line");
  options.own_group = true;
  {
    ChildProcess child(options);
    EXPECT_EQ(getpgid(child.pid()), child.pid());
    child.wait();
    const int pid = number_in(left);
    EXPECT_TRUE(eventually([pid] { return !runs(pid); }));
  }
  fs::remove(left);
  options.own_group = false;
  ChildProcess child(options);
  child.wait();
  const int pid = number_in(left);
  EXPECT_EQ(getpgid(pid), getpgrp());
  EXPECT_TRUE(runs(pid)) << "without a group it stays";
  kill(pid, SIGKILL);
}

TEST(ChildProcess, KillingTakesDescendantsAlong) {
  const TestFolder folder;
  const std::string file = (folder.path() / "pid").string();
  const auto start = [&] {
    fs::remove(file);
    ChildOptions options = shell("setsid sh -c 'echo $$ >" + file + "; sleep 100; true' & sleep 100; true");
    options.own_group = true;
    options.out = as_text;
    return ChildProcess(options);
  };
  ChildProcess child = start();
  const int grandchild = number_in(file);
  EXPECT_FALSE(child.poll());
  child.kill();
  EXPECT_EQ(child.poll()->signal, SIGKILL);
  EXPECT_FALSE(runs(grandchild));
  child.kill();
  child.signal(SIGTERM);  // to nobody
  int second = 0;
  int pid = 0;
  {
    const ChildProcess moved = start();
    second = number_in(file);
    pid = moved.pid();
    EXPECT_TRUE(runs(pid));
  }
  EXPECT_FALSE(runs(pid));
  EXPECT_FALSE(runs(second));
}

TEST(ChildProcess, MovingLeavesTheChildAlone) {
  ChildProcess first(shell("read line; exit 0"));
  const int pid = first.pid();
  {
    ChildProcess second(std::move(first));
    EXPECT_EQ(second.pid(), pid);
    EXPECT_TRUE(second.wait().succeeded());
  }
  EXPECT_EQ(first.pid(), -1);  // NOLINT(bugprone-use-after-move): tests its state after the move
}

TEST(ChildProcess, WaitingEndsWithTheChildOrAfterTheTime) {
  ChildProcess child(shell("exec sleep 100"));
  EXPECT_FALSE(child.wait_for(std::chrono::milliseconds(20)));
  EXPECT_GE(child.seconds(), 0.02);
  child.signal(SIGTERM);
  const std::optional<ChildExit> exit = child.wait_for(std::chrono::minutes(5));
  ASSERT_TRUE(exit);
  EXPECT_EQ(exit->signal, SIGTERM);
  EXPECT_LT(child.seconds(), 100.0);
}

TEST(ChildProcess, MemoryOfTheWholeFamilyIsSeen) {
  ChildProcess child(shell("sh -c 'x=$(head -c 20000000 /dev/zero | tr \"\\0\" x); sleep 100; echo ${#x}' & wait"));
  EXPECT_TRUE(eventually([&child] { return child.peak_memory_bytes() > 2e7; }));
  child.kill();
  EXPECT_GT(child.peak_memory_bytes(), 2e7) << "a peak stays";
  const ChildExit exit = ChildProcess(shell("x=$(head -c 20000000 /dev/zero | tr '\\0' x); exit 0")).wait();
  EXPECT_GT(exit.peak_memory_mb, 20.0);
}

/// Starts a child from a process that then ends without killing it.
void start_from_a_process_that_dies(const ChildOptions& options) {
  const pid_t parent = fork();
  if (parent == 0) {
    new ChildProcess(options);  // NOLINT: never destroyed, as in a process that is killed
    _exit(0);
  }
  waitpid(parent, nullptr, 0);
}

TEST(ChildProcess, DiesWithItsParentIfAskedTo) {
  const TestFolder folder;
  const fs::path file = folder.path() / "pid";
  start_from_a_process_that_dies(shell("echo $$ >" + file.string() + "; exec sleep 1000"));
  const int orphan = number_in(file);
  EXPECT_TRUE(runs(orphan)) << "without the option it goes on";
  kill(orphan, SIGKILL);
  // It may be killed before it can write its number, so it is found by its arguments.
  const std::string seconds = std::to_string(1000000 + getpid());
  start_from_a_process_that_dies({.words = {"sleep", seconds}, .dies_with_parent = true});
  const auto sleeps = [&seconds] {
    for (const auto& entry : fs::directory_iterator("/proc")) {
      if (read_text_or_empty(entry.path() / "cmdline").find(seconds) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(eventually([&sleeps] { return !sleeps(); }, std::chrono::seconds(20)));
}

TEST(ChildProcess, AStatusThatSomebodyElseTookIsNotWaitedFor) {
  ChildProcess child(shell("exit 3"));
  EXPECT_TRUE(eventually([] { return waitpid(-1, nullptr, WNOHANG) > 0; }));
  EXPECT_EQ(child.wait().code, -1);
  EXPECT_FALSE(child.wait().succeeded());
}

TEST(RunTool, LeavesALogAndTellsWhetherAllWentWell) {
  const TestFolder folder;
  EXPECT_TRUE(run_tool({"sh", "-c", "echo out; echo err >&2; echo here >file.txt"}, folder.path()));
  EXPECT_EQ(read_text(folder.path() / "log.txt"), "out\nerr\n");
  EXPECT_EQ(read_text(folder.path() / "file.txt"), "here\n");
  EXPECT_FALSE(run_tool({"sh", "-c", "exit 1"}, folder.path()));
  EXPECT_EQ(read_text(folder.path() / "log.txt"), "");
  EXPECT_FALSE(run_tool({"no-such-program-here"}, folder.path()));
  EXPECT_FALSE(run_tool({"sh", "-c", "exit 0"}, folder.path() / "none"));
}

}  // namespace
}  // namespace isobench
